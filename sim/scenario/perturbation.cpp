#include "sim/scenario/perturbation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "armtune/error.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "sim/scenario/arm_distribution.hpp"
#include "sim/scenario/uniform.hpp"

namespace armtune::internal {
namespace {

constexpr double kMostDelay = 1000.0;
/// Changes the seed for a second series of random numbers.
constexpr std::uint64_t kMoreDraws = 0x9E3779B97F4A7C15U;

class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t sample) : generator_(generator_of(seed, sample)) {}
  std::uint64_t bits() { return generator_(); }
  double between(double lower, double upper) { return uniform(generator_, lower, upper); }
  /// Returns n factors in [1 - width, 1 + width].
  JointVector factors(int n, double width) {
    JointVector values(n);
    for (int i = 0; i < n; ++i) values[i] = between(1.0 - width, 1.0 + width);
    return values;
  }

 private:
  std::mt19937_64 generator_;
};

constexpr int kCoordinates = 3;

void multiply(JointVector& factors, const JointVector& by) {
  factors = factors.size() > 0 ? JointVector(factors.cwiseProduct(by)) : by;
}

/// Returns the factors (n) on rotor inertia. drawn: factors of 1 +- width. An estimated rotor inertia gets a
/// factor with a uniform logarithm instead, from 1 / kRotorFactor to kRotorFactor.
JointVector rotor_factors(const RobotModel& robot, JointVector drawn, double width) {
  if (width == 0.0) return drawn;
  for (int i = 0; i < robot.n(); ++i) {
    if (has_estimated_rotor(robot, i)) drawn[i] = std::pow(kRotorFactor, (drawn[i] - 1.0) / width);
  }
  return drawn;
}

}  // namespace

std::span<const PerturbationField> perturbation_fields() {
  using P = Perturbation;
  using enum BesideDistribution;
  constexpr double kAny = 1e6;
  static constexpr PerturbationField fields[] = {
      {"mass", "1", "+- relative change of each link's mass, first moment and inertia, by one common factor",
       &P::mass, 1.0, false, kZero},
      {"center", "m", "+- change of each coordinate of each link's centre of mass", &P::center, kAny, true,
       kZero},
      {"inertia", "1", "+- relative change of each link's inertia about its centre of mass", &P::inertia, 1.0,
       false, kZero},
      {"rotor", "1",
       "+- relative change of each rotor inertia that the robot file does not mark as estimated. Estimated "
       "ones vary by a factor of 1/3 to 3",
       &P::rotor, 1.0, false, kReplaced},
      {"friction", "1", "+- relative change of each joint's friction in the scenario", &P::friction, 1.0,
       true, kReplaced},
      {"payload", "kg", "largest random payload (point mass at the tool); 0 keeps the scenario's payload",
       &P::payload, kAny, true, kZero},
      {"delay", "periods",
       "largest random extra delay of torques, or of commands to drives; must be a whole number", &P::delay,
       kMostDelay, true, kReplaced},
      {"noise", "1", "+- relative change of the sensors' noise", &P::noise, 1.0, true},
      {"theta", "1",
       "+- relative error of the controller's model of the arm (theta) at the start, for the parameters of each "
       "link and its joint",
       &P::theta, 1.0, false},
      {"target_speed", "1", "+- relative change of each target's speed on its path", &P::target_speed, 1.0,
       false},
  };
  return fields;
}

Perturbation default_perturbation(std::span<const Scenario> scenarios) {
  constexpr double kMostPayload = 3.0;  // times the scenario's own
  Perturbation perturbation;
  for (const Scenario& scenario : scenarios) {
    perturbation.payload = std::max(perturbation.payload, kMostPayload * scenario.plant.payload.mass);
  }
  return perturbation;
}

void draw_from(std::shared_ptr<const ArmDistribution> distribution, Perturbation& perturbation) {
  for (const PerturbationField& field : perturbation_fields()) {
    if (field.beside != BesideDistribution::kKept) perturbation.*field.width = 0.0;
  }
  perturbation.distribution = std::move(distribution);
}

Perturbation no_perturbation() {
  Perturbation none;
  for (const PerturbationField& field : perturbation_fields()) none.*field.width = 0.0;
  none.phases = false;
  return none;
}

