#pragma once
// Studies whose own start gains cannot be a reference, since the arm does not complete a scenario with them,
// or shakes.

#include <string>

#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Reads a study as load_study does. Where the arm does not complete every scenario with the file's start
/// gains, in armtune's own dynamics, or shakes (shake_watch.hpp), but completes them without shaking with
/// first gains of armtune's, the study begins with these, and its `given` has the file's. Else the study is
/// as its file says. workers: threads (>= 1). Throws InputError as load_study does, and if the file's gains
/// do not complete it and first gains would, which the study's bounds do not allow.
Study load_steady_study(const std::string& name_or_path, const std::string& controller, int workers);

}  // namespace armtune::internal
