#pragma once
// What ranks say to each other, as bytes. Every message begins with its kind.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/rollout/rollout.hpp"
#include "tuner/workers/rollout_plan.hpp"

namespace armtune::internal {

enum class MessageKind : std::uint64_t {
  kHello,    ///< to rank 0: who, and everything that has to be the same everywhere
  kGo,       ///< from rank 0: all are the same, jobs follow
  kJob,      ///< from rank 0
  kStop,     ///< from rank 0: interrupt the jobs up to that number
  kResult,   ///< to rank 0
  kFailure,  ///< to rank 0: the job threw
  kBye,      ///< from rank 0: nothing follows, and the exit code of all
  kLeaving   ///< to rank 0: the answer to kBye, the rank's last message
};

/// A rank before the work.
struct Hello {
  std::string host;
  std::string failure;  ///< why the rank has no plan; empty if it has one
  std::vector<std::pair<std::string, std::string>> facts;
};

/// A job under way.
struct NumberedJob {
  std::uint64_t number = 0;  ///< of this rank's jobs
  std::uint64_t pool = 0;    ///< a worker makes its plants anew for another pool
  std::uint64_t share = 1;   ///< jobs that the rank is given at once, at most
  RolloutJob job;
};

MessageKind kind_of(const std::string& message);

std::string plain_message(MessageKind kind);  ///< kGo, kLeaving
std::string hello_message(const Hello& hello);
std::string job_message(const NumberedJob& job);
std::string stop_message(std::uint64_t number);
std::string result_message(std::uint64_t number, const RolloutResult& result);
std::string failure_message(std::uint64_t number, const std::string& what);
std::string bye_message(int exit_code);

// Each throws FailedError if the message is of another kind, too short or too long.
Hello read_hello(const std::string& message);
NumberedJob read_job(const std::string& message);
std::uint64_t read_stop(const std::string& message);
std::pair<std::uint64_t, RolloutResult> read_result(const std::string& message);
std::pair<std::uint64_t, std::string> read_failure(const std::string& message);
int read_bye(const std::string& message);

}  // namespace armtune::internal
