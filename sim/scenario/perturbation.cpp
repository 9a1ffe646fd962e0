#include "sim/scenario/perturbation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "core/common/error.hpp"

namespace armtune {
namespace {

constexpr int kMostDelay = 1000;
/// Keeps the numbers of one group apart from those of another.
constexpr std::uint64_t kMoreDraws = 0x9E3779B97F4A7C15U;

/// Uniform numbers by our own arithmetic: the standard leaves its distributions to the library, and a
/// sample's number must name the same arm everywhere.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t sample) : generator_(seeded(seed, sample)) {}
  std::uint64_t bits() { return generator_(); }
  double between(double lower, double upper) {
    constexpr double kStep = 0x1.0p-53;
    return lower + (upper - lower) * kStep * static_cast<double>(bits() >> 11U);
  }
  /// n factors in [1 - width, 1 + width].
  JointVector factors(int n, double width) {
    JointVector values(n);
    for (int i = 0; i < n; ++i) values[i] = between(1.0 - width, 1.0 + width);
    return values;
  }

 private:
  static std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value & 0xFFFFFFFFU); }
  static std::uint32_t high(std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32U); }
  static std::mt19937_64 seeded(std::uint64_t seed, std::uint64_t sample) {
    std::seed_seq sequence{low(seed), high(seed), low(sample), high(sample)};
    return std::mt19937_64(sequence);
  }
  std::mt19937_64 generator_;
};

constexpr int kCoordinates = 3;

void multiply(JointVector& factors, const JointVector& by) {
  factors = factors.size() > 0 ? JointVector(factors.cwiseProduct(by)) : by;
}

}  // namespace

void validate(const Perturbation& p) {
  const auto check = [](const char* field, double value, bool in_range, const char* range) {
    if (in_range) return;
    throw InputError(fmt::format("perturbation: {} is {}; it must lie in {}", field, value, range));
  };
  check("mass", p.mass, p.mass >= 0.0 && p.mass < 1.0, "[0, 1)");
  check("inertia", p.inertia, p.inertia >= 0.0 && p.inertia < 1.0, "[0, 1)");
  check("rotor", p.rotor, p.rotor >= 0.0 && p.rotor < 1.0, "[0, 1)");
  check("friction", p.friction, p.friction >= 0.0 && p.friction <= 1.0, "[0, 1]");
  check("payload_max", p.payload_max, std::isfinite(p.payload_max) && p.payload_max >= 0.0,
        "[0, infinity) kg");
  check("center", p.center, std::isfinite(p.center) && p.center >= 0.0, "[0, infinity) m");
  check("delay_max", p.delay_max, p.delay_max >= 0 && p.delay_max <= kMostDelay, "0 .. 1000 periods");
  check("noise", p.noise, p.noise >= 0.0 && p.noise <= 1.0, "[0, 1]");
  check("theta", p.theta, p.theta >= 0.0 && p.theta < 1.0, "[0, 1)");
  check("target_speed", p.target_speed, p.target_speed >= 0.0 && p.target_speed < 1.0, "[0, 1)");
}

Scenario perturbed(const Scenario& scenario, const Perturbation& perturbation, std::uint64_t seed,
                   std::uint64_t sample) {
  validate(perturbation);
  Draw draw(seed, sample);
  Scenario result = scenario;
  const int n = scenario.robot->n();
  PlantConditions& plant = result.plant;
  // Everything is drawn whether it is used or not, the arm before the scene: one arm for every scenario.
  multiply(plant.mass_factors, draw.factors(n, perturbation.mass));
  multiply(plant.inertia_factors, draw.factors(n, perturbation.inertia));
  multiply(plant.rotor_factors, draw.factors(n, perturbation.rotor));
  const JointVector friction = draw.factors(n, perturbation.friction);
  if (plant.viscous_friction.size() > 0) multiply(plant.viscous_friction, friction);
  if (plant.coulomb_friction.size() > 0) multiply(plant.coulomb_friction, friction);
  plant.payload = {draw.between(0.0, perturbation.payload_max), Vec3::Zero()};
  result.seed = draw.bits();
  // Each of these from numbers of its own, so that a kind that was added later leaves the others as they
  // were.
  Draw more(seed ^ kMoreDraws, sample);
  if (plant.center_offsets.cols() == 0) plant.center_offsets.setZero(kCoordinates, n);
  for (double& offset : plant.center_offsets.reshaped()) {
    offset += more.between(-perturbation.center, perturbation.center);
  }
  const double delay = more.between(0.0, perturbation.delay_max + 1.0);
  plant.torque_delay_periods += static_cast<int>(delay);
  const double noise = more.between(1.0 - perturbation.noise, 1.0 + perturbation.noise);
  plant.position_noise *= noise;
  plant.velocity_noise *= noise;
  multiply(result.theta.factors, more.factors(n, perturbation.theta));
  for (NamedPath& target : result.targets) {
    target.path.frequency *= more.between(1.0 - perturbation.target_speed, 1.0 + perturbation.target_speed);
  }
  for (auto* paths : {&result.targets, &result.obstacles}) {
    for (NamedPath& named : *paths) {
      const double phase = draw.between(0.0, 2.0 * M_PI);
      if (perturbation.phases) named.path.phase = phase;
    }
  }
  return result;
}

}  // namespace armtune
