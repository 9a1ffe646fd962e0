#include "tuner/first_task/first_gain_sets.hpp"

namespace armtune::internal {
namespace {

/// Factors on starting gains.
struct Factors {
  double firmer;    ///< on Kd, and below 1 on Kp too
  double learning;  ///< on the adaptation
  double slower;    ///< on both duration gains
};

/// Every set of factors that is tried, those first that are to be preferred. Durations are proportional to
/// errors, so that a small error is made good in a short time and with much acceleration: heavy arms need
/// longer ones.
std::vector<Factors> ladder() {
  std::vector<Factors> all;
  for (const double firmer : {1.0, 2.0, 0.7, 0.5, 0.35}) {
    for (const double learning : {1.0, 0.1, 0.01, 0.0}) all.push_back({firmer, learning, 1.0});
  }
  for (const double slower : {4.0, 12.0}) {
    for (const double firmer : {1.0, 2.0, 0.5}) {
      for (const double learning : {1.0, 4.0, 0.1}) all.push_back({firmer, learning, slower});
    }
  }
  return all;
}

/// Under firmer gains the arm gives way less to weight that the model lacks. Softer ones need less of the
/// loop: S dies with M^-1 Kd, then the error with Kp, so that both change.
Gains changed(Gains gains, const Factors& factors) {
  gains.joint_space_gains_d *= factors.firmer;
  gains.task_space_gains_d *= factors.firmer;
  if (factors.firmer < 1.0) {
    gains.joint_space_gains_p *= factors.firmer;
    gains.task_space_gains_p *= factors.firmer;
  }
  gains.adaptation_gain *= factors.learning;
  gains.trajectoryDurationErrorGain *= factors.slower;
  gains.slerpDurationErrorGain *= factors.slower;
  return gains;
}

}  // namespace

std::vector<Gains> first_gain_sets(const Gains& start) {
  std::vector<Gains> sets;
  for (const Factors& factors : ladder()) sets.push_back(changed(start, factors));
  return sets;
}

}  // namespace armtune::internal
