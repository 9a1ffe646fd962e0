#include "tuner/report/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/kinematics.hpp"
#include "core/trajectory/polyline.hpp"
#include "tests/sim/cell/rods.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/report/support/decode.hpp"
#include "tests/tuner/report/support/recorded.hpp"
#include "tuner/report/base64.hpp"

namespace armtune::internal::report {
namespace scene_test {

using test::TemporaryFolder;

/// A binary STL of these corners, nine numbers a triangle; `claimed`: how many triangles its header says it
/// has.
std::string stl(const std::vector<float>& corners, std::uint32_t claimed) {
  std::string text(80, 'h');
  const auto put = [&text](const void* from, std::size_t size) {
    text.append(static_cast<const char*>(from), size);
  };
  put(&claimed, 4);
  for (std::size_t i = 0; i < corners.size(); i += 9) {
    text.append(12, '\0');
    put(&corners[i], 36);
    text.append(2, '\0');
  }
  return text;
}

const std::vector<float> kCorners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 1, 0, 2, -1.5F};

TEST(Scene, ReadsBackAsItWasWritten) {
  const TemporaryFolder folder;
  Scene scene =
      scene_of({test::scenario_of("obstacle_pass"), test::scenario_of("moving_target")},
               {{"start", "start", "start/errors.csv"}, {"<b>tuned</b>", ".", "errors.csv", 3}}, 0.325);
  scene.scenarios[0].name = "</script> \"named\"";
  const std::string text = scene_json(scene);
  EXPECT_EQ(text.find('<'), std::string::npos);
  const Scene read = read_scene(folder.write("scene.json", text));
  EXPECT_EQ(scene_json(read), text);
  EXPECT_EQ(read.sets[1].name, "<b>tuned</b>");
  EXPECT_EQ(read.sets[0].point, std::nullopt);
  EXPECT_EQ(read.sets[1].point, 3);
  EXPECT_EQ(read.scenarios[0].name, "</script> \"named\"");
  EXPECT_EQ(read.arms.size(), 1U) << "one arm in both scenarios is written once";
  EXPECT_EQ(read.scenarios[0].influence_radius, 0.325);
  EXPECT_EQ(read.scenarios[1].influence_radius, 0.0) << "there is nothing to stay away from";
  const auto& obstacles = test::scenario_of("obstacle_pass").obstacles;
  ASSERT_EQ(read.scenarios[0].obstacles.size(), obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    EXPECT_EQ(read.scenarios[0].obstacles[i].radius, obstacles[i].radius);
    for (const double t : {0.0, 3.7, 41.0}) {
      EXPECT_EQ(read.scenarios[0].obstacles[i].path.at(t).position, obstacles[i].path.at(t).position);
    }
  }
}

TEST(Scene, ObstaclesHaveTheirBodiesAndOlderFilesPoints) {
  const TemporaryFolder folder;
  Scene scene = scene_of({test::scenario_of("obstacle_pass")}, {}, 0.325);
  scene.scenarios[0].obstacles[1].radius = 0.15;
  std::string text = scene_json(scene);
  EXPECT_EQ(read_scene(folder.write("scene.json", text)).scenarios[0].obstacles[1].radius, 0.15);
  // As it was before obstacles had a radius: a list of paths.
  const std::string with = "{\"radius\":0.0,\"path\":";
  const std::size_t at = text.find(with);
  ASSERT_NE(at, std::string::npos) << text.substr(0, 2000);
  const std::size_t end = text.find("}]}},", at);  // of terms, path and obstacle
  ASSERT_NE(end, std::string::npos);
  text.erase(end + 3, 1);
  text.erase(at, with.size());
  const Scene older = read_scene(folder.write("scene.json", text));
  EXPECT_EQ(older.scenarios[0].obstacles[0].radius, 0.0);
  EXPECT_EQ(older.scenarios[0].obstacles[0].path.at(3.0).position,
            scene.scenarios[0].obstacles[0].path.at(3.0).position);
}

TEST(Scene, TheCellReadsBackWithItsShapesAndPlaces) {
  const TemporaryFolder folder;
  Scenario scenario = test::scenario_of("moving_target");
  Cell cell;
  cell.floor = -0.25;
  cell.parts.push_back(test::part("table", box({0.6, 0.8, 0.05}), {0.7, 0.0, -0.1}));
  cell.parts.push_back(test::part("post", capsule(0.05, 1.0), {-0.5, 0.4, 0.3}));
  const Path round{Vec3(0.0, 0.0, 0.8), 1.3, 0.0, {{1, Vec3(0.6, 0.0, 0.0), Vec3(0.0, 0.6, 0.0)}}};
  cell.parts.push_back({"ball", sphere(0.1), Mat3::Identity(), round});
  scenario.clearance = std::make_shared<const ClearanceModel>(scenario.robot, cell);
  const Scene read = read_scene(folder.write("scene.json", scene_json(scene_of({scenario}, {}, 0.0))));
  const SceneScenario& shown = read.scenarios[0];
  ASSERT_TRUE(shown.floor);
  EXPECT_EQ(*shown.floor, -0.25);
  ASSERT_EQ(shown.cell.size(), 3U);
  const auto expect = [&shown](std::size_t i, const char* name, ShapeKind kind,
                               const std::vector<double>& size) {
    EXPECT_EQ(shown.cell[i].name, name);
    EXPECT_EQ(shown.cell[i].shape.kind, kind) << name;
    EXPECT_EQ(shown.cell[i].shape.size, size) << name;
  };
  expect(0, "table", ShapeKind::kBox, {0.6, 0.8, 0.05});
  expect(1, "post", ShapeKind::kCapsule, {0.05, 1.0});
  expect(2, "ball", ShapeKind::kSphere, {0.1});
  for (const double t : {0.0, 2.9}) {
    EXPECT_EQ(shown.cell[0].path.at(t).position, Vec3(0.7, 0.0, -0.1));
    EXPECT_EQ(shown.cell[2].path.at(t).position, round.at(t).position);
  }
}

TEST(Scene, PathsThroughKnotsReadBackAndAreDrawnWhole) {
  const TemporaryFolder folder;
  Scene scene = scene_of({test::scenario_of("moving_target")}, {}, 0.325);
  for (const bool closed : {false, true}) {
    const std::vector<Vec3> corners = {{0, 0, 0}, {0.4, 0, 0.1}, {0.4, 0.5, 0}};
    Path& path = scene.scenarios[0].path;
    path = {};
    path.spline = std::make_shared<const PositionSpline>(polyline(corners, 0.2, 0.03, closed));
    const std::string text = scene_json(scene);
    const Scene read = read_scene(folder.write("scene.json", text));
    EXPECT_EQ(scene_json(read), text);
    for (const double t : {0.0, 1.7, 3.1, 41.0})
      EXPECT_EQ(read.scenarios[0].path.at(t).position, path.at(t).position);
    // No step of the drawing is longer than a hundredth of the way, back to its beginning included.
    const auto drawn = drawn_path(path);
    for (std::size_t i = 0; i < drawn.size(); ++i)
      EXPECT_LT((drawn[i] - drawn[(i + 1) % drawn.size()]).norm(), 0.015) << closed << ' ' << i;
    double nearest = 1.0;
    for (const Vec3& point : drawn) nearest = std::min(nearest, (point - corners[1]).norm());
    EXPECT_LT(nearest, 0.03) << "it comes by the middle corner";
  }
  std::string text = scene_json(scene);
  text.replace(text.find("\"loops\":true"), 12, "\"loops\":7");
  EXPECT_THAT([&] { read_scene(folder.write("scene.json", text)); },
              test::refused_at({.file = folder / "scene.json"}));
}

TEST(Scene, NamesWhatIsWrongInAFile) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text) {
    return test::input_error([&] { read_scene(folder.write("scene.json", text)); });
  };
  EXPECT_THAT(refusal("{\"sets\": [], \"scenarios\": []}"),
              test::refused_at({.file = folder / "scene.json", .line = 1, .limit = "the key 'robots'"}));
  std::string text = scene_json(test::recorded().scene);
  text.replace(text.find("\"robot\":0"), 9, "\"robot\":7");
  EXPECT_THAT(refusal(text), test::refused_at({.key = "scenarios/0/robot", .value = "7"}));
  for (const char* folder_elsewhere : {"../secret", "/etc", "start/../.."}) {
    text = scene_json(test::recorded().scene);
    const auto at = text.find("\"folder\":\"") + 10;
    text.replace(at, text.find('"', at) - at, folder_elsewhere);
    EXPECT_THAT(refusal(text), test::refused_at({.key = "sets/0/folder", .value = folder_elsewhere}));
  }
}

