#pragma once
// Loads studies. If the arm does not complete a scenario with a study's own start gains, or shakes, these
// gains cannot serve as a reference, and others replace them.

#include <string>

#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Reads a study like load_study, and simulates it with the file's start gains in armtune's own dynamics. If
/// the arm does not complete every scenario, or shakes (shake_watch.hpp), it tries armtune's first gains. If
/// the arm completes all scenarios with these and does not shake, the study begins with them, and its
/// `given` has the file's gains. Otherwise the study is as its file says. workers: threads (>= 1). Throws
/// InputError like load_study, and if only first gains complete the study, but its bounds exclude them.
Study load_steady_study(const std::string& name_or_path, const std::string& controller, int workers);

}  // namespace armtune::internal
