#pragma once
// How a search gives up candidates that can make no difference to it.

#include <optional>

#include "tuner/study/study.hpp"
#include "tuner/workers/outdone.hpp"

namespace armtune {

/// By objective and penalties, as far as they are known while a candidate's rollouts go on. None where the
/// study does not want it, where a search sees constraints apart from the objective, where samples are
/// folded, or where nothing of what a candidate costs is known before its only rollout ends. `objective` must
/// outlive it.
std::optional<Outdone> giving_up(const Study& study, const std::optional<Objective>& objective);

}  // namespace armtune
