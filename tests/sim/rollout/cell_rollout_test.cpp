// Rollouts in a cell: the metrics are the smallest of all distances of the motion that was simulated.

#include <gtest/gtest.h>

#include "core/control/laws/starting_gains.hpp"
#include "sim/lanes/rollout_lanes.hpp"
#include "sim/rollout/recorder.hpp"
#include "sim/scenario/default_task.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/cell/rods.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace cell_rollout_test {

struct Job {
  Scenario scenario;
  Gains gains;
};

/// The first task of a UR5e, five seconds of it, with a table beside it and a ball that passes.
Job in_a_cell() {
  const auto robot = load_robot("ur5e");
  const DefaultTask task = default_task(robot);
  Job job{task.scenario,
          starting_gains(*robot, task.scenario.start_position, task.goal, task.manipulability)};
  Cell cell;
  cell.floor = 0.0;
  cell.parts.push_back(test::part("table", box({0.8, 0.8, 0.05}), {0.6, 0.5, -0.1}));
  cell.parts.push_back({"ball", sphere(0.05), Mat3::Identity(),
                        Path{job.scenario.path.center + Vec3(0.3, 0.0, 0.1),
                             0.9,
                             0.0,
                             {{1, Vec3(0.0, 0.5, 0.0), Vec3(0.1, 0.0, 0.0)}}}});
  job.scenario.clearance = std::make_shared<const ClearanceModel>(robot, cell);
  job.scenario.duration = 5.0;
  return job;
}

std::array<double, kClearances> smallest_of_all(const Job& job, Engine engine) {
  std::array<double, kClearances> least;
  least.fill(INFINITY);
  const ClearanceModel& model = *job.scenario.clearance;
  Rollout(job.scenario, Stepper::kMidpoint, engine).run(job.gains, [&](const Observation& o) {
    const Poses poses = test::poses_at(job.scenario.robot->chain, *o.q);
    for (const ContactPair& pair : model.pairs()) {
      const Vec3 at = pair.of == Clearance::kCell ? model.cell().parts[pair.other].path.at(o.time).position
                                                  : Vec3(Vec3::Zero());
      double& of_kind = least[static_cast<std::size_t>(pair.of)];
      of_kind = std::min(of_kind, model.distance(pair, poses, at).distance);
    }
    return true;
  });
  return least;
}

TEST(RolloutInACell, HasTheSmallestDistancesOfItsMotionAsMetrics) {
  const Job job = in_a_cell();
  for (const Engine engine : {Engine::kNative, Engine::kSimbody}) {
    const auto expected = smallest_of_all(job, engine);
    const RolloutResult result = Rollout(job.scenario, Stepper::kMidpoint, engine).run(job.gains);
    ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
    EXPECT_EQ(result.metrics[Metric::kClearanceSelf], expected[0]);
    EXPECT_EQ(result.metrics[Metric::kClearanceCell], expected[1]);
    EXPECT_EQ(result.metrics[Metric::kClearanceFloor], expected[2]);
    EXPECT_LT(expected[1], 0.2) << "the ball comes near";
  }
}

TEST(RolloutInACell, MovesAsItDoesWithoutOne) {
  Job job = in_a_cell();
  const RolloutResult inside = Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(job.gains);
  job.scenario.clearance.reset();
  const RolloutResult outside = Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(job.gains);
  for (const Metric m : {Metric::kPositionRms, Metric::kJointVelocityMaxRatio, Metric::kEffortRateRms})
    EXPECT_EQ(inside.metrics[m], outside.metrics[m]) << name(m);
  for (const Metric m : {Metric::kClearanceSelf, Metric::kClearanceCell, Metric::kClearanceFloor})
    EXPECT_TRUE(std::isnan(outside.metrics[m])) << name(m);
}

TEST(RolloutInACell, InLanesItIsTheSameToTheBit) {
  const Job job = in_a_cell();
  const RolloutResult alone = Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(job.gains);
  const auto prepared = std::make_shared<const PreparedScenario>(job.scenario);
  RolloutLanes lanes(lane_kind(job.scenario, Stepper::kMidpoint, 0, lane_law(job.gains).value()), 2);
  int seen = 0;
  lanes.start(0, {prepared, job.gains});
  lanes.start(1, {prepared, job.gains});
  while (lanes.busy() > 0) {
    lanes.step([&](int, RolloutResult&& result) {
      EXPECT_EQ(test::bits(result.metrics), test::bits(alone.metrics));
      ++seen;
    });
  }
  EXPECT_EQ(seen, 2);
}

TEST(RolloutInACell, ItsRecordingHasTheDistancesOfEveryRow) {
  const Job job = in_a_cell();
  Recorder recorder(job.scenario, 5);
  const RolloutResult result =
      Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(job.gains, std::ref(recorder));
  const std::vector<double> values = recorder.rows();
  const auto& columns = recorder.columns();
  const auto column = [&](const std::string& name) {
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
    return static_cast<std::size_t>(found - columns.begin());
  };
  double least = INFINITY;
  for (std::size_t row = 0; row < values.size(); row += columns.size())
    least = std::min(least, values[row + column("clearance/cell")]);
  EXPECT_EQ(least, result.metrics[Metric::kClearanceCell]);
  ASSERT_LT(column("closest/to/z"), columns.size());
}

}  // namespace cell_rollout_test
}  // namespace armtune::internal
