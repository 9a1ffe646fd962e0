#pragma once
// Converts an evaluation of a search to the type of the public interface.

#include "armtune/tune.hpp"
#include "tuner/study/evaluation.hpp"

namespace armtune {

inline TunePoint tune_point(const internal::Evaluation& e) {
  return {e.x, e.objective, e.violation,
          e.engine == internal::Engine::kNative ? Engine::kNative : Engine::kSimbody, e.relative};
}

}  // namespace armtune
