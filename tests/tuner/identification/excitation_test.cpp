#include "tuner/identification/excitation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"
#include "tests/sim/cell/rods.hpp"
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
  const auto read_for_two = [&] { load_excitation(folder / "e.yaml", {"a", "b"}); };
  EXPECT_THAT(read_for_two,
              test::refused_at({.file = folder / "e.yaml", .key = testing::StartsWith("center")}));
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
  EXPECT_THAT(
      [&] { load_excitation(folder.write("e.yaml", text + "fade: 2\n"), {"a"}); },
      test::refused_at(
          {.file = folder / "e.yaml", .line = 6, .key = "fade", .value = "2", .limit = "0.001 to 1.5"}));
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
  const InputError high = test::input_error([&] { design_excitation(arm, options, never); });
  EXPECT_THAT(high, test::refused_at({.file = "", .key = "center"}));
  EXPECT_THAT(high.what(), testing::HasSubstr("at least 1 is required"));
  options.min_height = 0.1;
  options.center[2] = 4.0;
  EXPECT_THAT([&] { design_excitation(arm, options, never); },
              test::refused_at({.key = "center/elbow_joint", .value = "4"}));
}

KeptDistances distances_of(const std::string& robot, const Cell& cell = {}) {
  return {std::make_shared<const ClearanceModel>(load_robot(robot), cell), 0.02};
}

/// Options of a design around a centre where the UR10's arm is folded, so that large motions of the elbow put
/// the forearm onto the upper arm.
ExcitationOptions folding_options() {
  ExcitationOptions options;
  options.center.resize(6);
  options.center << 0.0, -1.571, -2.094, -1.571, 1.571, 0.0;
  options.evaluations = 300;
  return options;
}

// The distances are computed here without the bounds that avoid most computations.
TEST(ExcitationDesign, KeepsLinksApartThatItWouldOtherwiseFoldOntoEachOther) {
  const std::atomic<bool> never{false};
  ExcitationOptions options = folding_options();
  const KeptDistances kept = distances_of("ur10");
  const RobotModel& arm = kept.model->robot();
  const ExcitationDesign free = design_excitation(arm, options, never);
  EXPECT_FALSE(distances_along(free.excitation, kept).too_near.empty()) << "or this test shows nothing";
  options.kept = kept;
  const ExcitationDesign design = design_excitation(arm, options, never);
  EXPECT_TRUE(design.distances.too_near.empty());
  EXPECT_TRUE(std::isfinite(design.use.condition));
  const auto& pairs = kept.model->pairs();
  const auto distances_at = [&](double t) {
    const Poses poses = test::poses_at(arm.chain, design.excitation.at(t).position);
    std::vector<double> distances;
    for (const ContactPair& pair : pairs)
      distances.push_back(kept.model->distance(pair, poses, Vec3::Zero()).distance);
    return distances;
  };
  const std::vector<double> center = distances_at(0.0);
  double least = 1.0;
  for (int sample = 0; sample <= 1000; ++sample) {
    const std::vector<double> distances = distances_at(0.02 * sample);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      EXPECT_GE(distances[k], std::min(0.005, 0.5 * center[k]) - 1e-8)  // distances are known to 1e-9 m
          << kept.model->name(pairs[k]) << " at sample " << sample;
      least = std::min(least, distances[k]);
    }
  }
  // The samples here are a tenth of those of distances_along, so the smallest distance can only be larger.
  EXPECT_LE(least_of(Clearance::kSelf, design.distances.nearest).distance, least + 1e-8);
  EXPECT_THAT(contact_sentences(design.distances.nearest, kept),
              testing::AllOf(testing::HasSubstr("between links"), testing::HasSubstr("no cell is known")));
}

