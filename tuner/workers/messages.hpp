#pragma once
// Encodes and decodes the messages between the MPI ranks of a run. A message is a string of bytes that begins
// with the kind of the message.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/rollout/rollout.hpp"
#include "tuner/workers/rollout_plan.hpp"

namespace armtune::internal {

enum class MessageKind : std::uint64_t {
  kHello,    ///< to rank 0: the host, and all facts that must be the same in every rank
  kGo,       ///< from rank 0: all ranks agree, jobs follow
  kJob,      ///< from rank 0: a job
  kStop,     ///< from rank 0: interrupt the jobs up to this number
  kResult,   ///< to rank 0: the result of a job
  kFailure,  ///< to rank 0: the job threw an exception
  kBye,      ///< from rank 0: no more messages; the exit code of all ranks
  kLeaving   ///< to rank 0: answer to kBye, the rank's last message
};

/// The data that a rank sends before the work begins.
struct Hello {
  std::string host;
  std::string failure;  ///< why the rank has no plan; empty if it has one
  std::vector<std::pair<std::string, std::string>> facts;
};

/// A job with the data that a rank needs to do it.
struct NumberedJob {
  std::uint64_t number = 0;  ///< number of the job among the jobs of this rank
  std::uint64_t pool = 0;    ///< number of the pool; the rank makes a new worker for each pool
  std::uint64_t share = 1;   ///< largest number of jobs that the rank gets at the same time
  RolloutJob job;
};

MessageKind kind_of(const std::string& message);

std::string plain_message(MessageKind kind);  ///< for kGo and kLeaving
std::string hello_message(const Hello& hello);
std::string job_message(const NumberedJob& job);
std::string stop_message(std::uint64_t number);
std::string result_message(std::uint64_t number, const RolloutResult& result);
std::string failure_message(std::uint64_t number, const std::string& what);
std::string bye_message(int exit_code);

// These functions throw FailedError if the message is of another kind, too short or too long.
Hello read_hello(const std::string& message);
NumberedJob read_job(const std::string& message);
std::uint64_t read_stop(const std::string& message);
std::pair<std::uint64_t, RolloutResult> read_result(const std::string& message);
std::pair<std::uint64_t, std::string> read_failure(const std::string& message);
int read_bye(const std::string& message);

}  // namespace armtune::internal
