#include "tuner/cli/on_ranks.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <new>
#include <string_view>

#include "armtune/error.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"

namespace armtune::internal::cli {
namespace {

constexpr std::array<std::string_view, 4> kUsers = {"tune", "pareto", "robustness", "sensitivity"};

std::string what_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& e) {
    return e.what();
  }
}

/// The group of ranks of this run. It is global, because the parser passes only options to a command.
RankGroup*& current_team() {
  static RankGroup* team = nullptr;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
  return team;
}

/// Prints a line on stderr. On a terminal it replaces the progress line, which then appears again below.
void say_while_running(const std::string& what) {
  const std::string line = (::isatty(STDERR_FILENO) == 1 ? "\r\033[Karmtune: " : "armtune: ") + what + '\n';
  std::fputs(line.c_str(), stderr);
}

int lead(RankGroup& team, const std::string& command_line, const std::function<int()>& program) {
  int exit_code = kDone;
  try {
    team.call_roll(command_line);
    exit_code = program();
  } catch (...) {
    exit_code = report(std::current_exception());
  }
  std::fflush(stdout);
  // If another rank ends first with this exit code, the launcher may send signals to this rank. They are
  // ignored, because nothing is left to save.
  ignore_interrupts();
  try {
    if (team.end(exit_code)) return exit_code;
  } catch (...) {
    report(std::current_exception());
  }
  team.abort(exit_code == kDone ? kFailed : exit_code);
  return exit_code;
}

int follow(RankGroup& team, const std::string& command_line, const std::function<int()>& program) {
  std::string failure = "it ended before the work began";
  try {
    if (team.call_roll(command_line)) program();
  } catch (...) {
    failure = what_of(std::current_exception());
  }
  if (!team.left()) team.fail(failure);
  return team.exit_code();
}

}  // namespace

int report(const std::exception_ptr& failure) {
  // mpirun ends all ranks as soon as one fails, but rank 0 must print its message first.
  if (rank_place().rank != 0) return kDone;
  try {
    std::rethrow_exception(failure);
  } catch (const InputError& e) {
    fmt::print(stderr, "armtune: {}\n", e.what());
    return stop_requested() ? kInterrupted : kBadInput;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr,
               "armtune: failed: not enough memory; provide more, or use fewer --workers or smaller "
               "inputs\n");
  } catch (const std::exception& e) {
    fmt::print(stderr, "armtune: failed: {}\n", e.what());
  }
  return kFailed;
}

int on_ranks(const std::string& command_line, const std::function<int()>& program) {
  const bool alone = rank_place().size == 1;
  RankGroup team(alone ? nullptr : begin_mpi(say_while_running), say_while_running);
  current_team() = &team;
  if (alone) return program();
  return team.leads() ? lead(team, command_line, program) : follow(team, command_line, program);
}

RankGroup& team() {
  return *current_team();
}

void refuse_ranks(const std::string& command) {
  if (const int tasks = strangers(); tasks > 0) {
    throw InputError(fmt::format(
        "srun started {} tasks without MPI, and each task would do the whole run; use srun --mpi=pmix, or "
        "one task with --workers",
        tasks));
  }
  if (rank_place().size == 1 || std::find(kUsers.begin(), kUsers.end(), command) != kUsers.end()) return;
  throw InputError(
      fmt::format("{} does not use MPI ranks, but {} ranks were started; run it without mpirun or srun. Only "
                  "{} use ranks",
                  command, rank_place().size, fmt::join(kUsers, ", ")));
}

}  // namespace armtune::internal::cli
