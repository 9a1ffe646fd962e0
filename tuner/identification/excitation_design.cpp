#include "tuner/identification/excitation_design.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "armtune/error.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/slotine_li.hpp"
#include "tuner/solver/solver.hpp"

namespace armtune::internal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Number of instants per period of the highest harmonic at which the limits and the regressor are evaluated.
constexpr int kInstantsPerWave = 20;
constexpr int kRandomStarts = 50;
/// Weight of the violation in the cost, log(condition) + weight * violation.
constexpr double kPenalty = 50.0;

/// The design keeps this much more than the required distances, because the arm moves between the instants
/// [m].
constexpr double kSpareDistance = 0.01;

/// Returns the sum of the violations of all limits; 0 if every limit is kept. Violations of effort, velocity,
/// amplitude and distances are relative to the allowed value, those of position and height are in rad or m.
double violation(const ExcitationUse& use, const ExcitationOptions& o) {
  return std::max(0.0, use.effort_ratio / o.margin - 1.0) + std::max(0.0, -use.position_margin) +
         std::max(0.0, o.min_height - use.lowest) + std::max(0.0, use.velocity_ratio / o.margin - 1.0) +
         std::max(0.0, use.distance / o.amplitude - 1.0) + use.shortfall;
}

/// The instants at which a trajectory is evaluated: the fade-in and one whole period, evenly spaced, and the
/// fade-out. The motion in between repeats that of the first period.
struct Instants {
  std::vector<double> main;
  std::vector<double> fade_out;

  explicit Instants(const Excitation& e) {
    const double rate = kInstantsPerWave * e.frequency * static_cast<double>(e.sine.cols());
    const double end = std::min(e.duration, 1.0 / e.frequency + e.fade);
    main = spread(0.0, end, std::max(50, static_cast<int>(rate * end)));
    fade_out = spread(e.duration - e.fade, e.duration, std::max(10, static_cast<int>(rate * e.fade)));
  }

 private:
  static std::vector<double> spread(double begin, double end, int count) {
    std::vector<double> instants(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
      instants[static_cast<std::size_t>(k)] = begin + (end - begin) * (k + 0.5) / count;
    }
    return instants;
  }
};

class Designer {
 public:
  Designer(const RobotModel& model, const ExcitationOptions& options)
      : model_(model), options_(options), base_(base_parameters(model)) {
    if (options_.center.size() == 0) options_.center = middle();
  }

  std::size_t variables() const {
    return 2 * static_cast<std::size_t>(model_.n()) * static_cast<std::size_t>(options_.harmonics);
  }
  const BaseParameters& base() const { return base_; }
  const JointVector& center() const { return options_.center; }

  /// Returns the trajectory whose coefficients are x, numbers from 0 to 1. Each joint's series is scaled
  /// until it nearly touches its velocity margin, its amplitude or a position limit.
  Excitation at(const std::vector<double>& x) const {
    Excitation e;
    e.frequency = options_.frequency;
    e.duration = options_.duration;
    e.fade = options_.fade;
    e.center = options_.center;
    const Eigen::Index n = model_.n();
    const Eigen::Index h = options_.harmonics;
    e.sine.resize(n, h);
    e.cosine.resize(n, h);
    for (Eigen::Index k = 0; k < n * h; ++k) {
      // With the same coefficient, the second harmonic is twice as fast as the first, and so on.
      const Eigen::Index harmonic = k / n;
      const double slower = 1.0 / (static_cast<double>(harmonic) + 1.0);
      e.sine(k % n, harmonic) = slower * (2.0 * x[static_cast<std::size_t>(k)] - 1.0);
      e.cosine(k % n, harmonic) = slower * (2.0 * x[static_cast<std::size_t>(n * h + k)] - 1.0);
    }
    scale_to_limits(e);
    return e;
  }

  double cost(const std::vector<double>& x) const {
    const ExcitationUse use = use_of(at(x), model_, base_, options_.kept);
    return std::log(std::min(use.condition, 1e12)) + kPenalty * violation(use, options_);
  }

 private:
  JointVector middle() const {
    JointVector center(model_.n());
    for (int i = 0; i < model_.n(); ++i) {
      const JointLimits& limits = model_.joints[static_cast<std::size_t>(i)].limits;
      center[i] = limits.has_position ? 0.5 * (limits.lower + limits.upper) : 0.0;
    }
    return center;
  }

