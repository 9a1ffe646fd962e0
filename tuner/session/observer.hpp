#pragma once
// The interface through which a session (the work of one command) reports progress and warnings to its
// caller: the command line, Python or a test. A session itself prints nothing.

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "armtune/progress.hpp"

namespace armtune::internal {

/// An observer of a session. A session calls it from any thread, one call at a time. Some sessions report
/// further events. Their headers declare derived classes for these events, such as TuneObserver.
class SessionObserver {
 public:
  SessionObserver() = default;
  virtual ~SessionObserver() = default;
  SessionObserver(const SessionObserver&) = delete;
  SessionObserver& operator=(const SessionObserver&) = delete;

  virtual void progressed(const Progress& /*progress*/) {}
  /// Called when a part of the work is finished, so that no more progress of this part will be reported.
  virtual void part_is_over() {}
  /// Called with a warning as one sentence. The run continues.
  virtual void warned(const std::string& /*sentence*/) {}
  /// Called when the run fails and can be resumed, because everything completed is kept in its folder.
  virtual void can_resume(const std::string& /*folder*/) {}
};

/// Returns a function (done, all) that reports the progress of `work` to the observer. The observer must
/// outlive the function.
inline std::function<void(std::size_t, std::size_t)> progress_of(SessionObserver& observer,
                                                                 std::string work) {
  return [&observer, work = std::move(work)](std::size_t done, std::size_t all) {
    observer.progressed({work, static_cast<long>(done), static_cast<long>(all)});
  };
}

}  // namespace armtune::internal
