#pragma once
// What a session tells, handed on to a Watch.

#include "armtune/progress.hpp"
#include "tuner/session/observer.hpp"

namespace armtune {

/// Observer: SessionObserver, or a class derived from it. The Watch outlives it.
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
