#include "tuner/workers/leader_jobs.hpp"

namespace armtune::internal {

LeaderJobs::LeaderJobs(Transport& transport, const std::string& first, std::deque<std::string>& others)
    : transport_(transport), others_(others) {
  NumberedJob job = read_job(first);
  pool_ = job.pool;
  take(std::move(job));
}

void LeaderJobs::take(NumberedJob&& job) {
  share_ = job.share;
  last_ = job.number;
  waiting_.push_back(job.number);
  open_.emplace(job.number, std::move(job.job));
}

void LeaderJobs::look() {
  while (!stopped_) {
    auto message = transport_.receive(0);
    if (!message) return;
    if (kind_of(*message) == MessageKind::kStop) {
      stopped_ = read_stop(*message) >= last_;  // otherwise its jobs were done already
      continue;
    }
    if (kind_of(*message) == MessageKind::kJob) {
      NumberedJob job = read_job(*message);
      if (job.pool == pool_) {
        take(std::move(job));
        continue;
      }
    }
    others_.push_back(std::move(*message));
    stopped_ = true;
  }
}

std::optional<GivenJob> LeaderJobs::next() {
  look();
  if (stopped_ || waiting_.empty()) return std::nullopt;
  const std::uint64_t number = waiting_.front();
  waiting_.pop_front();
  return GivenJob{number, open_.at(number)};
}

bool LeaderJobs::stopped() {
  constexpr std::chrono::milliseconds kBetween(1);
  const auto now = std::chrono::steady_clock::now();
  if (now - looked_ >= kBetween) {
    looked_ = now;
    look();
  }
  return stopped_;
}

void LeaderJobs::finished(std::size_t number, RolloutResult&& result) {
  transport_.send(0, result_message(number, result));
  open_.erase(number);
}

void LeaderJobs::interrupt() {
  RolloutResult interrupted;
  interrupted.status = RolloutStatus::kInterrupted;
  for (const auto& [number, job] : open_) transport_.send(0, result_message(number, interrupted));
  open_.clear();
}

void LeaderJobs::fail(const std::string& what) {
  transport_.send(0, failure_message(open_.empty() ? last_ : open_.begin()->first, what));
  open_.clear();
}

}  // namespace armtune::internal