TEST(ExcitationDesign, KeepsTheClearanceFromTheCellOrRefusesTheCentre) {
  const std::atomic<bool> never{false};
  ExcitationOptions options = ur10_options();
  options.evaluations = 200;
  options.min_height = -1e9;
  const auto arm = load_robot("ur10");
  const auto tool_at = [&arm](const JointVector& q) { return Vec3(test::poses_at(arm->chain, q).p_0T); };
  const Vec3 center = tool_at(options.center);
  const ExcitationDesign free = design_excitation(*arm, options, never);
  // A ball where the free motion has the tool farthest from the centre.
  Vec3 far = center;
  for (double t = 0.0; t <= 20.0; t += 0.01) {
    const Vec3 tool = tool_at(free.excitation.at(t).position);
    if ((tool - center).norm() > (far - center).norm()) far = tool;
  }
  const auto with_ball_at = [](const Vec3& place) {
    Cell cell;
    cell.parts = {test::part("ball", sphere(0.05), place)};
    return distances_of("ur10", cell);
  };
  options.kept = with_ball_at(far);
  EXPECT_FALSE(distances_along(free.excitation, options.kept).too_near.empty());
  const ExcitationDesign design = design_excitation(*arm, options, never);
  EXPECT_GE(least_of(Clearance::kCell, design.distances.nearest).distance, 0.02);
  for (double t = 0.0; t <= 20.0; t += 0.01) {
    // The tool frame's origin lies in the arm's shapes, or at most 1 mm off them; the motion between the
    // instants at which distances are computed is less than another millimetre towards the ball.
    EXPECT_GE((tool_at(design.excitation.at(t).position) - far).norm(), 0.068) << t;
  }
  options.kept = with_ball_at(center);
  const InputError error = test::input_error([&] { design_excitation(*arm, options, never); });
  EXPECT_THAT(error, test::refused_at({.file = "", .key = "center"}));
  EXPECT_THAT(error.what(), testing::HasSubstr("ball"));
}

TEST(ExcitationDesign, WithoutANearContactTheDistancesChangeNothing) {
  const std::atomic<bool> never{false};
  ExcitationOptions options = ur10_options();
  options.evaluations = 100;
  options.amplitude = 0.02;
  const KeptDistances kept = distances_of("ur10");
  const ExcitationDesign free = design_excitation(kept.model->robot(), options, never);
  options.kept = kept;
  const ExcitationDesign design = design_excitation(kept.model->robot(), options, never);
  EXPECT_EQ(design.scale, 1.0);
  EXPECT_EQ(design.excitation.sine, free.excitation.sine);
}

TEST(ExcitationClearance, NamesEveryPairThatComesTooNear) {
  const KeptDistances kept = distances_of("ur10");
  Excitation e;
  e.center.resize(6);
  e.center << 0.0, -1.571, 0.0, -1.571, 1.571, 0.0;
  e.sine = Eigen::MatrixXd::Zero(6, 1);
  e.cosine = Eigen::MatrixXd::Zero(6, 1);
  e.sine(2, 0) = 3.1;  // the elbow folds completely, to both sides
  const DistancesAlong along = distances_along(e, kept);
  ASSERT_GE(along.too_near.size(), 2U) << "forearm and wrists on the upper arm or the shoulder";
  const std::string clause = too_near_clause(along.too_near, kept);
  for (const LeastClearance& found : along.too_near) {
    EXPECT_THAT(clause, testing::HasSubstr(kept.model->name(*found.pair)));
    const Poses poses = test::poses_at(kept.model->robot().chain, e.at(found.time).position);
    EXPECT_NEAR(kept.model->distance(*found.pair, poses, Vec3::Zero()).distance, found.distance, 1e-9);
  }
  const Excitation shrunk = shrunk_to_keep(e, kept);
  EXPECT_TRUE(distances_along(shrunk, kept).too_near.empty());
  EXPECT_GT(shrunk.sine(2, 0), 1.0) << "the elbow can turn by more than a radian from the stretched arm";
}

}  // namespace excitation_test
}  // namespace armtune::internal