TEST(Arm, HasTheFramesOfTheChain) {
  const RobotModel& model = *test::recorded().scenario.robot;
  const Arm arm = arm_of(model);
  ASSERT_EQ(arm.joints.size(), static_cast<std::size_t>(model.n()));
  JointVector q(model.n());
  for (int i = 0; i < model.n(); ++i) q[i] = 0.3 * i - 0.8;
  Poses poses;
  forward_kinematics(model.chain, q, poses);
  const auto frames = test::frames(arm, {q.data(), q.data() + q.size()});
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_LT((frames[i].translation() - poses.p_0B[i]).norm(), 1e-13) << "a few roundings of metres";
    EXPECT_LT((frames[i].linear() - poses.R_0B[i]).norm(), 1e-13);
  }
  EXPECT_LT((frames.back() * arm.tool.p - poses.p_0T).norm(), 1e-13);
}

TEST(Arm, WithoutShapesIsCapsulesFromJointToJoint) {
  RobotModel model = *test::recorded().scenario.robot;
  model.shapes.clear();
  const Arm arm = arm_of(model);
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const auto shape = std::find_if(arm.shapes.begin(), arm.shapes.end(),
                                    [i](const ArmShape& s) { return s.joint == static_cast<int>(i); });
    ASSERT_NE(shape, arm.shapes.end()) << "every link is drawn";
    const Vec3 end = i + 1 < arm.joints.size() ? arm.joints[i + 1].pose.p : arm.tool.p;
    if (end.norm() < 1e-6) {
      EXPECT_EQ(shape->kind, ShapeKind::kSphere);
      continue;
    }
    ASSERT_EQ(shape->kind, ShapeKind::kCapsule);
    const Vec3 half = shape->pose.q * Vec3(0, 0, shape->size[1] / 2);
    EXPECT_LT((shape->pose.p - half).norm(), 1e-12) << "begins at its own joint";
    EXPECT_LT((shape->pose.p + half - end).norm(), 1e-12) << "ends at the next one";
    EXPECT_GT(shape->size[0], 0.0);
  }
}

