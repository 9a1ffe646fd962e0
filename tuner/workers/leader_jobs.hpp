#pragma once
// Receives the rollouts (jobs) that rank 0 sends to this MPI rank, and passes them to this rank's worker.
// Several jobs can be under way at once.

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <string>

#include "tuner/ranks/transport.hpp"
#include "tuner/workers/messages.hpp"
#include "tuner/workers/rollout_worker.hpp"

namespace armtune::internal {

class LeaderJobs final : public JobSource {
 public:
  /// first: the message with the first job. others: If a message arrives that is neither a job of the same
  /// pool (RolloutPool) nor an order to stop, it is appended to this list, and the work ends.
  LeaderJobs(Transport& transport, const std::string& first, std::deque<std::string>& others);

  std::uint64_t pool() const { return pool_; }

  std::size_t share() const override { return share_; }
  std::optional<GivenJob> next() override;
  bool stopped() override;
  void finished(std::size_t number, RolloutResult&& result) override;
  /// Sends the result "interrupted" for every job that has arrived and is not finished.
  void interrupt();
  /// Reports to rank 0 that the worker failed. No more results will follow. what: the reason.
  void fail(const std::string& what);

 private:
  void look();
  void take(NumberedJob&& job);

  Transport& transport_;
  std::deque<std::string>& others_;
  std::uint64_t pool_ = 0;
  std::size_t share_ = 1;
  std::map<std::uint64_t, RolloutJob> open_;  ///< jobs that have arrived and are not finished, by number
  std::deque<std::uint64_t> waiting_;         ///< numbers of the open jobs that were not started yet
  std::uint64_t last_ = 0;                    ///< number of the last job that arrived
  bool stopped_ = false;
  std::chrono::steady_clock::time_point looked_ = std::chrono::steady_clock::now();
};

}  // namespace armtune::internal
