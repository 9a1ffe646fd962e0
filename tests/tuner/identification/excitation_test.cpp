#include "tuner/identification/excitation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/read_back.hpp"
#include "tuner/identification/excitation_design.hpp"

namespace armtune::internal {
namespace excitation_test {

using test::WorstError;

Excitation some_excitation(int n) {
  std::mt19937 generator(841);
  Excitation e;
  e.center = test::random_vector(generator, n, 1.0);
  e.sine = Eigen::MatrixXd::Random(n, 3);
  e.cosine = Eigen::MatrixXd::Random(n, 3);
  return e;
}

TEST(Excitation, ItsVelocityAndAccelerationAreItsDerivatives) {
  const Excitation e = some_excitation(4);
  WorstError velocity("velocity", 1e-7);  // h^4 / 30 of the fifth derivative; the fade is of fifth degree
  WorstError acceleration("acceleration", 1e-7);
  for (double t = 0.05; t < 20.0; t += 0.37) {
    const auto q = [&](double h) { return JointVector(e.at(t + h).position); };
    const auto qd = [&](double h) { return JointVector(e.at(t + h).velocity); };
    velocity.compare(JointVector(e.at(t).velocity), JointVector(test::derivative(q)), "fade and middle", 1.0);
    acceleration.compare(JointVector(e.at(t).acceleration), JointVector(test::derivative(qd)),
                         "fade and middle", 1.0);
  }
}

TEST(Excitation, BeginsAndEndsAtRestInItsCenter) {
  const Excitation e = some_excitation(4);
  for (const double t : {-1.0, 0.0, 20.0, 21.0}) {
    EXPECT_LT((e.at(t).position - e.center).norm(), 1e-12);
    EXPECT_LT(e.at(t).velocity.norm(), 1e-12);
    EXPECT_LT(e.at(t).acceleration.norm(), 1e-10);
  }
}

TEST(ExcitationCsv, ReadsBackToTheBit) {
  const std::vector<std::string> joints = {"a", "b", "c"};
  Excitation e = some_excitation(3);
  e.duration = 5.0;
  e.center[0] = 1e300;
  const double period = 1.0 / 300.0;
  test::ReadBack read(excitation_csv(e, joints, period));
  for (std::size_t row = 0; row <= 1500; ++row) {
    const double t = static_cast<double>(row) * period;
    const MotionPoint<JointVector> point = e.at(t);
    read.number(row, "time", t);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const std::string joint = "joint/" + joints[j] + "/";
      const auto i = static_cast<Eigen::Index>(j);
      read.number(row, joint + "position", point.position[i]);
      read.number(row, joint + "velocity", point.velocity[i]);
      read.number(row, joint + "acceleration", point.acceleration[i]);
    }
  }
  read.expect_all_seen(1501);
}

TEST(Excitation, ItsFileReadsBackToTheBit) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> joints = {"a", "b", "c"};
  const Excitation e = some_excitation(3);
  const Excitation back = load_excitation(folder.write("e.yaml", excitation_yaml(e, joints)), joints);
  EXPECT_EQ(back.center, e.center);
  EXPECT_EQ(back.sine, e.sine);
  EXPECT_EQ(back.cosine, e.cosine);
  EXPECT_EQ(back.frequency, e.frequency);
  EXPECT_EQ(back.duration, e.duration);
  EXPECT_EQ(back.fade, e.fade);
  EXPECT_THAT(test::refusal([&] {
                load_excitation(folder / "e.yaml", {"a", "b"});
              }),
              testing::HasSubstr("e.yaml"));
}

ExcitationOptions ur10_options() {
  ExcitationOptions options;
  options.center.resize(6);
  options.center << 0.0, -1.5, -1.0, -1.5, 1.5, 0.0;
  options.min_height = 0.1;
  options.evaluations = 1500;
  return options;
}

TEST(Excitation, AShortOneWhoseFileNamesNoFadeFadesWithinItsDuration) {
  const test::TemporaryFolder folder;
  const std::string text = "frequency: 0.5\nduration: 3\ncenter: [0]\nsine: {a: [0.1]}\ncosine: {a: [0]}\n";
  EXPECT_EQ(load_excitation(folder.write("e.yaml", text), {"a"}).fade, 0.75);
  EXPECT_THAT(test::refusal([&] { load_excitation(folder.write("e.yaml", text + "fade: 2\n"), {"a"}); }),
              testing::HasSubstr("fade"));
}

TEST(ExcitationDesign, KeepsTheLimitsAtEveryInstantAndBeatsRandomSeries) {
  const RobotModel arm = test::ur10();
  const std::atomic<bool> never{false};
  const ExcitationDesign design = design_excitation(arm, ur10_options(), never);
  EXPECT_LT(design.use.condition, 0.8 * design.random_condition);
  for (double t = 0.0; t <= 20.0; t += 0.01) {
    const MotionPoint<JointVector> point = design.excitation.at(t);
    const JointVector torque =
        test::inverse_dynamics_at(arm.chain, point.position, point.velocity, point.acceleration);
    // Between the instants that the design looks at a peak may be a little higher.
    EXPECT_LE(point.velocity.cwiseQuotient(arm.velocity_limits()).cwiseAbs().maxCoeff(), 0.81) << t;
    EXPECT_LE(torque.cwiseQuotient(arm.effort_limits()).cwiseAbs().maxCoeff(), 0.81) << t;
    EXPECT_LE((point.position - ur10_options().center).cwiseAbs().maxCoeff(), 1.01) << t;
    EXPECT_GE(test::poses_at(arm.chain, point.position).p_0T.z(), 0.095) << t;
  }
}

TEST(ExcitationDesign, ALongTrajectoryKeepsTheLimitsToo) {
  const RobotModel arm = test::ur10();
  const std::atomic<bool> never{false};
  ExcitationOptions options = ur10_options();
  options.duration = 300.0;  // thirty periods
  options.evaluations = 100;
  const ExcitationDesign design = design_excitation(arm, options, never);
  for (double t = 0.0; t <= options.duration; t += 0.013) {
    const MotionPoint<JointVector> point = design.excitation.at(t);
    EXPECT_LE(point.velocity.cwiseQuotient(arm.velocity_limits()).cwiseAbs().maxCoeff(), 0.81) << t;
    EXPECT_LE((point.position - options.center).cwiseAbs().maxCoeff(), 1.01) << t;
  }
}

TEST(ExcitationDesign, RepeatsItselfAndRefusesWhatCannotBe) {
  const RobotModel arm = test::ur10();
  const std::atomic<bool> never{false};
  ExcitationOptions options = ur10_options();
  options.evaluations = 200;
  EXPECT_EQ(design_excitation(arm, options, never).excitation.sine,
            design_excitation(arm, options, never).excitation.sine);
  options.min_height = 1.0;
  EXPECT_THAT(test::refusal([&] { design_excitation(arm, options, never); }),
              testing::HasSubstr("at least 1"));
  options.min_height = 0.1;
  options.center[2] = 4.0;
  EXPECT_THAT(test::refusal([&] { design_excitation(arm, options, never); }),
              testing::HasSubstr("elbow_joint"));
}

}  // namespace excitation_test
}  // namespace armtune::internal
