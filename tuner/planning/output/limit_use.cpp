#include "tuner/planning/output/limit_use.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "tuner/planning/transcription/arm_terms.hpp"

namespace armtune::internal {
namespace {

constexpr int kParts = 10;  // every interval is divided into this many parts
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A limit, and the function that returns the value to which it applies.
struct Measured {
  LimitUse use;
  Eigen::Index first = 0;  ///< first and last knot at which the limit applies
  Eigen::Index last = 0;
  std::function<double(const PlanSample&)> value;  ///< in the limit's unit
};

/// Returns the share of a limit that is used: 1 at the limit. With two bounds, it is counted from the middle
/// between them.
double used(const LimitUse& limit, double value) {
  if (!std::isfinite(limit.lower)) return value / limit.upper;
  // A required distance has only a lower bound, and its share is lower / value. At contact it is infinite.
  if (!std::isfinite(limit.upper)) return value > 0.0 || limit.lower <= 0.0 ? limit.lower / value : kInfinity;
  const double middle = 0.5 * (limit.lower + limit.upper);
  return std::abs(value - middle) / (0.5 * (limit.upper - limit.lower));
}

/// Computes the rows of a term at any time, also between knots.
class TermValues {
 public:
  explicit TermValues(const KnotTerm& term) : term_(term), values_(term.rows.size()) {}

  /// Returns the row's value in the user's unit. The rows must not depend on velocities or accelerations.
  double at(const PlanSample& sample, std::size_t row) {
    if (sample.time != time_) {
      time_ = sample.time;
      Knot knot;
      knot.time = sample.time;
      knot.q = sample.q;
      knot.poses = sample.poses;
      KnotRows rows;
      rows.value = values_.data();
      term_.evaluate(knot, rows);
    }
    return term_.natural(row, values_[row]);
  }

 private:
  const KnotTerm& term_;
  std::vector<double> values_;
  double time_ = std::numeric_limits<double>::quiet_NaN();
};

class Limits {
 public:
  Limits(const PlanTask& task, const PlanProblem& problem, const PlannedTrajectory& planned)
      : task_(task), robot_(*problem.robot), planned_(planned) {
    last_ = planned.trajectory.position.cols() - 1;
    add_coordinates();
    for (const KnotTerm& term : planned.program->task().terms) {
      if (!term.cost && term.lower < term.upper) add_term(term);
    }
  }

  std::vector<Measured> take() { return std::move(found_); }

 private:
  void add(LimitKind kind, const std::string& limit, const std::string& part, const std::string& unit,
           double lower, double upper, Eigen::Index first, Eigen::Index last,
           std::function<double(const PlanSample&)> value) {
    if (!std::isfinite(lower) && !std::isfinite(upper)) return;
    Measured measured;
    measured.use.kind = kind;
    measured.use.limit = limit;
    measured.use.part = part;
    measured.use.unit = unit;
    measured.use.lower = lower;
    measured.use.upper = upper;
    measured.use.from = planned_.trajectory.time[static_cast<std::size_t>(first)];
    measured.use.to = planned_.trajectory.time[static_cast<std::size_t>(last)];
    measured.first = first;
    measured.last = last;
    measured.value = std::move(value);
    found_.push_back(std::move(measured));
  }

  bool turns(int i) const {
    return robot_.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kRevolute;
  }

  void add_coordinates() {
    const auto& coordinates = planned_.program->task().coordinates;
    for (int i = 0; i < robot_.n(); ++i) {
      const Coordinate& c = coordinates[static_cast<std::size_t>(i)];
      const std::string length = turns(i) ? "rad" : "m";
      const auto add_one = [&](LimitKind kind, const std::string& unit, double lower, double upper,
                               std::function<double(const PlanSample&)> value) {
        add(kind, name(kind), c.name, unit, lower, upper, 0, last_, std::move(value));
      };
      add_one(LimitKind::kPosition, length, c.lower, c.upper, [i](const PlanSample& at) { return at.q[i]; });
      add_one(LimitKind::kVelocity, length + "/s", c.lowest_velocity(), c.velocity,
              [i](const PlanSample& at) { return at.qd[i]; });
      add_one(LimitKind::kAcceleration, length + "/s^2", -c.acceleration, c.acceleration,
              [i](const PlanSample& at) { return at.qdd[i]; });
      add_one(LimitKind::kJerk, length + "/s^3", -c.jerk, c.jerk,
              [i](const PlanSample& at) { return at.jerk[i]; });
    }
  }

