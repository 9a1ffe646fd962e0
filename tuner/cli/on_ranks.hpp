#pragma once
// Runs a command in one process, or in several MPI processes (ranks) that mpirun or srun started. Also
// refuses several ranks for commands that cannot use them.

#include <exception>
#include <functional>
#include <string>

#include "tuner/workers/rank_group.hpp"

namespace armtune::internal::cli {

/// Runs `program` in this process alone, or in each of the ranks that mpirun or srun started. Returns the
/// exit code of the run, which is the same in every rank. If ranks were started with different command lines,
/// they end before they call `program`. In `program`, a command that uses ranks calls team().begin. If that
/// call returns false, the command must return kDone. Only rank 0 prints.
int on_ranks(const std::string& command_line, const std::function<int()>& program);

/// Returns the group of ranks of this run. To be called only inside the `program` of on_ranks.
RankGroup& team();

/// Throws InputError if several ranks were started for a command that does not use them, or if srun started
/// several tasks without MPI.
void refuse_ranks(const std::string& command);

/// Prints an error on stderr and returns the exit code. Ranks other than 0 print nothing and return kDone.
/// The reason is that mpirun ends all ranks once one of them fails, and rank 0 must print its message first.
/// An error that occurs before the ranks are connected occurs in rank 0 too, which then prints it.
int report(const std::exception_ptr& failure);

/// Help texts of --workers and --rollout-deadline.
inline constexpr const char* kWorkersHelp =
    "number of worker threads; results do not depend on it. Under mpirun or srun every rank is one worker";
/// Default of --workers as --help shows it. It does not depend on this machine.
inline constexpr const char* kWorkersDefault = "one per processor";
inline constexpr const char* kDeadlineHelp =
    "wall-clock time limit of one rollout (the simulation of one scenario) [s]; beyond it the run ends with "
    "an error";
/// Help text of --rollout-deadline in commands that simulate each scenario independently.
inline constexpr const char* kScenarioDeadlineHelp =
    "wall-clock time limit of one scenario [s]; beyond it the scenario is interrupted";
/// Default of --rollout-deadline as --help shows it.
inline constexpr const char* kDeadlineDefault = "20, plus 2 per simulated second";
/// Help text and default of the option --limit. Each of its values is the limit of one metric.
inline constexpr const char* kLimitHelp =
    "limit that every rollout must keep: METRIC<=VALUE or METRIC>=VALUE; may be repeated";
inline constexpr const char* kLimitDefault =
    "the arm's limits of velocity, position and, if its file has them, acceleration; "
    "and no contact of the arm with itself, its cell or obstacles";

}  // namespace armtune::internal::cli
