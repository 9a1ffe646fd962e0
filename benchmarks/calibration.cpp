// Calibrates hidden arms from encoders and commands without torques, and prints how well: for each arm and
// each kind of commands, the error on unseen motion relative to that of the robot file, and how many of the
// 95 % intervals hold.
//
//     benchmark_calibration [ARMS] [ROBOT] [SECONDS]

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>

#include "sim/scenario/robot_file.hpp"
#include "tests/tuner/calibration/hidden_arm.hpp"

namespace armtune::internal {
namespace {

struct Tally {
  int told = 0;
  int held = 0;
  int cases = 0;
  int within = 0;  ///< cases with an error of at most a fifth of the uncalibrated one
  double worst = 0.0;
};

void calibrate_one(const test::HiddenArm& arm, const test::HiddenRecording& how, Tally& tally) {
  const auto start = std::chrono::steady_clock::now();
  const CommandedLog log = test::record(arm, how);
  test::HiddenRecording other = how;
  other.seed += 5000;
  const CommandedLog unseen = test::record(arm, other);
  const Calibration found = calibrate(arm.model, {&log, 1});
  const ShootingArm nominal = shooting_arm(arm.model);
  const HeldOutError before =
      horizon_error(arm.model, nominal, {&unseen, 1}, found.noise, HorizonPart::kWhole);
  const HeldOutError after =
      horizon_error(arm.model, found.arm, {&unseen, 1}, found.noise, HorizonPart::kWhole);
  int told = 0;
  int held = 0;
  std::string missed;
  for (const FittedParameter& p : found.parameters) {
    if (!p.told) continue;
    const double truth = test::true_value(arm, p.prior);
    const bool holds = truth >= p.low && truth <= p.high;
    ++told;
    held += holds ? 1 : 0;
    if (!holds) missed += " " + p.prior.name;
  }
  const Eigen::Index last = before.rms.rows() - 1;
  const double ratio = after.rms.row(last).norm() / before.rms.row(last).norm();
  tally.told += told;
  tally.held += held;
  ++tally.cases;
  tally.within += ratio <= 0.2 ? 1 : 0;
  tally.worst = std::max(tally.worst, ratio);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  fmt::print("{:>8} {:>6} {:>10.2e} {:>10.2e} {:>6.3f} {:>4}/{:<4} {:>5} {:>4} {:>6.1f}{}\n", name(how.kind),
             how.seed, before.rms.row(last).norm(), after.rms.row(last).norm(), ratio, held, told,
             found.parameters.size(), found.fit.iterations, time.count(), missed);
}

}  // namespace
}  // namespace armtune::internal

int main(int argc, char** argv) {
  using namespace armtune::internal;
  const int arms = argc > 1 ? std::atoi(argv[1]) : 20;
  const std::shared_ptr<const RobotModel> model = load_robot(argc > 2 ? argv[2] : "ur5e");
  Tally tally;
  fmt::print("{:>8} {:>6} {:>10} {:>10} {:>6} {:>9} {:>5} {:>4} {:>6}\n", "commands", "seed", "before",
             "after", "ratio", "held/told", "all", "iter", "time s");
  for (int i = 0; i < arms; ++i) {
    const test::HiddenArm arm = test::hidden_arm(*model, static_cast<unsigned>(100 + i));
    for (const CommandKind kind : {CommandKind::kTorque, CommandKind::kVelocity, CommandKind::kPosition}) {
      test::HiddenRecording how;
      how.kind = kind;
      how.seed = static_cast<unsigned>(200 + i);
      if (argc > 3) how.duration = std::atof(argv[3]);
      calibrate_one(arm, how, tally);
    }
  }
  fmt::print("{} of {} intervals hold ({:.1f} %)\n", tally.held, tally.told,
             100.0 * tally.held / std::max(1, tally.told));
  fmt::print("{} of {} errors are at most 0.2 of the uncalibrated ones; the largest is {:.3f}\n",
             tally.within, tally.cases, tally.worst);
  return 0;
}
