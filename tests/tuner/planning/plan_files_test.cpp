// The CSV files of a plan read back: every cell, to the bit.

#include "tuner/planning/output/plan_files.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <utility>

#include "tests/sim/support/read_back.hpp"

namespace armtune::internal {
namespace plan_files_test {

using Cells = std::map<std::string, double>;

void add_vector(Cells& cells, const std::string& name, const Vec3& value) {
  for (const char axis : {'x', 'y', 'z'}) cells[name + "/" + axis] = value[axis - 'x'];
}

/// What either file says of the arm at one time.
Cells arm_cells(const RobotModel& robot, const PlanSample& at) {
  Cells cells;
  cells["time"] = at.time;
  add_vector(cells, "tool/position", at.poses.p_0T);
  for (int i = 0; i < robot.n(); ++i) {
    const JointInfo& joint = robot.joints[static_cast<std::size_t>(i)];
    const std::string tree = "joint/" + joint.name + "/";
    cells[tree + "position"] = at.q[i];
    cells[tree + "velocity"] = at.qd[i];
    cells[tree + "acceleration"] = at.qdd[i];
    cells[tree + "torque"] = at.tau[i];
    cells[tree + "velocity_ratio"] = std::abs(at.qd[i]) / joint.limits.velocity;
    cells[tree + "torque_ratio"] = std::abs(at.tau[i]) / joint.limits.effort;
  }
  return cells;
}

void expect_row(test::ReadBack& read, std::size_t row, const Cells& cells) {
  for (const auto& [column, value] : cells) read.number(row, column, value);
}

/// Numbers with which an arm still has torques, and all of the awkward ones.
double ordinary(std::size_t i) {
  const std::vector<double> numbers = {
      1.0 / 3.0, -0.0, 5e-324, 0.1 + 0.2, std::nextafter(1.0, 2.0), -2.2250738585072014e-308};
  return numbers[i % numbers.size()];
}

/// A motion that no solver made: knots with ordinary numbers, with awkward ones, and with none.
Trajectory awkward_motion(const PlanTask& task, Eigen::Index coordinates) {
  Trajectory motion;
  for (const double t : {0.0, 1.0 / 3.0, 0.1 + 0.2 + 1.0 / 3.0, 1.0, 1.25, std::nextafter(1.5, 2.0)})
    motion.time.push_back(task.at + t);
  motion.durations = {motion.time.back() - motion.time.front()};
  const auto knots = static_cast<Eigen::Index>(motion.time.size());
  std::size_t i = 0;
  for (Eigen::MatrixXd* values : {&motion.position, &motion.velocity, &motion.acceleration}) {
    values->resize(coordinates, knots);
    for (Eigen::Index k = 0; k < knots; ++k) {
      for (Eigen::Index c = 0; c < coordinates; ++c, ++i) {
        (*values)(c, k) = k == 4             ? test::no_figures()[i % test::no_figures().size()]
                          : k == 2 || k == 3 ? test::awkward(i)
                                             : ordinary(i);
      }
    }
  }
  return motion;
}

struct Planned {
  PlanTask task;
  PlanProblem problem;
  Trajectory motion;

