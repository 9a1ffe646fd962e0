#include "tuner/journal/evaluator.hpp"

#include <fmt/format.h>

#include "core/common/error.hpp"
#include "tuner/work/simulate_points.hpp"

namespace armtune {

Evaluator::Evaluator(const Study& study, Workers& workers, const std::atomic<bool>& stop, Journal* journal)
    : study_(study), workers_(workers), stop_(stop), journal_(journal) {
  const std::chrono::duration<double> before(journal_ != nullptr ? journal_->seconds() : 0.0);
  began_ = std::chrono::steady_clock::now() -
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(before);
}

double Evaluator::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

std::optional<Evaluation> Evaluator::recall(std::uint64_t number, const std::string& phase,
                                            const std::vector<double>& x) const {
  auto record = journal_ != nullptr ? journal_->find(number) : std::nullopt;
  if (!record) return std::nullopt;
  if (record->x != x || record->phase != phase || record->results.size() != study_.scenarios.size()) {
    throw InputError(
        fmt::format("{}: the search now asks for another point as evaluation {} ({} instead of {}) than the "
                    "journal holds: its "
                    "file was changed, or this program searches in another way; begin the run anew",
                    study_.source, number, phase, record->phase));
  }
  Evaluation e;
  e.x = x;
  e.gains = study_.space.gains_at(x);
  e.results = std::move(record->results);
  e.seconds = record->seconds;
  e.recalled = true;
  return e;
}

std::optional<std::vector<Evaluation>> Evaluator::next(const std::string& phase,
                                                       const std::vector<std::vector<double>>& points,
                                                       const std::vector<EndLimits>& limits) {
  std::vector<Evaluation> evaluations(points.size());
  std::vector<std::size_t> missing;
  std::vector<std::vector<double>> to_simulate;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (auto known = recall(count_ + i, phase, points[i])) {
      evaluations[i] = std::move(*known);
    } else {
      missing.push_back(i);
      to_simulate.push_back(points[i]);
    }
  }
  if (!to_simulate.empty()) {
    std::vector<double> finished_at(to_simulate.size(), 0.0);
    auto fresh =
        simulate_points(study_, to_simulate, workers_, stop_, limits, [&](std::size_t k, const Evaluation& e) {
          finished_at[k] = seconds();
          if (journal_ == nullptr) return;
          journal_->append({count_ + missing[k], phase, finished_at[k], e.x, e.results});
        });
    if (!fresh) return std::nullopt;
    for (std::size_t k = 0; k < missing.size(); ++k) {
      evaluations[missing[k]] = std::move((*fresh)[k]);
      evaluations[missing[k]].seconds = finished_at[k];
    }
  }
  count_ += points.size();
  return evaluations;
}

bool Evaluator::time_left() {
  if (study_.max_minutes <= 0.0) return true;
  if (journal_ != nullptr && journal_->time_was_up()) return count_ < *journal_->time_was_up();
  // What is recorded was begun in time.
  if (journal_ != nullptr && journal_->records() > count_) return true;
  if (seconds() < 60.0 * study_.max_minutes) return true;
  if (journal_ != nullptr) journal_->time_is_up(count_);
  return false;
}

}  // namespace armtune
