#pragma once
// Commands whose rollouts may be done by several processes, and those that may not.

#include <exception>
#include <functional>
#include <string>

#include "tuner/workers/rank_group.hpp"

namespace armtune::internal::cli {

/// Runs the program in this process alone, or among the ranks that mpirun or srun started, and gives its exit
/// code, the same in every rank. Ranks that were started with different command lines end before they call
/// `program`. A command that uses ranks calls team().begin and returns kDone where that is false. Only rank 0
/// prints.
int on_ranks(const std::string& command_line, const std::function<int()>& program);

/// The processes of this run, for the command that on_ranks has called.
RankGroup& team();

/// Throws InputError if several ranks were started for a command that does not use them, or several tasks
/// that are no ranks.
void refuse_ranks(const std::string& command);

/// Prints what went wrong and gives the exit code. Ranks but 0 are silent: before they could speak to rank 0,
/// all of them see the same.
int report(const std::exception_ptr& failure);

/// What --help says of --workers and --rollout-deadline.
inline constexpr const char* kWorkersHelp =
    "threads; results do not depend on it. Under mpirun or srun every rank is one worker";
/// Its default as --help says it: not this machine's number.
inline constexpr const char* kWorkersDefault = "one per processor";
inline constexpr const char* kDeadlineHelp =
    "wall clock seconds one rollout may take before the run ends with an error (default: 20, and 2 per "
    "simulated second)";
/// Of commands whose scenarios stand each for itself.
inline constexpr const char* kScenarioDeadlineHelp =
    "wall clock seconds one scenario may take before it is called interrupted (default: 20, and 2 per "
    "simulated "
    "second)";

}  // namespace armtune::internal::cli
