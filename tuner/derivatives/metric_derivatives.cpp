#include "tuner/derivatives/metric_derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "armtune/error.hpp"
#include "tuner/derivatives/peak_rows.hpp"
#include "tuner/derivatives/perturbed_copies.hpp"
#include "tuner/derivatives/rollout_difference.hpp"

namespace armtune::internal {
namespace {

constexpr double kSmallestDerivativeStep = 1e-9;
constexpr double kLargestDerivativeStep = 0.1;

/// A scenario with one arm: the rollouts of the gain set and of its copies.
struct DerivativeUnit {
  std::size_t scenario = 0;
  std::size_t arm = 0;
  std::vector<std::size_t> places;  ///< of its metrics in MetricDerivatives::metrics
  std::vector<Metric> metrics;      ///< of which series are recorded
  bool simulated = false;           ///< `base` is there
  RolloutResult base;
  std::vector<std::pair<const PerturbedCopy*, RolloutResult>> waiting;  ///< copies that were earlier
};

void check_derivative_input(const Study& study, const std::vector<double>& x,
                            const DerivativeOptions& options) {
  const auto refuse = [&study](const char* key, double value, const std::string& limit) {
    throw InputError(InputPlace{where(study), 0, key},
                     InputFault{fmt::format("{} = {} cannot be used for derivatives", key, value),
                                fmt::to_string(value), limit});
  };
  if (!(options.step >= kSmallestDerivativeStep && options.step <= kLargestDerivativeStep))
    refuse("step", options.step, fmt::format("{} to {}", kSmallestDerivativeStep, kLargestDerivativeStep));
  if (!(options.band >= 0.0 && options.band <= 1.0)) refuse("band", options.band, "0 to 1");
  const std::size_t n = study.space.free.size();
  if (x.size() != n) refuse("x", static_cast<double>(x.size()), fmt::format("{} coordinates", n));
  for (const double xi : x) {
    if (!(xi >= 0.0 && xi <= 1.0)) refuse("x", xi, "0 to 1");
  }
  if (study.stepper == Stepper::kReference) {
    throw InputError(InputPlace{where(study), 0, "search/stepper"},
                     InputFault{"derivatives need the native engine, which "
                                "does not have this stepper",
                                name(study.stepper), "another stepper"});
  }
}

/// The derivatives of a metric or of a sample with one step.
struct StepDerivatives {
  const Eigen::VectorXd& gradient;
  const std::vector<int>& missing;
};

bool is_listed(const std::vector<int>& list, Eigen::Index i) {
  return std::find(list.begin(), list.end(), static_cast<int>(i)) != list.end();
}

/// Replaces the differences D(h) by 2 D(h) - D(2h), which is without their error of the order of h. Removes
/// the derivatives by gains for which the two do not agree. rounding: the difference that rounding can make.
void combine_steps(const StepDerivatives& second, double rounding, Eigen::VectorXd& gradient,
                   std::vector<int>& missing) {
  const double scale =
      std::max(gradient.lpNorm<Eigen::Infinity>(), second.gradient.lpNorm<Eigen::Infinity>());
  for (Eigen::Index i = 0; i < gradient.size(); ++i) {
    const bool agree = std::abs(second.gradient[i] - gradient[i]) <= kStepsAgree * scale + rounding;
    const bool known = !is_listed(missing, i);
    if (known && !is_listed(second.missing, i) && agree) {
      gradient[i] = 2.0 * gradient[i] - second.gradient[i];
    } else {
      gradient[i] = 0.0;
      if (known) missing.push_back(static_cast<int>(i));
    }
  }
  std::sort(missing.begin(), missing.end());
}

void combine_steps(const MetricDerivative& second, double step, MetricDerivative& derivative) {
  const auto rounding = [step](double value) { return kRolloutRounding * (1.0 + std::abs(value)) / step; };
  combine_steps({second.gradient, second.missing}, rounding(derivative.value), derivative.gradient,
                derivative.missing);
  for (std::size_t r = 0; r < derivative.rows.size(); ++r) {
    SampleRow& row = derivative.rows[r];
    const SampleRow& other = second.rows[r];
    combine_steps({other.gradient, other.missing}, rounding(row.value), row.gradient, row.missing);
  }
}

/// The simulation of all units, and the derivatives computed from it.
class DerivativeRun {
 public:
  DerivativeRun(const Study& study, const std::vector<double>& x, const std::vector<MetricUse>& uses,
                CandidateRunner& workers, const DerivativeOptions& options)
      : study_(study),
        workers_(workers),
        options_(options),
        base_(study.space.gains_at(x)),
        copies_(perturbed_copies(study.space, x, options)) {
    make_units(uses);
    out_.x = x;
    out_.per_gain = coordinates_per_gain(study.space, x);
  }

