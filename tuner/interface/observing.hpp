#pragma once
// An observer that passes the reports of a session on to a Watch of the public interface.

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