  /// Adds the limits of a term. Names and knots are the term's. The values are computed from samples.
  void add_term(const KnotTerm& term) {
    if (!term.kind) return;
    const LimitKind kind = *term.kind;
    const auto values = std::make_shared<TermValues>(term);
    for (std::size_t row = 0; row < term.rows.size(); ++row) {
      const std::string& part = term.rows[row];
      if (kind == LimitKind::kTorque) {
        const auto i = static_cast<int>(row);
        const double limit = task_.limits.effort * robot_.joints[row].limits.effort;
        add(kind, term.name, part, turns(i) ? "N m" : "N", -limit, limit, term.first_knot, term.last_knot,
            [i](const PlanSample& at) { return at.tau[i]; });
      } else if (kind == LimitKind::kToolPath) {
        const auto axis = static_cast<Eigen::Index>(row);
        add(kind, term.name, part, "m", -task_.path_tolerance, task_.path_tolerance, term.first_knot,
            term.last_knot, [axis](const PlanSample& at) { return at.poses.p_0T[axis] - at.desired[axis]; });
      } else if (kind == LimitKind::kGaze) {
        add(kind, term.name, part, "rad", -kInfinity, task_.gaze_threshold, term.first_knot, term.last_knot,
            [](const PlanSample& at) { return at.gaze; });
      } else if (is_distance(kind)) {
        const double kept =
            kind == LimitKind::kLinks ? std::min(task_.clearance, kBetweenLinks) : task_.clearance;
        add(kind, term.name, part, "m", kept, kInfinity, term.first_knot, term.last_knot,
            [values, row](const PlanSample& at) { return values->at(at, row); });
      }
    }
  }

  const PlanTask& task_;
  const RobotModel& robot_;
  const PlannedTrajectory& planned_;
  Eigen::Index last_ = 0;
  std::vector<Measured> found_;
};

void measure(std::vector<Measured>& limits, PlanSampler& sampler, Eigen::Index last) {
  for (Eigen::Index k = 0; k <= last; ++k) {
    const PlanSample& knot = sampler.at_knot(k);
    for (Measured& m : limits) {
      if (k < m.first || k > m.last) continue;
      m.use.at_knots = std::max(m.use.at_knots, used(m.use, m.value(knot)));
    }
    for (int part = 1; part < kParts && k < last; ++part) {
      const PlanSample& at = sampler.within(k, static_cast<double>(part) / kParts);
      for (Measured& m : limits) {
        if (k < m.first || k + 1 > m.last) continue;
        const double now = used(m.use, m.value(at));
        if (now <= m.use.between) continue;
        m.use.between = now;
        m.use.between_time = at.time;
      }
    }
  }
}

}  // namespace

std::vector<LimitUse> limit_uses(const PlanTask& task, const PlanProblem& problem,
                                 const PlannedTrajectory& planned) {
  std::vector<Measured> limits = Limits(task, problem, planned).take();
  PlanSampler sampler(task, problem, planned.trajectory);
  measure(limits, sampler, planned.trajectory.position.cols() - 1);
  std::vector<LimitUse> uses;
  uses.reserve(limits.size());
  const std::vector<BindingLimit> binding = binding_limits(planned);
  for (Measured& m : limits) {
    for (const BindingLimit& b : binding) {
      if (b.limit != m.use.limit || b.part != m.use.part) continue;
      m.use.share = b.share;
      m.use.strength = b.strength;
      m.use.stretches = b.stretches;
    }
    uses.push_back(std::move(m.use));
  }
  std::stable_sort(uses.begin(), uses.end(),
                   [](const LimitUse& a, const LimitUse& b) { return a.strength > b.strength; });
  return uses;
}

WorstUse worst_between(const std::vector<LimitUse>& uses, const std::vector<LimitKind>& kinds) {
  WorstUse worst;
  for (const LimitUse& use : uses) {
    const bool is = std::find(kinds.begin(), kinds.end(), use.kind) != kinds.end();
    if (is && use.from < use.to && (worst.use == nullptr || use.between > worst.between))
      worst = {&use, use.between};
  }
  return worst;
}

}  // namespace armtune::internal
