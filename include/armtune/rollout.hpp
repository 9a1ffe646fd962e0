#pragma once
// Scenarios simulated under gains.

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armtune/gains.hpp"
#include "armtune/progress.hpp"
#include "armtune/scenario.hpp"

namespace armtune {

/// What computes an arm's motion.
enum class Engine {
  kSimbody,
  kNative  ///< armtune's own dynamics, several arms at a time: an order of magnitude quicker
};

struct SimulateOptions {
  Engine engine = Engine::kSimbody;
  std::string stepper = "midpoint";  ///< midpoint, semi_implicit_euler, rk4 or reference
  int workers = 1;                   ///< threads; results do not depend on it
  int record_every = 5;              ///< control periods per row of the recording; 0: nothing is recorded
  double deadline = 0.0;  ///< of one rollout, wall clock [s]. 0: none; in simulate_sets 20 s and twice the
                          ///< simulated duration
  Watch watch = {};
};

/// A simulated scenario: what became of it, its metrics, and its time series. A value.
class Rollout {
 public:
  const std::string& scenario() const { return scenario_; }
  /// "completed", "diverged", "no_samples" (it ran to its end, but never tracked the task) or "interrupted".
  const std::string& status() const { return status_; }
  bool completed() const { return status_ == "completed"; }
  /// When, where and why it ended; empty if completed.
  const std::string& reason() const { return reason_; }
  /// Every metric by name, in SI units; NaN where there was nothing to judge. `armtune metrics` says what
  /// they mean.
  const std::map<std::string, double>& metrics() const { return metrics_; }
  /// Throws InputError if there is no such metric.
  double metric(const std::string& name) const;
  /// The arm's own limits that were passed, each in one sentence, the earliest first. No value where nobody
  /// looked: of simulate_sets, random arms, and objectives of one's own, where the metrics have the largest
  /// ratios.
  const std::optional<std::vector<std::string>>& broken_limits() const { return broken_limits_; }

  /// Names of the recorded columns, `time` first; empty where nothing was recorded.
  const std::vector<std::string>& columns() const { return columns_; }
  std::size_t rows() const { return columns_.empty() ? 0 : values_.size() / columns_.size(); }
  /// All recorded values, row by row (rows x columns).
  std::span<const double> values() const { return values_; }
  /// A copy of one column (rows). Throws InputError if there is none of that name.
  std::vector<double> column(const std::string& name) const;

 private:
  friend struct RolloutMaker;
  std::string scenario_, status_, reason_;
  std::map<std::string, double> metrics_;
  std::optional<std::vector<std::string>> broken_limits_;
  std::vector<std::string> columns_;
  std::vector<double> values_;
  std::shared_ptr<const void> result_;  ///< what errors_csv writes
};

/// Simulates every scenario under these gains. Results are in the order of the scenarios; the same bits for
/// any number of workers. Throws InputError if the gains are not valid for the arm of a scenario, or if two
/// scenarios share a name.
std::vector<Rollout> simulate(const std::vector<Scenario>& scenarios, const Gains& gains,
                              const SimulateOptions& options = {});

/// Simulates every scenario under each of several gain sets, without recordings: result[set][scenario]. In
/// the native engine several of these rollouts share a processor's vector registers.
std::vector<std::vector<Rollout>> simulate_sets(const std::vector<Scenario>& scenarios,
                                                const std::vector<Gains>& sets,
                                                const SimulateOptions& options = {});

/// The text of errors.csv: one row for each rollout, every metric.
std::string errors_csv(const std::vector<Rollout>& rollouts);

}  // namespace armtune
