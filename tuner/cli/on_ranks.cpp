#include "tuner/cli/on_ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "core/common/error.hpp"
#include "tuner/cli/commands.hpp"

namespace armtune::cli {
namespace {

constexpr std::array<std::string_view, 4> kUsers = {"tune", "pareto", "robustness", "sensitivity"};

std::string what_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& e) {
    return e.what();
  }
}

int lead(Team& team, const std::function<int(Team&)>& command) {
  int exit_code = kDone;
  try {
    exit_code = command(team);
  } catch (...) {
    exit_code = report(std::current_exception());
  }
  std::fflush(stdout);
  try {
    if (team.end()) return exit_code;
  } catch (...) {
    report(std::current_exception());
  }
  team.abort(exit_code == kDone ? kFailed : exit_code);
  return exit_code;
}

}  // namespace

int report(const std::exception_ptr& failure) {
  // mpirun ends all ranks as soon as one fails: rank 0 has to come to speak.
  if (rank_place().rank != 0) return kDone;
  try {
    std::rethrow_exception(failure);
  } catch (const InputError& e) {
    fmt::print(stderr, "armtune: {}\n", e.what());
    return kBadInput;
  } catch (const std::exception& e) {
    fmt::print(stderr, "armtune: failed: {}\n", e.what());
    return kFailed;
  }
}

int on_ranks(const std::function<int(Team&)>& command) {
  if (rank_place().size == 1) {
    Team alone(nullptr);
    return command(alone);
  }
  Team team(begin_mpi());
  if (team.leads()) return lead(team, command);
  std::exception_ptr failure;
  try {
    return command(team);
  } catch (...) {
    failure = std::current_exception();
  }
  team.fail(what_of(failure));
  return kDone;
}

void refuse_ranks(const std::string& command) {
  if (const int tasks = strangers(); tasks > 0) {
    throw InputError(fmt::format(
        "srun started {} tasks that know nothing of each other, and each would do the whole run: use srun "
        "--mpi=pmix, or one task and --workers",
        tasks));
  }
  if (rank_place().size == 1 || std::find(kUsers.begin(), kUsers.end(), command) != kUsers.end()) return;
  throw InputError(
      fmt::format("{} does not use ranks ({} were started): run it without mpirun or srun; {} do", command,
                  rank_place().size, fmt::join(kUsers, ", ")));
}

}  // namespace armtune::cli
