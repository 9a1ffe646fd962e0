#include "tuner/robustness/margins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>

#include "armtune/error.hpp"
#include "tuner/ranks/patience.hpp"
#include "tuner/workers/parallel.hpp"
#include "tuner/workers/rollout_plan.hpp"

namespace armtune::internal {
namespace {

/// Ends a rollout as soon as its loop is known to fail, and keeps the reason.
class Watch {
 public:
  Watch(const Scenario& scenario, const std::vector<MetricLimit>& limits)
      : joints_(joint_names(*scenario.robot)),
        velocity_limits_(scenario.robot->velocity_limits()),
        effort_limits_(scenario.robot->effort_limits()),
        allowed_(saturated_periods_allowed(scenario)) {
    for (const MetricLimit& limit : limits) {
      if (limit.metric == Metric::kJointVelocityMaxRatio && limit.upper) velocity_.push_back(limit);
    }
  }

  bool goes_on(const Observation& o) {
    bool within = true;
    JointVector most = JointVector::Zero(velocity_limits_.size());  // torque, as a share of its limit
    o.each_instant([&](double time, const JointVector&, const JointVector& qd, const JointVector& commanded,
                       const JointVector&) {
      most = most.cwiseMax(commanded.cwiseAbs().cwiseQuotient(effort_limits_));
      within = within && keeps_velocity(time, qd);
    });
    if (!within) return false;
    if (o.saturated() && ++saturated_ > allowed_) {
      Eigen::Index worst = 0;
      most.maxCoeff(&worst);
      failure_ = {fmt::format("{} at {:.3f} s", saturation_text(), o.time),
                  joints_[static_cast<std::size_t>(worst)], o.time};
      return false;
    }
    return true;
  }

  const LoopFailure& failure() const { return failure_; }

 private:
  bool keeps_velocity(double time, const JointVector& qd) {
    for (const MetricLimit& limit : velocity_) {
      for (Eigen::Index i = 0; i < velocity_limits_.size(); ++i) {
        if (std::abs(qd[i]) / velocity_limits_[i] <= limit.value) continue;
        const std::string& joint = joints_[static_cast<std::size_t>(i)];
        failure_ = {fmt::format("{} breaks {} at time {:.3f} s", joint, to_string(limit), time), joint, time};
        return false;
      }
    }
    return true;
  }

  std::vector<std::string> joints_;
  JointVector velocity_limits_, effort_limits_;
  std::vector<MetricLimit> velocity_;
  long allowed_;  ///< periods
  long saturated_ = 0;
  LoopFailure failure_;
};

/// Returns why the loop fails in an engine; the text is empty if it does not fail. Returns nothing if `stop`
/// interrupted the rollout.
std::optional<LoopFailure> failure(Engine engine, const Scenario& scenario, const Gains& gains,
                                   const MarginOptions& options, const std::atomic<bool>& stop) {
  Watch watch(scenario, options.limits);
  const double deadline = deadline_of(0.0, scenario);
  RunningTime time;
  const RolloutResult result =
      Rollout(scenario, options.stepper, engine).run(gains, [&](const Observation& o) {
        // This is an error and no failure of the loop, because a margin must not depend on the wall clock.
        if (time.look() > deadline) {
          throw FailedError(
              fmt::format("{}: a rollout of the margin search simulated only {:.3f} s of {} s within its "
                          "deadline of {} s of computing time; find out what slows it down",
                          scenario.name, o.time, scenario.duration, deadline));
        }
        return !stop && watch.goes_on(o);
      });
  if (!watch.failure().holds()) return watch.failure();
  if (result.status == RolloutStatus::kInterrupted) return std::nullopt;
  if (result.status != RolloutStatus::kCompleted) {
    return LoopFailure{fmt::format("{} at {:.3f} s", name(result.status), result.end_time), "",
                       result.end_time};
  }
  const std::string broken = broken_limit(result, options.limits, scenario).text;
  return LoopFailure{broken.empty() ? broken : "breaks " + broken, "", NAN};
}

/// A loop with the quantity of one margin changed, in one engine. Every value is simulated only once.
class Pushed {
 public:
  Pushed(Engine engine, const MarginField& margin, const Scenario& scenario, const Gains& gains,
         const MarginOptions& options, const std::atomic<bool>& stop)
      : engine_(engine),
        margin_(margin),
        scenario_(scenario),
        gains_(gains),
        options_(options),
        stop_(stop) {}

  /// True if the loop is stable at this value. Also returns false once `stop` is true.
  bool stands(double value) {
    if (stop_) return false;
    const auto known = reasons_.find(value);
    if (known != reasons_.end()) return known->second.holds();
    Scenario scenario = scenario_;
    Gains gains = gains_;
    margin_.apply(value, scenario, gains);
    const auto why = failure(engine_, scenario, gains, options_, stop_);
    if (why) reasons_.emplace(value, *why);
    return why && why->holds();
  }
  /// Returns why the loop fails at a value that was tried.
  const std::string& reason(double value) const { return reasons_.at(value).text; }

