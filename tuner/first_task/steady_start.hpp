#pragma once
// Loads a study, and replaces its start gains if they are unusable as the reference that tuned gains are
// compared with. They are unusable if, with them, the arm does not complete a scenario or a joint oscillates.

#include <string>

#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Reads a study like load_study, and simulates it with the file's start gains in armtune's own dynamics. If
/// the arm does not complete every scenario, or a joint oscillates (shake_watch.hpp), it computes other start
/// gains (first_gain_sets.hpp). If the arm completes all scenarios with the computed gains, and no joint
/// oscillates, these gains become the start gains of the study, and the study's `given` has the file's gains.
/// Otherwise the study is returned as its file gives it. workers: number of threads (>= 1). Throws InputError
/// like load_study. Also throws InputError if the arm completes the study only with the computed gains, but
/// the study does not allow these.
Study load_steady_study(const std::string& name_or_path, const std::string& controller, int workers);

}  // namespace armtune::internal