  void scale_to_limits(Excitation& e) const {
    const int n = model_.n();
    JointVector distance = JointVector::Zero(n);
    JointVector speed = JointVector::Zero(n);
    const Instants instants(e);
    for (const auto* list : {&instants.main, &instants.fade_out}) {
      for (const double t : *list) {
        const MotionPoint<JointVector> point = e.at(t);
        distance = distance.cwiseMax((point.position - e.center).cwiseAbs());
        speed = speed.cwiseMax(point.velocity.cwiseAbs());
      }
    }
    for (int i = 0; i < n; ++i) {
      const JointLimits& limits = model_.joints[static_cast<std::size_t>(i)].limits;
      double room = options_.amplitude;
      if (limits.has_position)
        room = std::min({room, limits.upper - e.center[i], e.center[i] - limits.lower});
      const double scale = std::min(0.98 * room / std::max(1e-9, distance[i]),
                                    0.98 * options_.margin * limits.velocity / std::max(1e-9, speed[i]));
      e.sine.row(i) *= std::max(0.0, scale);
      e.cosine.row(i) *= std::max(0.0, scale);
    }
  }

  const RobotModel& model_;
  ExcitationOptions options_;
  BaseParameters base_;
};

/// Records the largest shares of the limits over all points that look_at has received.
class LimitsInUse {
 public:
  LimitsInUse(const RobotModel& model, const JointVector& center)
      : model_(model),
        center_(center),
        velocity_limits_(model.velocity_limits()),
        effort_limits_(model.effort_limits()) {
    use_.position_margin = kInfinity;
    use_.lowest = kInfinity;
  }

  const Poses& look_at(const MotionPoint<JointVector>& point) {
    forward_kinematics(model_.chain, point.position, poses_);
    inverse_dynamics(model_.chain, poses_, point.velocity, point.acceleration, tau_);
    use_.distance = std::max(use_.distance, (point.position - center_).cwiseAbs().maxCoeff());
    use_.velocity_ratio =
        std::max(use_.velocity_ratio, point.velocity.cwiseQuotient(velocity_limits_).cwiseAbs().maxCoeff());
    use_.effort_ratio = std::max(use_.effort_ratio, tau_.cwiseQuotient(effort_limits_).cwiseAbs().maxCoeff());
    use_.lowest = std::min(use_.lowest, poses_.p_0T.z());
    // The origins of the first two joints are left out: they lie on the base or turn around the first axis,
    // so the design cannot raise them.
    for (std::size_t i = 2; i < model_.joints.size(); ++i)
      use_.lowest = std::min(use_.lowest, poses_.p_0B[i].z());
    for (std::size_t i = 0; i < model_.joints.size(); ++i) {
      const JointLimits& limits = model_.joints[i].limits;
      const double q = point.position[static_cast<Eigen::Index>(i)];
      if (limits.has_position) {
        use_.position_margin = std::min({use_.position_margin, q - limits.lower, limits.upper - q});
      }
    }
    return poses_;
  }

  const ExcitationUse& use() const { return use_; }

 private:
  const RobotModel& model_;
  const JointVector& center_;
  JointVector velocity_limits_, effort_limits_, tau_;
  Poses poses_;
  ExcitationUse use_;
};

void check(const RobotModel& model, const ExcitationOptions& o) {
  if (o.center.size() != 0 && o.center.size() != model.n()) {
    throw InputError(
        InputPlace{.key = "center"},
        fmt::format("the centre has {} values, but {} has {} joints", o.center.size(), model.name, model.n()))
        .with_value(std::to_string(o.center.size()), fmt::format("{} values", model.n()));
  }
  for (Eigen::Index i = 0; i < o.center.size(); ++i) {
    const JointInfo& joint = model.joints[static_cast<std::size_t>(i)];
    if (joint.limits.has_position &&
        !(o.center[i] > joint.limits.lower && o.center[i] < joint.limits.upper)) {
      throw InputError(
          InputPlace{.key = "center/" + joint.name},
          fmt::format("the centre of the trajectory places {} at {:.4g}, which is not inside its limits "
                      "{:.4g} .. {:.4g}",
                      joint.name, o.center[i], joint.limits.lower, joint.limits.upper))
          .with_value(fmt::format("{:.4g}", o.center[i]),
                      fmt::format("{:.4g} to {:.4g}", joint.limits.lower, joint.limits.upper));
    }
  }
  if (o.frequency * o.harmonics > kFastestHarmonic) {
    throw InputError(
        InputPlace{.key = "harmonics"},
        fmt::format("with {} harmonics of the base frequency {} Hz the motion is too fast: the highest "
                    "harmonic must not exceed {} Hz; give fewer harmonics or a lower base frequency",
                    o.harmonics, o.frequency, kFastestHarmonic))
        .with_value(fmt::to_string(o.harmonics), fmt::format("at most {} Hz", kFastestHarmonic));
  }
  if (o.fade > 0.5 * o.duration)
    throw InputError(
        InputPlace{.key = "fade"},
        fmt::format("fade-in and fade-out of {} s each do not fit in a duration of {} s; shorten the fade or "
                    "lengthen the duration",
                    o.fade, o.duration))
        .with_value(fmt::to_string(o.fade), fmt::format("at most {} s", 0.5 * o.duration));
}

}  // namespace

