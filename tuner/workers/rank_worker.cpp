// The jobs of another rank, as rank 0 sees them. Rank 0 sends them and waits for the results. It fails if the
// rank does not even answer after its own deadline.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "armtune/error.hpp"
#include "sim/lanes/arm_lanes.hpp"
#include "tuner/ranks/patience.hpp"
#include "tuner/workers/messages.hpp"
#include "tuner/workers/rank_group.hpp"

namespace armtune::internal {
namespace {

/// Time for which rank 0 waits beyond the deadline of a rank [s]. The rank itself reports within a control
/// period that its deadline has passed.
constexpr double kGrace = 5.0;

class RankWorker final : public RolloutWorker {
 public:
  RankWorker(Transport& transport, Peer& peer, std::uint64_t pool, const RolloutPlan& plan,
             const Notice& notice)
      : transport_(transport), peer_(peer), pool_(pool), plan_(plan), notice_(notice) {}

  void work(JobSource& jobs) override {
    open_.clear();
    bool told = false;
    for (Patience patience;; patience.sleep()) {
      send(jobs);
      if (open_.empty()) return;
      while (const auto message = transport_.receive(peer_.rank)) {
        take(*message, jobs);
        patience = Patience();
      }
      if (open_.empty()) continue;
      if (jobs.stopped() && !told) {
        transport_.send(peer_.rank, stop_message(peer_.jobs));
        told = true;
        patience = Patience();
      }
      const double seconds = patience.seconds();
      const double limit = (told ? 0.0 : longest()) + kGrace;
      if (seconds > limit) throw hung(seconds);
      say_waiting(peer_, seconds, what(), limit, notice_);
    }
  }

 private:
  /// Sends as many jobs as this process could simulate side by side, but no more than the rank's share. A
  /// rank with wider vector registers simulates as many at once. A rank with narrower ones simulates some of
  /// them afterwards. Its deadline is never multiplied by more arms than in longest().
  void send(JobSource& jobs) {
    while (open_.empty() || open_.size() < most_) {
      std::optional<GivenJob> one = jobs.next();
      if (!one) return;
      const auto lanes = static_cast<std::size_t>(most_lanes(best_processor()));
      most_ = one->job.engine == Engine::kNative ? std::clamp<std::size_t>(jobs.share(), 1, lanes) : 1;
      const std::uint64_t number = ++peer_.jobs;
      transport_.send(peer_.rank, job_message({number, pool_, most_, one->job}));
      open_.emplace(number, std::move(*one));
    }
  }

  void take(const std::string& message, JobSource& jobs) {
    if (kind_of(message) == MessageKind::kFailure) {
      const auto [failed, what] = read_failure(message);
      throw FailedError(fmt::format("rank {} on {}{}: {}", peer_.rank, peer_.host,
                                    open_.contains(failed) ? "" : fmt::format(", job {}", failed), what));
    }
    auto [answered, result] = read_result(message);
    const auto of = open_.find(answered);
    if (of == open_.end()) {
      throw FailedError(fmt::format("rank {} on {} answered job {}, which it was not given", peer_.rank,
                                    peer_.host, answered));
    }
    const std::size_t number = of->second.number;
    open_.erase(of);
    jobs.finished(number, std::move(result));
  }

  /// Returns the time within which the rank finishes one of its open jobs, or reports that it is late [s].
  double longest() const {
    double seconds = 0.0;
    for (const auto& [number, one] : open_) {
      seconds = std::max(seconds, deadline_of(plan_.deadline, plan_.scenarios[one.job.scenario]));
    }
    return static_cast<double>(most_) * seconds;
  }

  /// Returns the name of the oldest open job, for messages.
  std::string what() const {
    const RolloutJob& oldest = open_.begin()->second.job;
    return plan_.scenarios[oldest.scenario].name +
           (plan_.draw ? fmt::format(", sample {}", oldest.sample) : std::string());
  }

  FailedError hung(double seconds) {
    peer_.lost = true;
    return FailedError(fmt::format(
        "rank {} on {} has not answered for {:.0f} s ({}); it hangs: a rank that is only slow reports after "
        "{} s that its --rollout-deadline has passed",
        peer_.rank, peer_.host, seconds, what(), longest()));
  }

  Transport& transport_;
  Peer& peer_;
  std::uint64_t pool_;
  const RolloutPlan& plan_;
  const Notice& notice_;
  std::map<std::uint64_t, GivenJob> open_;  ///< jobs without an answer, by their number in the rank
  std::size_t most_ = 1;                    ///< largest number of open jobs
};

}  // namespace

std::unique_ptr<RolloutWorker> rank_worker(Transport& transport, Peer& peer, std::uint64_t pool,
                                           const RolloutPlan& plan, const Notice& notice) {
  return std::make_unique<RankWorker>(transport, peer, pool, plan, notice);
}

}  // namespace armtune::internal
