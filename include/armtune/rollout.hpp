#pragma once
// Simulation of scenarios under given gains. One simulated scenario is called a rollout.

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armtune/gains.hpp"
#include "armtune/progress.hpp"
#include "armtune/scenario.hpp"
#include "armtune/verdict.hpp"

namespace armtune {

/// The physics engine that computes an arm's motion.
enum class Engine {
  kSimbody,
  kNative  ///< armtune's own dynamics for several arms at a time, about ten times as fast
};

struct SimulateOptions {
  /// New folder for all files of the run; empty: nothing is written. Not for simulate_sets.
  std::string folder = {};
  Engine engine = Engine::kSimbody;
  std::string stepper = "midpoint";  ///< midpoint, semi_implicit_euler, rk4 or reference
  int workers = 1;                   ///< threads; results do not depend on it
  /// Control periods per row of the recording; 0: no recording. A run with a folder must have a recording.
  int record_every = 5;
  double deadline = 0.0;  ///< wall-clock limit of a rollout [s]. 0: none; in simulate_sets 20 s plus twice
                          ///< its simulated duration
  Watch watch = {};
};

/// The result of simulating one scenario: its status, metrics and time series. It is a value.
class Rollout {
 public:
  const std::string& scenario() const { return scenario_; }
  /// Returns "completed", "diverged", "no_samples" (the rollout reached its end, but the tool never tracked
  /// the task) or "interrupted".
  const std::string& status() const { return status_; }
  bool completed() const { return status_ == "completed"; }
  /// Returns when, where and why the rollout did not complete; empty if it completed.
  const std::string& reason() const { return reason_; }
  /// Returns every metric by name, in SI units; NaN if there was nothing to measure. `armtune metrics`
  /// explains them.
  const std::map<std::string, double>& metrics() const { return metrics_; }
  /// Returns one metric. Throws InputError if there is no such metric.
  double metric(const std::string& name) const;
  /// Returns the arm's own limits that were exceeded, each in one sentence, the earliest first. There is no
  /// value if the limits were not observed. They are not observed by simulate_sets, for random arms, and in
  /// the rollouts that an objective of your own receives. In these cases, use metrics such as
  /// "joint_velocity/max_ratio".
  const std::optional<std::vector<std::string>>& broken_limits() const { return broken_limits_; }

  /// Returns the names of the recorded columns, `time` first; empty without a recording.
  const std::vector<std::string>& columns() const { return columns_; }
  std::size_t rows() const { return columns_.empty() ? 0 : values_.size() / columns_.size(); }
  /// Returns all recorded values, row by row (rows x columns).
  std::span<const double> values() const { return values_; }
  /// Returns a copy of one column (rows). Throws InputError if there is no column of that name.
  std::vector<double> column(const std::string& name) const;

 private:
  friend struct RolloutMaker;
  std::string scenario_, status_, reason_;
  std::map<std::string, double> metrics_;
  std::optional<std::vector<std::string>> broken_limits_;
  std::vector<std::string> columns_;
  std::vector<double> values_;
  std::shared_ptr<const void> result_;  ///< input of errors_csv
};

/// The result of simulating scenarios with one gain set.
struct Simulated {
  std::vector<Rollout> rollouts = {};  ///< one for each scenario, in their order
  Verdict verdict = {};                ///< on the rollouts; without checks if interrupted
  bool interrupted = false;
  std::vector<std::string> files = {};  ///< names of the files in the folder
};

/// Simulates every scenario under these gains. The results are bit-identical for any number of workers. With
/// a folder, tasks and robot files are also examined: the verdict then has notes on tasks that no gains can
/// complete, and lists implausible numbers among its assumptions. Both are also reported as warnings to the
/// Watch. Throws InputError if the gains are not valid for the arm of a scenario, if two scenarios have the
/// same name, or if the folder is in use; FailedError if a file cannot be written.
Simulated simulate(const std::vector<Scenario>& scenarios, const Gains& gains,
                   const SimulateOptions& options = {});

/// Simulates every scenario under each of several gain sets, without recordings: result[set][scenario]. The
/// native engine computes several of these rollouts side by side in a processor's vector registers.
std::vector<std::vector<Rollout>> simulate_sets(const std::vector<Scenario>& scenarios,
                                                const std::vector<Gains>& sets,
                                                const SimulateOptions& options = {});

/// Returns the text of errors.csv: one row for each rollout, with every metric.
std::string errors_csv(const std::vector<Rollout>& rollouts);

}  // namespace armtune
