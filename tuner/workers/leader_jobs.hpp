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
  /// first: the first job message. others: receives a message that arrives during the work and is not a job
  /// of the same pool. Such a message ends the work.
  LeaderJobs(Transport& transport, const std::string& first, std::deque<std::string>& others);

  std::uint64_t pool() const { return pool_; }

  std::size_t share() const override { return share_; }
  std::optional<GivenJob> next() override;
  bool stopped() override;
  void finished(std::size_t number, RolloutResult&& result) override;
  /// Answers every job that has arrived and is not finished as interrupted.
  void interrupt();
  /// Reports that the worker failed and that no more results will follow.
  void fail(const std::string& what);

 private:
  void look();
  void take(NumberedJob&& job);

  Transport& transport_;
  std::deque<std::string>& others_;
  std::uint64_t pool_ = 0;
  std::size_t share_ = 1;
  std::map<std::uint64_t, RolloutJob> open_;  ///< by number: arrived and not finished
  std::deque<std::uint64_t> waiting_;         ///< of those, not handed out yet
  std::uint64_t last_ = 0;                    ///< number of the last one that arrived
  bool stopped_ = false;
  std::chrono::steady_clock::time_point looked_ = std::chrono::steady_clock::now();
};

}  // namespace armtune::internal