 private:
  Engine engine_;
  const MarginField& margin_;
  const Scenario& scenario_;
  const Gains& gains_;
  const MarginOptions& options_;
  const std::atomic<bool>& stop_;
  std::map<double, LoopFailure> reasons_;
};

/// Returns the margin of a loop that is stable at its nominal value. Returns nothing if `stop` interrupted
/// the search.
std::optional<Margin> find_margin(Margin margin, const Scenario& scenario, const Gains& gains,
                                  const MarginOptions& options, const std::atomic<bool>& stop) {
  const MarginField& declared = field(margin.kind);
  EdgeSearch search = declared.search;
  search.nominal = margin.nominal;
  Pushed judge(Engine::kSimbody, declared, scenario, gains, options, stop);
  const auto stands = [&judge](double value) { return judge.stands(value); };
  std::optional<Edge> edge;
  if (options.engine != Engine::kSimbody) {
    Pushed guess(options.engine, declared, scenario, gains, options, stop);
    edge = find_edge(search, [&guess](double value) { return guess.stands(value); });
    const bool holds = edge->holds == search.nominal || stands(edge->holds);
    if (!holds || (edge->fails && stands(*edge->fails))) edge.reset();
  }
  if (!edge) edge = find_edge(search, stands);
  if (stop) return std::nullopt;
  margin.stands = edge->holds;
  margin.fails = edge->fails;
  if (edge->fails) margin.reason = judge.reason(*edge->fails);
  return margin;
}

/// True if a is a smaller margin than b. Both must be of the same kind.
bool smaller(const Margin& a, const Margin& b) {
  if (!a.stands || !b.stands) return !a.stands && b.stands;
  return field(a.kind).search.stride > 1.0 ? *a.stands < *b.stands : *a.stands > *b.stands;
}

}  // namespace

std::vector<Margin> margins(const std::vector<Scenario>& scenarios, const Gains& gains,
                            const MarginOptions& options, const std::atomic<bool>& stop) {
  // The nominal rollout is the same for every margin.
  std::vector<std::optional<LoopFailure>> nominal(scenarios.size());
  parallel_for(scenarios.size(), options.workers, stop, [&](std::size_t, std::size_t s) {
    nominal[s] = failure(Engine::kSimbody, scenarios[s], gains, options, stop);
  });
  const std::size_t jobs = kMarginCount * scenarios.size();
  std::vector<std::optional<Margin>> found(jobs);
  const auto whole = [&found] {
    std::vector<Margin> there;
    there.reserve(found.size());
    for (const std::optional<Margin>& margin : found) {
      if (margin) there.push_back(*margin);
    }
    return there;
  };
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(jobs, options.workers, stop, [&](std::size_t, std::size_t job) {
    const Scenario& scenario = scenarios[job % scenarios.size()];
    const std::optional<LoopFailure>& why = nominal[job % scenarios.size()];
    if (!why) return;
    Margin nominally;
    nominally.kind = static_cast<MarginKind>(job / scenarios.size());
    nominally.scenario = scenario.name;
    nominally.control_period = scenario.control_period;
    nominally.nominal = field(nominally.kind).nominal(scenario);
    std::optional<Margin> margin = nominally;
    if (why->holds()) {
      margin = find_margin(nominally, scenario, gains, options, stop);
    } else {
      margin->fails = margin->nominal;
      margin->reason = why->text;
    }
    const std::lock_guard lock(mutex);
    if (!margin) return;
    found[job] = std::move(margin);
    ++done;
    if (options.progress) options.progress(done, jobs);
    if (options.finished) options.finished(whole());
  });
  return whole();
}

std::optional<LoopFailure> failure_at(MarginKind kind, double value, const Scenario& scenario,
                                      const Gains& gains, const MarginOptions& options,
                                      const std::atomic<bool>& stop) {
  Scenario pushed = scenario;
  Gains scaled = gains;
  field(kind).apply(value, pushed, scaled);
  return failure(Engine::kSimbody, pushed, scaled, options, stop);
}

std::optional<LoopFailure> loop_failure(const Scenario& scenario, const Gains& gains,
                                        const MarginOptions& options, const std::atomic<bool>& stop) {
  return failure(Engine::kSimbody, scenario, gains, options, stop);
}

std::optional<Margin> least(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins,
                            MarginKind kind) {
  std::optional<Margin> result;
  std::size_t there = 0;
  for (const Margin& margin : margins) {
    if (margin.kind != kind) continue;
    ++there;
    if (!result || smaller(margin, *result)) result = margin;
  }
  return there == scenarios.size() ? result : std::nullopt;
}

}  // namespace armtune::internal
