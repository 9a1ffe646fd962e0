#pragma once
// Passes the progress and the warnings of long internal computations (sessions) on to the callbacks that a
// user of the public interface gives (Watch in armtune/progress.hpp).

#include "armtune/progress.hpp"
#include "tuner/session/observer.hpp"

namespace armtune {

/// An observer of any kind of session. Observer: SessionObserver, or a class derived from it. The Watch must
/// outlive it.
template <class Observer>
class Observing : public Observer {
 public:
  explicit Observing(const Watch& watch) : watch_(watch) {}
  void progressed(const Progress& progress) override {
    if (watch_.progress) watch_.progress(progress);
  }
  void warned(const std::string& sentence) override {
    if (watch_.warning) watch_.warning(sentence);
  }

 private:
  const Watch& watch_;
};

}  // namespace armtune
