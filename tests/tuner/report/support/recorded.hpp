#pragma once
// A short recorded rollout with obstacles, made once.

#include "sim/csv/csv_table.hpp"
#include "sim/rollout/recorder.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::test {

struct Recorded {
  Scenario scenario;
  Gains gains;
  report::Scene scene;
  CsvTable table;

  const report::Arm& arm() const { return scene.arms.front(); }
  const report::SceneScenario& shown() const { return scene.scenarios.front(); }
};

/// A rollout as its CSV has it, a row every `stride` periods of 2 ms.
inline CsvTable recording_of(const Scenario& scenario, const Gains& gains, int stride) {
  Recorder recorder(scenario, stride);
  Rollout(scenario, Stepper::kMidpoint).run(gains, [&](const Observation& o) { return recorder(o); });
  const TemporaryFolder folder;
  recorder.write_csv(folder / "rollout.csv");
  return CsvTable::read(folder / "rollout.csv");
}

/// 8 s of obstacle_pass, a row each 10 ms.
inline const Recorded& recorded() {
  static const Recorded run = [] {
    Scenario scenario = scenario_of("obstacle_pass", 8.0);
    const Gains gains = quick_gains(scenario);
    report::Scene scene =
        report::scene_of({scenario}, {{"gains", ".", "errors.csv"}}, gains.obstacleInfluenceRadius);
    return Recorded{scenario, gains, std::move(scene), recording_of(scenario, gains, 5)};
  }();
  return run;
}

/// Pose of a joint's frame in the base as the page computes it from positions q.
inline std::vector<Eigen::Isometry3d> frames(const report::Arm& arm, const std::vector<double>& q) {
  std::vector<Eigen::Isometry3d> found;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    X.translate(arm.joints[i].pose.p);
    X.rotate(arm.joints[i].pose.q);
    if (arm.joints[i].prismatic) {
      X.translate(Vec3(0, 0, q[i]));
    } else {
      X.rotate(Eigen::AngleAxisd(q[i], Vec3::UnitZ()));
    }
    found.push_back(X);
  }
  return found;
}

}  // namespace armtune::internal::test