  explicit Planned(PlanTask given)
      : task(std::move(given)),
        problem(plan_problem(task)),
        motion(awkward_motion(task, robot().n() + (task.kind == PlanKind::kFastest ? 1 : 0))) {}
  const RobotModel& robot() const { return *problem.robot; }
};

std::vector<Planned> all_planned() {
  std::vector<Planned> all;
  all.emplace_back(load_plan_task("ur10_switch"));
  PlanTask clear = load_plan_task("ur10_clear_of_obstacles");
  clear.limits.jerk = JointVector::Constant(6, 100.0);
  all.emplace_back(std::move(clear));
  all.emplace_back(load_plan_task("ur10_fastest_circle"));
  return all;
}

TEST(TrajectoryCsv, ReadsBackToTheBitAndIsEmptyWhereThereIsNoFigure) {
  for (const Planned& plan : all_planned()) {
    SCOPED_TRACE(plan.task.name);
    test::ReadBack read(trajectory_csv(plan.task, plan.problem, plan.motion));
    PlanSampler sampler(plan.task, plan.problem, plan.motion);
    for (std::size_t row = 0; row < plan.motion.time.size(); ++row) {
      const auto k = static_cast<Eigen::Index>(row);
      const PlanSample& at = sampler.at_knot(k);
      Cells cells = arm_cells(plan.robot(), at);
      cells["time"] = plan.motion.time[row];
      for (int i = 0; i < plan.robot().n(); ++i) {
        const std::string tree = "joint/" + plan.robot().joints[static_cast<std::size_t>(i)].name + "/";
        cells[tree + "position"] = plan.motion.position(i, k);
        cells[tree + "velocity"] = plan.motion.velocity(i, k);
        cells[tree + "acceleration"] = plan.motion.acceleration(i, k);
      }
      const Eigen::Quaterniond turn(at.poses.R_0T);
      cells["tool/orientation/w"] = turn.w();
      add_vector(cells, "tool/orientation", turn.vec());
      cells["gaze/angle"] = at.gaze;
      if (plan.task.kind == PlanKind::kFastest)
        cells["path/coordinate"] = plan.motion.position(plan.robot().n(), k);
      expect_row(read, row, cells);
      if (row < 2) {
        EXPECT_TRUE(at.tau.allFinite()) << "a test of torques, too";
      }
    }
    read.expect_all_seen(plan.motion.time.size());
  }
}

TEST(MotionCsv, ReadsBackToTheBitAndIsEmptyWhereThereIsNoFigure) {
  constexpr int kRows = 16;
  for (const Planned& plan : all_planned()) {
    SCOPED_TRACE(plan.task.name);
    test::ReadBack read(motion_csv(plan.task, plan.problem, plan.motion, kRows));
    PlanSampler sampler(plan.task, plan.problem, plan.motion);
    const double start = plan.motion.time.front();
    const double end = plan.motion.time.back();
    for (int row = 0; row < kRows; ++row) {
      const double time = std::clamp(start + (end - start) * row / (kRows - 1), start, end);
      const PlanSample& at = sampler.at(time);
      Cells cells = arm_cells(plan.robot(), at);
      cells["time"] = time;
      if (plan.task.kind != PlanKind::kMove) {
        add_vector(cells, "desired/position", at.desired);
        add_vector(cells, "error/position", at.poses.p_0T - at.desired);
      }
      if (plan.task.kind == PlanKind::kSwitch) {
        add_vector(cells, "target/position", at.target);
        cells["gaze/angle"] = at.gaze;
      }
      if (plan.task.clearance > 0.0) {
        double nearest = INFINITY;
        for (const MovingObstacle& moving : plan.task.scenario.obstacles) {
          const Obstacle obstacle = moving.at(time);
          nearest = std::min(nearest, (at.poses.p_0T - obstacle.center).norm() - obstacle.radius);
          for (std::size_t i = 1; i < plan.robot().joints.size(); ++i)  // the first stands still
            nearest = std::min(nearest, (at.poses.p_0B[i] - obstacle.center).norm() - obstacle.radius);
        }
        EXPECT_EQ(at.clearance, nearest);
        cells["obstacle/distance"] = at.clearance;
      }
      for (int i = 0; i < plan.robot().n() && plan.task.limits.jerk.size() > 0; ++i)
        cells["joint/" + plan.robot().joints[static_cast<std::size_t>(i)].name + "/jerk"] = at.jerk[i];
      expect_row(read, static_cast<std::size_t>(row), cells);
      if (row < 3) {
        EXPECT_TRUE(at.tau.allFinite()) << "a test of torques, too";
      }
    }
    read.expect_all_seen(kRows);
  }
}

/// "FROM:TO FROM:TO" read as the numbers it is of.
std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t colon = word.find(':');
    EXPECT_NE(colon, std::string::npos) << word;
    for (const std::string& part : {word.substr(0, colon), word.substr(colon + 1)}) {
      // std::stod throws at 5e-324.
      const char* end = part.data() + part.size();
      const auto [read, error] = std::from_chars(part.data(), end, numbers.emplace_back());
      EXPECT_TRUE(error == std::errc() && read == end) << part;
    }
  }
  return numbers;
}

void expect_stretches(test::ReadBack& read, std::size_t row, const std::string& column, const LimitUse& use,
                      bool upper) {
  const std::string text = read.table().text(row, read.table().column(column));
  read.text(row, column, text);
  std::vector<double> expected;
  for (const Stretch& stretch : use.stretches) {
    if (stretch.upper != upper) continue;
    expected.push_back(stretch.from);
    expected.push_back(stretch.to);
  }
  const std::vector<double> found = numbers_of(text);
  ASSERT_EQ(found.size(), expected.size()) << column << ", row " << row << ": " << text;
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(found[i]), std::bit_cast<std::uint64_t>(expected[i])) << text;
  }
}

TEST(LimitsCsv, ReadsBackToTheBitAndIsEmptyWhereThereIsNoFigure) {
  std::vector<LimitUse> uses(12);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    LimitUse& use = uses[i];
    const std::string names[] = {"torque", test::kAwkwardText, test::kFormula};
    use.kind = static_cast<LimitKind>(i % 11);
    use.limit = names[i % 3];
    use.part = names[(i + 1) % 3];
    use.unit = names[(i + 2) % 3];
    use.lower = i % 2 == 0 ? test::awkward(i) : test::no_figures()[i % 4];
    use.upper = i % 3 == 0 ? test::no_figures()[i % 4] : test::awkward(i + 1);
    use.from = 0.1 * static_cast<double>(i);
    use.to = i % 4 == 1 ? use.from : use.from + 1.0 / 3.0;
    use.at_knots = test::awkward(i + 2);
    use.between = test::awkward(i + 3);
    use.share = test::awkward(i + 4);
    use.strength = i % 5 == 4 ? INFINITY : test::awkward(i + 5);
    // Times of a scenario: none is below zero.
    for (std::size_t s = 0; s < i % 4; ++s)
      use.stretches.push_back(
          {std::abs(test::awkward(i + s)), std::abs(test::awkward(i + s + 1)), (i + s) % 2 == 0});
  }
  uses.back().at_knots = NAN;
  uses.back().between = -INFINITY;
  test::ReadBack read(limits_csv(uses));
  for (std::size_t row = 0; row < uses.size(); ++row) {
    const LimitUse& use = uses[row];
    read.text(row, "limit", use.limit);
    read.text(row, "kind", name(use.kind));
    read.text(row, "part", use.part);
    read.text(row, "unit", use.unit);
    read.number(row, "lower", use.lower);
    read.number(row, "upper", use.upper);
    read.number(row, "from", use.from);
    read.number(row, "to", use.to);
    read.number(row, "at_knots", use.at_knots);
    read.number(row, "between_knots", use.from < use.to ? use.between : NAN);
    read.number(row, "active", use.share);
    read.number(row, "strength", use.strength);
    expect_stretches(read, row, "active_lower", use, false);
    expect_stretches(read, row, "active_upper", use, true);
  }
  read.expect_all_seen(uses.size());
  EXPECT_EQ(read.table().header().size(), limits_columns().size());
}

}  // namespace plan_files_test
}  // namespace armtune::internal