ExcitationUse use_of(const Excitation& e, const RobotModel& model, const BaseParameters& base,
                     const KeptDistances& kept) {
  const int n = model.n();
  const Instants instants(e);
  LimitsInUse limits(model, e.center);
  DistanceTally distances(kept, e.center, kSpareDistance);
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(instants.main.size()) * n, base.rank());
  SlotineLi motion;
  Regressor Y;
  for (std::size_t k = 0; k < instants.main.size(); ++k) {
    const MotionPoint<JointVector> point = e.at(instants.main[k]);
    const Poses& poses = limits.look_at(point);
    distances.see(instants.main[k], point.position);
    slotine_li_forward(model.chain, poses, point.velocity, point.velocity, point.acceleration, motion);
    slotine_li_regressor(model.chain, poses, motion, Y);
    for (int b = 0; b < base.rank(); ++b) {
      rows.col(b).segment(static_cast<Eigen::Index>(k) * n, n) =
          Y.col(base.independent[static_cast<std::size_t>(b)]);
    }
  }
  for (const double t : instants.fade_out) {
    const MotionPoint<JointVector> point = e.at(t);
    limits.look_at(point);
    distances.see(t, point.position);
  }

  ExcitationUse use = limits.use();
  use.shortfall = distances.shortfall();
  const Eigen::VectorXd length = rows.colwise().norm().cwiseMax(1e-12);
  Eigen::MatrixXd gram = rows.transpose() * rows;
  gram = length.cwiseInverse().asDiagonal() * gram * length.cwiseInverse().asDiagonal();
  const Eigen::VectorXd eigen =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(gram, Eigen::EigenvaluesOnly).eigenvalues();
  use.condition = eigen[0] > 0.0 ? std::sqrt(eigen[eigen.size() - 1] / eigen[0]) : kInfinity;
  return use;
}

namespace {

/// Throws InputError if the best trajectory breaks a limit, or keeps the distances only without any motion.
void refuse_broken_limits(const ExcitationDesign& design, const ExcitationOptions& options) {
  if (design.scale == 0.0)
    throw InputError(
        InputPlace{.key = "center"},
        "every trajectory around this centre brings the arm too near to a contact; move the centre, or give "
        "another --clearance");
  if (!(violation(design.use, options) > design.use.shortfall)) return;
  throw InputError(
      InputPlace{.key = "center"},
      fmt::format(
          "no trajectory around this centre keeps the limits. The best one uses {:.3g} of the effort limits "
          "and {:.3g} of the velocity limits (at most {} is allowed). It moves up to {:.3g} rad or m from the "
          "centre (at most {} is allowed). Its least distance to a position limit is {:.3g} rad or m, and its "
          "least height is {:.3g} m (at least {} is required). Move the centre, lower the amplitude or the "
          "frequency, or raise --margin",
          design.use.effort_ratio, design.use.velocity_ratio, options.margin, design.use.distance,
          options.amplitude, design.use.position_margin, design.use.lowest, options.min_height));
}

}  // namespace

ExcitationDesign design_excitation(const RobotModel& model, const ExcitationOptions& options,
                                   const std::atomic<bool>& stop) {
  check(model, options);
  const Designer designer(model, options);
  check_distances_at(designer.center(), options.kept);
  ExcitationDesign design;
  std::mt19937_64 generator(options.seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> best(designer.variables());
  double best_cost = kInfinity;
  const auto take = [&](const std::vector<double>& x) {
    const double cost = designer.cost(x);
    ++design.evaluations;
    if (cost < best_cost) {
      best_cost = cost;
      best = x;
    }
    if (options.progress) options.progress(design.evaluations, std::exp(best_cost));
    return cost;
  };
  for (int start = 0; start < kRandomStarts && !stop; ++start) {
    std::vector<double> x(designer.variables());
    for (double& v : x) v = uniform(generator);
    take(x);
  }
  design.random_condition = use_of(designer.at(best), model, designer.base()).condition;
  SolverProblem problem;
  problem.start = best;
  problem.evaluate = [&](const std::vector<SolverPoint>& points, std::vector<SolverValue>& values) {
    for (const SolverPoint& point : points) {
      if (stop || design.evaluations >= options.evaluations) return false;
      values.push_back({take(point.x), {}});
    }
    return true;
  };
  SolverOptions solver;
  solver.algorithm = "SBPLX";
  solver.initial_step = 0.2;
  solver.x_tolerance = 1e-4;
  solver.seed = options.seed;
  minimize(problem, solver);

  const Excitation found = designer.at(best);
  design.excitation = shrunk_to_keep(found, options.kept);
  design.scale = design.excitation.sine.norm() / found.sine.norm();
  design.use = use_of(design.excitation, model, designer.base(), options.kept);
  design.distances = distances_along(design.excitation, options.kept);
  if (!stop) refuse_broken_limits(design, options);
  return design;
}

}  // namespace armtune::internal
