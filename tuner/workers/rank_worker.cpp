// A rank's job, as rank 0 sees it: sent, waited for, given up when even the rank's own deadline is past.

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tuner/workers/messages.hpp"
#include "tuner/workers/patience.hpp"
#include "tuner/workers/team.hpp"

namespace armtune {
namespace {

/// Past its deadline a rank says so within a control period. [s]
constexpr double kGrace = 5.0;

class RankWorker final : public Worker {
 public:
  RankWorker(Transport& transport, Peer& peer, std::uint64_t crew, const RolloutPlan& plan)
      : transport_(transport), peer_(peer), crew_(crew), plan_(plan) {}

  RolloutResult run(const RolloutJob& job, const std::atomic<bool>& stop) override {
    const std::uint64_t number = ++peer_.jobs;
    transport_.send(peer_.rank, job_message({number, crew_, job}));
    const Scenario& scenario = plan_.scenarios[job.scenario];
    double limit = deadline_of(plan_, scenario) + kGrace;
    bool told = false;
    for (Patience patience;; patience.sleep()) {
      if (const auto message = transport_.receive(peer_.rank)) return answer(*message, number);
      if (stop && !told) {
        transport_.send(peer_.rank, stop_message(number));
        limit = std::min(limit, patience.seconds() + kGrace);
        told = true;
      }
      if (patience.seconds() <= limit) continue;
      peer_.lost = true;
      throw std::runtime_error(fmt::format(
          "rank {} on {} gave no answer for {:.0f} s to {}{}: it hangs (a slow one says so after {} s, "
          "its --rollout-deadline)",
          peer_.rank, peer_.host, patience.seconds(), scenario.name,
          plan_.draw ? fmt::format(", sample {}", job.sample) : "", deadline_of(plan_, scenario)));
    }
  }

 private:
  RolloutResult answer(const std::string& message, std::uint64_t number) const {
    if (kind_of(message) == MessageKind::kFailure) {
      const auto [failed, what] = read_failure(message);
      throw std::runtime_error(fmt::format("rank {} on {}{}: {}", peer_.rank, peer_.host,
                                           failed == number ? "" : fmt::format(", job {}", failed), what));
    }
    auto [answered, result] = read_result(message);
    if (answered != number) {
      throw std::runtime_error(
          fmt::format("rank {} on {} answered job {}, not {}", peer_.rank, peer_.host, answered, number));
    }
    return std::move(result);
  }

  Transport& transport_;
  Peer& peer_;
  std::uint64_t crew_;
  const RolloutPlan& plan_;
};

}  // namespace

std::unique_ptr<Worker> rank_worker(Transport& transport, Peer& peer, std::uint64_t crew,
                                    const RolloutPlan& plan) {
  return std::make_unique<RankWorker>(transport, peer, crew, plan);
}

}  // namespace armtune
