#include "tuner/evaluation/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armtune/error.hpp"
#include "tuner/evaluation/simulate_points.hpp"

namespace armtune::internal {

Evaluator::Evaluator(const Study& study, CandidateRunner& workers, const std::atomic<bool>& stop,
                     Journal* journal)
    : study_(study), workers_(workers), stop_(stop), journal_(journal) {
  const std::chrono::duration<double> before(journal_ != nullptr ? journal_->seconds() : 0.0);
  began_ = std::chrono::steady_clock::now() -
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(before);
}

double Evaluator::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

std::optional<Evaluation> Evaluator::recall(std::uint64_t number, const Candidate& candidate,
                                            Engine engine) const {
  auto record = journal_ != nullptr ? journal_->find(number) : std::nullopt;
  if (!record) return std::nullopt;
  if (record->x != candidate.x || record->phase != candidate.phase ||
      record->results.size() != results_per_evaluation(study_)) {
    const bool another = record->phase != candidate.phase;
    const std::string differs =
        another ? fmt::format("has phase {}, but phase {} in the journal", candidate.phase, record->phase)
                : std::string("differs from the journal");
    throw InputError(
        InputPlace{study_.source, 0, fmt::format("evaluation {}", number)},
        fmt::format(
            "the search cannot be resumed, because evaluation {} {}; the study's file was changed, or "
            "the run was started with another program. Start the run again",
            number, differs))
        .with_value(another ? candidate.phase : "", another ? record->phase : "the point in the journal");
  }
  Evaluation e;
  e.x = candidate.x;
  e.gains = study_.space.gains_at(candidate.x);
  e.results = std::move(record->results);
  e.seconds = record->seconds;
  e.recalled = true;
  e.engine = engine;
  return e;
}

bool Evaluator::next(const std::vector<Candidate>& candidates, const Conditions& conditions,
                     const TakeIn& take_in) {
  if (study_.max_minutes <= 0.0) return next_portion(candidates, conditions, take_in);
  for (auto begin = candidates.begin(); begin != candidates.end();) {
    if (begin != candidates.begin() && !time_left()) return true;
    const auto left = static_cast<std::size_t>(candidates.end() - begin);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(portion(), left));
    if (!next_portion({begin, end}, conditions, take_in)) return false;
    begin = end;
  }
  return true;
}

std::size_t Evaluator::portion() const {
  constexpr std::size_t kLeast = 8;
  constexpr std::size_t kOfEach = 2;  // per worker: few enough to end soon, enough to keep all busy
  const std::size_t most = std::max(kLeast, kOfEach * static_cast<std::size_t>(workers_.count()));
  // A resumed run may have another number of workers. It must check the time at the evaluation at which the
  // journal says that time was up.
  const auto recorded = journal_ != nullptr ? journal_->time_was_up(minutes_) : std::nullopt;
  return recorded && *recorded > count_ ? std::min<std::size_t>(most, *recorded - count_) : most;
}

bool Evaluator::next_portion(const std::vector<Candidate>& candidates, const Conditions& conditions,
                             const TakeIn& take_in) {
  std::vector<std::optional<Evaluation>> ready(candidates.size());
  std::vector<std::size_t> missing;
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    ready[i] = recall(count_ + i, candidates[i], conditions.engine);
    if (ready[i]) continue;
    missing.push_back(i);
    points.push_back(candidates[i].x);
  }
  std::size_t taken = 0;
  const auto take_ready = [&] {
    for (; taken < ready.size() && ready[taken] && (ready[taken]->recalled || !stop_); ++taken) {
      take_in(candidates[taken].phase, *std::exchange(ready[taken], std::nullopt));
    }
  };
  take_ready();
  const auto finished = [&](std::size_t k, const Evaluation& e) {
    const std::size_t i = missing[k];
    const double now = seconds();
    if (journal_ != nullptr) journal_->append({count_ + i, candidates[i].phase, now, e.x, e.results});
    ready[i] = e;  // only after it was written to the disk
    ready[i]->seconds = now;
    take_ready();
  };
  const bool whole =
      points.empty() || simulate_points(study_, points, workers_, stop_, conditions, finished).has_value();
  count_ += candidates.size();
  return whole && taken == candidates.size();
}

void Evaluator::use(Minutes minutes, double kept) {
  minutes_ = minutes;
  kept_ = kept;
  time_was_up_ = false;
}

bool Evaluator::time_left() {
  time_was_up_ = study_.max_minutes > 0.0 && is_time_up();
  return !time_was_up_;
}

bool Evaluator::is_time_up() {
  if (journal_ != nullptr) {
    if (const auto recorded = journal_->time_was_up(minutes_)) return count_ >= *recorded;
    // Evaluations in the journal were started in time.
    if (journal_->records() > count_) return false;
  }
  if (seconds() + kept_ < 60.0 * study_.max_minutes) return false;
  if (journal_ != nullptr) journal_->time_is_up(count_, minutes_);
  return true;
}

}  // namespace armtune::internal
