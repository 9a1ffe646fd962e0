#pragma once
// What a session tells while it works, to whoever runs it: the command line, Python, a test. A session
// itself prints nothing.

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "armtune/progress.hpp"

namespace armtune::internal {

/// A session calls these from any thread, one call at a time. Sessions of some kinds tell more: see the class
/// derived from this one beside them.
class SessionObserver {
 public:
  SessionObserver() = default;
  virtual ~SessionObserver() = default;
  SessionObserver(const SessionObserver&) = delete;
  SessionObserver& operator=(const SessionObserver&) = delete;

  virtual void progressed(const Progress& /*progress*/) {}
  /// The part that progressed() told of is over.
  virtual void part_is_over() {}
  /// Something is not as it should be, and the run continues: one sentence.
  virtual void warned(const std::string& /*sentence*/) {}
  /// The run fails, and what was finished is kept in its folder: it can be resumed.
  virtual void can_resume(const std::string& /*folder*/) {}
};

/// Returns a function (done, all) that tells the observer how far `work` is. The observer outlives it.
inline std::function<void(std::size_t, std::size_t)> progress_of(SessionObserver& observer,
                                                                 std::string work) {
  return [&observer, work = std::move(work)](std::size_t done, std::size_t all) {
    observer.progressed({work, static_cast<long>(done), static_cast<long>(all)});
  };
}

}  // namespace armtune::internal