  /// Returns false if `stop` became true before the end.
  bool simulate(const std::atomic<bool>& stop);
  MetricDerivatives result() &&;

 private:
  /// A rollout: a unit, and one of its copies or null for the gain set itself.
  struct Job {
    std::size_t unit;
    const PerturbedCopy* copy;
  };
  void make_units(const std::vector<MetricUse>& uses);
  std::vector<Job> jobs() const;
  void take(const Job& job, RolloutResult&& result);  ///< one call at a time
  void begin(DerivativeUnit& unit);
  void differentiate(const DerivativeUnit& unit, const PerturbedCopy& copy, const RolloutResult& result);

  const Study& study_;
  CandidateRunner& workers_;
  const DerivativeOptions& options_;
  Gains base_;
  std::vector<PerturbedCopy> copies_;
  std::vector<DerivativeUnit> units_;      ///< by scenario, then arm
  std::vector<MetricDerivative> seconds_;  ///< with the step 2h; empty without two_steps
  MetricDerivatives out_;
};

void DerivativeRun::make_units(const std::vector<MetricUse>& uses) {
  const std::size_t scenarios = workers_.pool().plan().scenarios.size();
  for (std::size_t s = 0; s < scenarios; ++s) {
    for (std::size_t a = 0; a < workers_.arms_of(s); ++a) {
      units_.emplace_back();
      units_.back().scenario = s;
      units_.back().arm = a;
    }
  }
  for (const MetricUse& use : uses) {
    for (DerivativeUnit& unit : units_) {
      if (unit.scenario != use.scenario) continue;
      unit.places.push_back(out_.metrics.size());
      unit.metrics.push_back(use.metric);
      MetricDerivative& derivative = out_.metrics.emplace_back();
      derivative.use = use;
      derivative.arm = unit.arm;
      derivative.shape = shape_of(use.metric);
    }
  }
  if (options_.two_steps) seconds_.resize(out_.metrics.size());
}

// The copies of a unit are next to each other, so that the lanes of a worker share the scenario's motions.
// The longest scenario comes first, so that short rollouts fill the gaps at the end.
std::vector<DerivativeRun::Job> DerivativeRun::jobs() const {
  const std::vector<Scenario>& scenarios = workers_.pool().plan().scenarios;
  std::vector<std::size_t> order(units_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scenarios[units_[a].scenario].periods() > scenarios[units_[b].scenario].periods();
  });
  std::vector<Job> all;
  for (const std::size_t u : order) {
    all.push_back({u, nullptr});
    if (units_[u].places.empty()) continue;
    for (const PerturbedCopy& copy : copies_) all.push_back({u, &copy});
  }
  return all;
}

bool DerivativeRun::simulate(const std::atomic<bool>& stop) {
  const std::vector<Job> all = jobs();
  std::vector<double> seconds(all.size(), 0.0);
  const auto job_of = [&](std::size_t i) {
    const DerivativeUnit& unit = units_[all[i].unit];
    return RolloutJob{unit.scenario,   unit.arm,    all[i].copy != nullptr ? all[i].copy->gains : base_, {},
                      Engine::kNative, unit.metrics};
  };
  workers_.pool().run(all.size(), job_of, stop, [&](std::size_t i, RolloutResult&& result) {
    seconds[i] = result.end_time;
    take(all[i], std::move(result));
  });
  out_.rollouts = static_cast<long>(all.size());
  out_.simulated = std::accumulate(seconds.begin(), seconds.end(),
                                   0.0);  // in the same order for any workers
  return !stop;
}

void DerivativeRun::take(const Job& job, RolloutResult&& result) {
  DerivativeUnit& unit = units_[job.unit];
  if (job.copy == nullptr) {
    unit.base = std::move(result);
    begin(unit);
    for (const auto& [copy, earlier] : unit.waiting) differentiate(unit, *copy, earlier);
    unit.waiting.clear();
  } else if (unit.simulated) {
    differentiate(unit, *job.copy, result);
  } else {
    unit.waiting.emplace_back(job.copy, std::move(result));
  }
}

/// Chooses the rows of a unit's metrics from the rollout of the gain set.
void DerivativeRun::begin(DerivativeUnit& unit) {
  unit.simulated = true;
  const auto zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(out_.x.size()));
  for (const std::size_t place : unit.places) {
    MetricDerivative& derivative = out_.metrics[place];
    derivative.value = unit.base.metrics[derivative.use.metric];
    derivative.gradient = zero;
    const MetricSeries* series = unit.base.series.find(derivative.use.metric);
    if (derivative.shape == MetricShape::kLargest || derivative.shape == MetricShape::kSmallest) {
      derivative.rows = peak_rows(unit.base.series, *series, *series_kind(series->metric), options_);
    }
    for (SampleRow& row : derivative.rows) row.gradient = zero;
    if (options_.two_steps) seconds_[place] = derivative;
  }
}