TEST(Arm, MeshesAreLoadedOrTheirLinksAreCapsules) {
  const TemporaryFolder folder;
  folder.write("good.stl", stl(kCorners, 2));
  folder.write("bad.stl", "solid of another kind");
  RobotModel model = *test::recorded().scenario.robot;
  model.source = folder / "arm.urdf";
  model.shapes.clear();
  const auto add = [&model](int link, const char* file, bool collision) {
    Shape shape;
    shape.body = link;
    shape.link = link;
    shape.collision = collision;
    shape.kind = ShapeKind::kMesh;
    shape.size = {2, 2, 2};
    shape.file = file;
    model.shapes.push_back(shape);
  };
  add(0, "good.stl", false);
  add(0, "good.stl", true);  // not drawn twice
  add(1, "bad.stl", false);
  add(2, "missing.dae", false);
  add(2, "missing.stl", true);
  add(3, "missing.dae", false);
  add(3, "good.stl", true);
  const Arm arm = arm_of(model);
  std::vector<ShapeKind> kinds(4, ShapeKind::kBox);
  EXPECT_EQ(
      std::count_if(arm.shapes.begin(), arm.shapes.end(), [](const ArmShape& s) { return s.joint == 0; }), 1);
  EXPECT_EQ(arm.undrawn, 3U) << "one of link 1, two of link 2; link 3 has its collision body";
  for (const ArmShape& shape : arm.shapes) {
    if (shape.joint >= 0 && shape.joint < 4) kinds[static_cast<std::size_t>(shape.joint)] = shape.kind;
    if (shape.joint == 0) {
      EXPECT_EQ(shape.triangles, base64_f32(kCorners));
      EXPECT_THAT(shape.size, testing::ElementsAre(2, 2, 2));
    }
  }
  EXPECT_EQ(kinds[0], ShapeKind::kMesh);
  EXPECT_EQ(kinds[1], ShapeKind::kCapsule);
  EXPECT_EQ(kinds[2], ShapeKind::kCapsule);
  EXPECT_EQ(kinds[3], ShapeKind::kMesh);
}

}  // namespace scene_test
}  // namespace armtune::internal::report
