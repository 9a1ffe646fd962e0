#include "tuner/planning/transcription/trajectory_program.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "core/trajectory/linear_acceleration.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"
#include "tests/sim/cell/rods.hpp"
#include "tuner/planning/transcription/arm_terms.hpp"
#include "tuner/planning/transcription/state_term.hpp"

namespace armtune::internal {
namespace trajectory_program_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::WorstError;

Path circle(const Vec3& center, double radius, double frequency) {
  Path path;
  path.center = center;
  path.frequency = frequency;
  path.terms = {{1, Vec3(radius, 0.0, 0.1 * radius), Vec3(0.0, radius, 0.0)}};
  return path;
}

/// Every kind of term at once, two free phases and a fixed one, jerk limits, and a path coordinate.
TrajectoryTask everything(const RobotModel& arm) {
  TrajectoryTask task;
  task.chain = arm.chain;
  task.grid.start = 3.0;
  task.grid.phases = {
      {"first", 3, 0.4, true, 0.01, 10.0}, {"second", 2, 0.5, false}, {"third", 2, 0.3, true, 0.01, 10.0}};
  for (int j = 0; j < arm.n(); ++j) {
    Coordinate c;
    c.name = arm.joints[static_cast<std::size_t>(j)].name;
    if (j != 1) c.upper = 3.0 + j;
    if (j % 3 == 0) c.lower = -2.0;
    c.velocity = 2.0 + j;
    c.jerk = j % 2 == 0 ? 50.0 : INFINITY;
    c.velocity_scale = 1.5;
    c.acceleration_scale = 7.0;
    task.coordinates.push_back(c);
  }
  Coordinate s;
  s.name = "path";
  s.least_velocity = 0.0;
  task.coordinates.push_back(s);
  const int last = task.grid.intervals();
  const Path path = circle(Vec3(0.4, 0.1, 0.5), 0.2, 1.1);
  const Path target = circle(Vec3(0.6, -0.3, 0.0), 0.3, 0.7);
  task.terms = {
      given_state("start", joint_names(arm), position_units(arm), 0,
                  {VectorXd::Constant(arm.n(), 0.1), VectorXd::Constant(arm.n(), 0.2), VectorXd()}),
      torque_limits(arm, {0, last}, 0.9),
      tool_on_path(arm, {1, 4}, path, 0.01),
      tool_on_path(arm, {5, 5}, path, 0.0),
      tool_moves_with_path(arm, last, path),
      tool_path_cost(arm, {0, last}, path, 30.0),
      gaze_within(arm, {4, last}, target, 0.15),
      gaze_cost(arm, {0, last}, target, 20.0),
      clear_of(arm, {0, last}, {"ball", circle(Vec3(0.2, 0.2, 0.8), 0.1, 2.0), 0.05}, 0.2),
      tool_on_curve(
          arm, {2, 6},
          [](double at) {
            return MotionPoint<Vec3>{{at, std::sin(at), 0.3}, {1.0, std::cos(at), 0.0}, Vec3::Zero()};
          },
          0.02),
  };
  Cell cell;
  cell.floor = -0.2;
  cell.parts.push_back({"ball", sphere(0.05), Mat3::Identity(), circle(Vec3(0.3, -0.2, 0.6), 0.2, 1.3)});
  cell.parts.push_back(test::part("post", capsule(0.05, 0.7), Vec3(-0.4, 0.3, 0.4)));
  const auto shaped = std::make_shared<const RobotModel>(test::with_rods(arm));
  for (KnotTerm& term : clear_of_cell(std::make_shared<const ClearanceModel>(shaped, cell), {0, last}, 0.1))
    task.terms.push_back(std::move(term));
  task.smoothness = {0.3, 0.02};
  task.duration_cost = 1.0;
  return task;
}

VectorXd random_unknowns(const TrajectoryProgram& program, std::mt19937& generator) {
  VectorXd z(program.variables());
  for (Index i = 0; i < z.size(); ++i) z[i] = test::random_number(generator, -0.5, 0.5);
  z[z.size() - 2] = 0.5;  // durations
  z[z.size() - 1] = 0.35;
  return z;
}

MatrixXd dense(const BlockRows& rows, Index columns) {
  MatrixXd full = MatrixXd::Zero(rows.rows(), columns);
  VectorXd column;
  for (Index j = 0; j < columns; ++j) {
    rows.multiply(VectorXd::Unit(columns, j), column);
    full.col(j) = column;
  }
  return full;
}

class ProgramOf : public testing::TestWithParam<int> {
 protected:
  RobotModel arm() const {
    return GetParam() == 0   ? test::ur10()
           : GetParam() == 1 ? test::seven_joint_arm()
                             : test::random_arm(4, 5, true);
  }
};

TEST_P(ProgramOf, JacobiansAreTheRowsDifferences) {
  const RobotModel robot = arm();
  std::mt19937 generator(11);
  TrajectoryProgram program(everything(robot));
  const VectorXd z = random_unknowns(program, generator);
  VectorXd residual, row;
  program.linearize(z, residual, row);
  const MatrixXd R = dense(program.residuals, z.size());
  const MatrixXd G = dense(program.rows, z.size());
  VectorXd plain_residual, plain_row;
  program.evaluate(z, plain_residual, plain_row);
  EXPECT_LE((residual - plain_residual).lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_LE((row - plain_row).lpNorm<Eigen::Infinity>(), 1e-12);
  WorstError worst_residual("residuals", 1e-7);
  WorstError worst_row("rows", 1e-7);
  for (Index j = 0; j < z.size(); ++j) {
    const auto along = [&](bool rows) {
      return test::derivative(
          [&](double h) {
            program.evaluate(z + h * VectorXd::Unit(z.size(), j), plain_residual, plain_row);
            return rows ? plain_row : plain_residual;
          },
          1e-4);
    };
    worst_residual.compare(VectorXd(R.col(j)), along(false), "column " + std::to_string(j), 1.0);
    worst_row.compare(VectorXd(G.col(j)), along(true), "column " + std::to_string(j), 1.0);
  }
}

TEST_P(ProgramOf, CurvatureIsTheDifferenceOfTheRowsGradient) {
  const RobotModel robot = arm();
  std::mt19937 generator(12);
  TrajectoryProgram program(everything(robot));
  const VectorXd z = random_unknowns(program, generator);
  VectorXd y(program.rows.rows());
  for (Index i = 0; i < y.size(); ++i) y[i] = test::random_number(generator, -1.0, 1.0);
  VectorXd weights(program.residuals.rows());
  for (Index i = 0; i < weights.size(); ++i) weights[i] = test::random_number(generator, -1.0, 1.0);
  program.curve(z, weights, y);
  WorstError worst("curvature", 1e-4);  // half of it is made of one-sided differences of 1e-6 itself
  VectorXd residual, row;
  for (Index j = 0; j < z.size(); ++j) {
    VectorXd column = VectorXd::Zero(z.size());
    program.curvature.add_product(VectorXd::Unit(z.size(), j), column);
    const VectorXd expected = test::derivative(
        [&](double h) {
          program.linearize(z + h * VectorXd::Unit(z.size(), j), residual, row);
          VectorXd gradient = VectorXd::Zero(z.size());
          program.rows.add_transposed(y, gradient);
          program.residuals.add_transposed(weights, gradient);
          return gradient;
        },
        1e-4);
    worst.compare(column, expected, "column " + std::to_string(j), 1.0);
  }
}

TEST_P(ProgramOf, TakesAMotionApartAndPutsItTogether) {
  const RobotModel robot = arm();
  std::mt19937 generator(13);
  const TrajectoryProgram program(everything(robot));
  const VectorXd z = random_unknowns(program, generator);
  EXPECT_LE((program.unknowns(program.trajectory(z)) - z).lpNorm<Eigen::Infinity>(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Arms, ProgramOf, testing::Range(0, 3));

TEST(TrajectoryProgram, BetweenKnotsPositionsAreInTheHullOfTheRowsThatLimitThem) {
  TrajectoryTask task;
  task.grid.phases = {{"only", 1, 0.7, false}};
  Coordinate c;
  c.name = "q";
  c.lower = -4.0;
  c.upper = 2.0;
  task.coordinates = {c};
  TrajectoryProgram program(task);
  const double h = 0.7;
  const MotionPoint<double> start{0.3, -1.1, 2.5};
  const auto at = [&](double s) { return linear_acceleration(start, -3.5, h, s); };
  Trajectory motion;
  motion.time = {0.0, h};
  motion.durations = {h};
  motion.position = Eigen::RowVector2d(at(0.0).position, at(h).position);
  motion.velocity = Eigen::RowVector2d(at(0.0).velocity, at(h).velocity);
  motion.acceleration = Eigen::RowVector2d(at(0.0).acceleration, at(h).acceleration);
  VectorXd residual, row;
  program.evaluate(program.unknowns(motion), residual, row);
  std::vector<double> control = {motion.position(0, 0)};
  for (Index i = 0; i < row.size(); ++i) {
    // Those at the knots come behind.
    if (program.meaning(i).limit == "position" && control.size() < 3)
      control.push_back(program.natural(i, row[i]));
  }
  control.push_back(motion.position(0, 1));
  ASSERT_EQ(control.size(), 4U);
  for (const double u : {0.1, 0.35, 0.6, 0.9}) {
    const double v = 1.0 - u;
    const double bernstein = v * v * v * control[0] + 3.0 * u * v * v * control[1] +
                             3.0 * u * u * v * control[2] + u * u * u * control[3];
    EXPECT_NEAR(bernstein, at(u * h).position, 1e-14) << u;
  }
}

TEST(TrajectoryProgram, NamesEveryRow) {
  const RobotModel arm = test::ur10();
  TrajectoryProgram program(everything(arm));
  std::map<std::string, int> found;
  for (Index i = 0; i < program.rows.rows(); ++i) {
    const RowMeaning meaning = program.meaning(i);
    ++found[meaning.limit];
    EXPECT_GE(meaning.knot, 0);
    EXPECT_LE(meaning.knot, 7);
  }
  EXPECT_EQ(found["continuity between knots"], 7 * 7 * 2);
  EXPECT_EQ(found["jerk"], 7 * 3);
  EXPECT_EQ(found["velocity"], 6 * 8 + 8 + 7 * 7);  // at the knots, and inside the intervals
  EXPECT_EQ(found["position"], 5 * 8 + 5 * 7 * 2);  // of all but one joint
  EXPECT_EQ(found["torque"], 6 * 8);
  EXPECT_EQ(found["tool path"], 4 * 3 + 3 + 5 * 3);
  EXPECT_EQ(found["gaze"], 4);
  EXPECT_EQ(found["distance to ball"], (5 + 1) * 8);  // the first joint stays; the tool counts
  EXPECT_EQ(found["duration of phase first"], 1);
}

/// A motion that satisfies the dynamics exactly: knots of one cubic a piece.
Trajectory wavy() {
  Trajectory t;
  t.durations = {0.6, 0.4};
  t.time = {0.0, 0.3, 0.6, 0.8, 1.0};
  t.position.setZero(1, 5);
  t.velocity.setZero(1, 5);
  t.acceleration.resize(1, 5);
  t.acceleration << 1.0, -2.0, 0.5, 3.0, -1.0;
  for (Index k = 0; k < 4; ++k) {
    const double h = t.time[static_cast<std::size_t>(k) + 1] - t.time[static_cast<std::size_t>(k)];
    const double a0 = t.acceleration(0, k);
    const double a1 = t.acceleration(0, k + 1);
    t.position(0, k + 1) = t.position(0, k) + h * t.velocity(0, k) + h * h * (a0 / 3.0 + a1 / 6.0);
    t.velocity(0, k + 1) = t.velocity(0, k) + h * (a0 + a1) / 2.0;
  }
  return t;
}

TEST(Trajectory, StaysTheSameMotionOnAFinerGrid) {
  const Trajectory coarse = wavy();
  TimeGrid grid;
  grid.phases = {{"a", 6, 0.6, false}, {"b", 4, 0.4, false}};
  const Trajectory fine = on_grid(coarse, grid);
  ASSERT_EQ(fine.time.size(), 11u);
  TrajectoryTask task;
  task.coordinates.resize(1);
  task.grid = grid;
  TrajectoryProgram program(task);
  VectorXd residual, row;
  program.evaluate(program.unknowns(fine), residual, row);
  EXPECT_LE(row.lpNorm<Eigen::Infinity>(), 1e-15);  // the dynamics still hold
  EXPECT_NEAR(fine.position(0, 10), coarse.position(0, 4), 1e-15);
  for (const double t : {0.1, 0.45, 0.77}) {
    EXPECT_NEAR(point_at(fine, t).position[0], point_at(coarse, t).position[0], 1e-15);
    EXPECT_NEAR(point_at(fine, t).velocity[0],
                test::derivative([&](double h) { return point_at(coarse, t + h).position[0]; }), 1e-11);
    EXPECT_NEAR(point_at(fine, t).acceleration[0],
                test::derivative([&](double h) { return point_at(coarse, t + h).velocity[0]; }), 1e-11);
  }
}

}  // namespace trajectory_program_test
}  // namespace armtune::internal