void DerivativeRun::differentiate(const DerivativeUnit& unit, const PerturbedCopy& copy,
                                  const RolloutResult& result) {
  const RolloutDifference difference(unit.base, result, copy.step);
  for (const std::size_t place : unit.places) {
    difference.differentiate(copy.gain, copy.second ? seconds_[place] : out_.metrics[place]);
  }
  if (copy.second) return;
  for (MissingInterval& interval : difference.missing()) {
    interval.scenario = unit.scenario;
    interval.arm = unit.arm;
    interval.gain = copy.gain;
    out_.missing.push_back(interval);
  }
}

MetricDerivatives DerivativeRun::result() && {
  // Rollouts end in any order. From here on, nothing depends on it.
  std::sort(out_.missing.begin(), out_.missing.end(), [](const MissingInterval& a, const MissingInterval& b) {
    return std::tie(a.scenario, a.arm, a.gain, a.begin) < std::tie(b.scenario, b.arm, b.gain, b.begin);
  });
  for (std::size_t place = 0; place < out_.metrics.size(); ++place) {
    MetricDerivative& derivative = out_.metrics[place];
    std::sort(derivative.missing.begin(), derivative.missing.end());
    for (SampleRow& row : derivative.rows) std::sort(row.missing.begin(), row.missing.end());
    if (options_.two_steps) combine_steps(seconds_[place], options_.step, derivative);
  }
  std::vector<RolloutResult> results;
  for (DerivativeUnit& unit : units_) {
    unit.base.series = {};
    results.push_back(std::move(unit.base));
  }
  out_.results = workers_.fold(std::move(results));
  return std::move(out_);
}

}  // namespace

std::optional<MetricDerivatives> metric_derivatives(const Study& study, const std::vector<double>& x,
                                                    const std::vector<MetricUse>& uses,
                                                    CandidateRunner& workers, const std::atomic<bool>& stop,
                                                    const DerivativeOptions& options) {
  check_derivative_input(study, x, options);
  DerivativeRun run(study, x, uses, workers, options);
  if (!run.simulate(stop)) return std::nullopt;
  return std::move(run).result();
}

}  // namespace armtune::internal