void validate(const Perturbation& perturbation, const std::string& where) {
  for (const PerturbationField& f : perturbation_fields()) {
    const double width = perturbation.*f.width;
    if (width >= 0.0 && (width < f.most || (f.most_included && width == f.most))) continue;
    const std::string limit = fmt::format("in [0, {}{}", f.most, f.most_included ? "]" : ")");
    throw InputError(InputPlace{.key = fmt::format("{}/{}", where, f.name)},
                     fmt::format("{} is {}; it must lie {}. Unit: {}; meaning: {}", f.name, width, limit,
                                 f.unit, f.meaning))
        .with_value(fmt::to_string(width), limit);
  }
  for (const PerturbationField& f : perturbation_fields()) {
    const double width = perturbation.*f.width;
    if (!perturbation.distribution || f.beside != BesideDistribution::kReplaced || width == 0.0) continue;
    throw InputError(InputPlace{.key = fmt::format("{}/{}", where, f.name)},
                     fmt::format("{} is {}, but arms are drawn from the distribution in {}; leave {} out",
                                 f.name, width, perturbation.distribution->file, f.name))
        .with_value(fmt::to_string(width), "0 with a distribution");
  }
  if (perturbation.delay != std::floor(perturbation.delay)) {
    throw InputError(
        InputPlace{.key = where + "/delay"},
        fmt::format("delay is {}; it must be a whole number of control periods", perturbation.delay))
        .with_value(fmt::to_string(perturbation.delay), "a whole number of control periods");
  }
}

Scenario with_rotors_scaled(const Scenario& scenario, double factor) {
  Scenario result = scenario;
  JointVector factors = JointVector::Ones(scenario.robot->n());
  for (int i = 0; i < scenario.robot->n(); ++i) {
    if (has_estimated_rotor(*scenario.robot, i)) factors[i] = factor;
  }
  multiply(result.plant.rotor_factors, factors);
  return result;
}

Scenario perturbed(const Scenario& scenario, const Perturbation& perturbation, std::uint64_t seed,
                   std::uint64_t sample) {
  validate(perturbation);
  Draw draw(seed, sample);
  Scenario result = scenario;
  const int n = scenario.robot->n();
  PlantConditions& plant = result.plant;
  // Every number is drawn, used or not, and those of the arm before those of the scene. A sample therefore
  // has the same arm in all scenarios.
  multiply(plant.mass_factors, draw.factors(n, perturbation.mass));
  multiply(plant.inertia_factors, draw.factors(n, perturbation.inertia));
  multiply(plant.rotor_factors,
           rotor_factors(*scenario.robot, draw.factors(n, perturbation.rotor), perturbation.rotor));
  const JointVector friction = draw.factors(n, perturbation.friction);
  if (plant.viscous_friction.size() > 0) multiply(plant.viscous_friction, friction);
  if (plant.coulomb_friction.size() > 0) multiply(plant.coulomb_friction, friction);
  const double payload = draw.between(0.0, perturbation.payload);
  if (perturbation.payload > 0.0) plant.payload = {payload, Vec3::Zero()};
  result.seed = draw.bits();
  // The kinds from here on draw from a second series. The numbers of the first series then do not depend on
  // them.
  Draw more(seed ^ kMoreDraws, sample);
  if (plant.center_offsets.cols() == 0) plant.center_offsets.setZero(kCoordinates, n);
  for (double& offset : plant.center_offsets.reshaped()) {
    offset += more.between(-perturbation.center, perturbation.center);
  }
  const double delay = more.between(0.0, perturbation.delay + 1.0);
  plant.torque_delay_periods += static_cast<int>(delay);
  if (const ArmDistribution* fitted = perturbation.distribution.get())
    give_parameters(*fitted, drawn_parameters(*fitted, seed, sample), result);
  const double noise = more.between(1.0 - perturbation.noise, 1.0 + perturbation.noise);
  plant.position_noise *= noise;
  plant.velocity_noise *= noise;
  multiply(result.theta.factors, more.factors(n, perturbation.theta));
  for (NamedPath& target : result.targets) {
    const double speed = more.between(1.0 - perturbation.target_speed, 1.0 + perturbation.target_speed);
    target.path.frequency *= speed;
    target.path.spline_rate *= speed;
  }
  const auto start_anywhere = [&](Path& path) {
    const double phase = draw.between(0.0, 2.0 * M_PI);
    if (!perturbation.phases) return;
    path.phase = phase;
    // A spline that does not repeat keeps its beginning.
    const auto& spline = path.spline;
    if (spline && spline->loops())
      path.spline_lead = phase / (2.0 * M_PI) * (spline->end() - spline->begin());
  };
  for (NamedPath& target : result.targets) start_anywhere(target.path);
  for (MovingObstacle& obstacle : result.obstacles) start_anywhere(obstacle.path);
  if (result.clearance && !result.obstacles.empty()) {
    // The contact checks must have the obstacles on the same paths as the controller.
    std::vector<Path> paths;
    for (const MovingObstacle& obstacle : result.obstacles) {
      if (obstacle.radius > 0.0) paths.push_back(obstacle.path);
    }
    result.clearance = std::make_shared<const ClearanceModel>(result.clearance->with_obstacles_on(paths));
  }
  return result;
}

}  // namespace armtune::internal
