// Named curves are the harmonics that a textbook writes for them, and mistakes in them are named.

#include "sim/scenario/path_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/scenario/named_paths_file.hpp"
#include "sim/yaml/document.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace path_file_test {

using test::refused_at;
using testing::AllOf;
using testing::HasSubstr;
constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-12;

Path path_of(const std::string& text) {
  const yaml::Node node = yaml::parse_text(text, "path.yaml");
  yaml::MapReader map(node);
  std::vector<std::string> inputs;
  Path path = read_path(map, inputs);
  map.finish();
  return path;
}

/// The error in path.yaml with which this text is refused.
InputError error_of(const std::string& text) {
  const InputError error = test::input_error([&text] { path_of(text); });
  EXPECT_EQ(error.place().file, "path.yaml");
  return error;
}

TEST(PathFile, NoNumberIsTooLargeToBeSaid) {
  for (const char* text : {"center: [1e300, -1e300, 0]\n", "center: [1.7e308, 1.7e308, 1.7e308]\n",
                           "center: [0, 0, 0]\nterms: [{order: 1, cos: [0, 1e200, 1e200]}]\nfrequency: 1\n",
                           "polyline: {corners: [[0, 0, 0], [1e250, 1e250, 0]], speed: 1, blend: 0.1}\n"}) {
    const std::string why = error_of(text).what();
    EXPECT_THAT(why, AllOf(testing::ContainsRegex("[0-9]e[+]?[23]"), testing::Not(HasSubstr("inf")),
                           testing::Not(HasSubstr("nan"))));
  }
}

TEST(PathFile, ACircleKeepsItsRadiusAndPlaneAndTurnsRightHandedlyAboutItsNormal) {
  const Vec3 center(0.5, -0.2, 0.7), normal(1.0, 2.0, -0.5);
  const Path path =
      path_of("circle: {center: [0.5, -0.2, 0.7], radius: 0.12, period: 8, normal: [1, 2, -0.5]}\n");
  const Vec3 n = normal.normalized();
  for (double t = 0.0; t < 20.0; t += 0.31) {
    const MotionPoint<Vec3> at = path.at(t);
    EXPECT_NEAR((at.position - center).norm(), 0.12, kRounding);
    EXPECT_NEAR((at.position - center).dot(n), 0.0, kRounding);
    // v = w n x r, with 2 pi in 8 s.
    EXPECT_LT((at.velocity - 2.0 * kPi / 8.0 * n.cross(at.position - center)).norm(), kRounding);
  }
  EXPECT_LT((path.at(8.0).position - path.at(0.0).position).norm(), kRounding);
}

TEST(PathFile, ACircleIsHorizontalAndBeginsOnXUnlessSaidOtherwise) {
  const Path plain = path_of("circle: {center: [1, 2, 3], radius: 0.5, period: 4}\n");
  EXPECT_LT((plain.at(0.0).position - Vec3(1.5, 2.0, 3.0)).norm(), kRounding);
  EXPECT_LT((plain.at(1.0).position - Vec3(1.0, 2.5, 3.0)).norm(), kRounding);
  const Path later = path_of("circle: {center: [1, 2, 3], radius: 0.5, period: 4, start_deg: 90}\n");
  EXPECT_LT((later.at(0.0).position - Vec3(1.0, 2.5, 3.0)).norm(), kRounding);
  const Path about_x = path_of("circle: {center: [0, 0, 0], radius: 1, period: 4, normal: [3, 0, 0]}\n");
  EXPECT_NEAR(about_x.at(0.7).position.x(), 0.0, kRounding);
  const Path tiny = path_of("circle: {center: [0, 0, 0], radius: 1, period: 4, normal: [1.0e-200, 0, 0]}\n");
  EXPECT_LT((tiny.at(0.7).position - about_x.at(0.7).position).norm(), kRounding)
      << "a direction has no size";
  EXPECT_NEAR(about_x.at(0.7).position.norm(), 1.0, kRounding);
}

TEST(PathFile, AnEllipseIsTheAffineImageOfTheUnitCircle) {
  const Path path = path_of(
      "ellipse: {center: [1, 0, 0], axis_1: [0.2, 0, 0.1], axis_2: [0, 0.05, 0], period: 6, start_deg: "
      "30}\n");
  const Vec3 a(0.2, 0.0, 0.1), b(0.0, 0.05, 0.0);
  for (double t = 0.0; t < 12.0; t += 0.37) {
    const Vec3 r = path.at(t).position - Vec3(1.0, 0.0, 0.0);
    const double u = r.dot(a) / a.squaredNorm(), v = r.dot(b) / b.squaredNorm();
    EXPECT_NEAR(u * u + v * v, 1.0, kRounding);
    EXPECT_NEAR(std::remainder(std::atan2(v, u) - (kPi / 6.0 + 2.0 * kPi * t / 6.0), 2.0 * kPi), 0.0, 1e-9);
  }
}

TEST(PathFile, AFigureEightCrossesItsMiddleTwiceAPeriodAndIsSymmetric) {
  const Path path =
      path_of("figure_eight: {center: [0, 1, 2], length: [0.3, 0, 0], width: [0, 0, 0.1], period: 10}\n");
  const Vec3 center(0.0, 1.0, 2.0);
  for (const double t : {0.0, 5.0, 10.0}) EXPECT_LT((path.at(t).position - center).norm(), kRounding);
  EXPECT_NEAR(path.at(2.5).position.x(), 0.3, kRounding) << "as long as it was said to be";
  EXPECT_NEAR(path.at(1.25).position.z(), 2.1, kRounding) << "and as wide";
  for (double t = 0.0; t < 10.0; t += 0.41) {
    const Vec3 r = path.at(t).position - center, half_on = path.at(t + 5.0).position - center;
    // x = L sin a, z = W sin 2a: z^2 / W^2 = 4 s^2 (1 - s^2) with s = x / L.
    const double s = r.x() / 0.3;
    EXPECT_NEAR(r.z() * r.z() / 0.01, 4.0 * s * s * (1.0 - s * s), 1e-9);
    EXPECT_LT((half_on - Vec3(-r.x(), r.y(), r.z())).norm(), 1e-9) << "the other loop is its mirror image";
  }
}

TEST(PathFile, AHeldPointRests) {
  const Path path = path_of("hold: [0.1, 0.2, 0.3]\n");
  for (const double t : {0.0, 1.7, 1e4}) {
    EXPECT_EQ(path.at(t).position, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(path.at(t).velocity, Vec3(0.0, 0.0, 0.0));
  }
}

TEST(PathFile, MistakesAreNamedWithLineAndKey) {
  const auto said = [](const std::string& text) { return error_of(text); };
  EXPECT_THAT(said("circle: {center: [0, 0, 0], radius: 0, period: 4}\n"),
              refused_at({.line = 1, .key = "circle/radius", .value = "0", .limit = "above zero"}));
  EXPECT_THAT(said("circle: {center: [0, 0, 0], radius: 1, period: -4}\n"),
              refused_at({.line = 1, .key = "circle/period", .value = "-4", .limit = "above zero"}));
  EXPECT_THAT(said("circle: {center: [0, 0, 0], radius: 1}\n"),
              refused_at({.line = 1, .key = "circle", .limit = "the key 'period'"}));
  EXPECT_THAT(said("circle: {center: [0, 0, 0], radius: 1, period: 4, normal: [0, 0, 0]}\n"),
              refused_at({.line = 1, .key = "circle/normal", .limit = "not zero"}));
  EXPECT_THAT(said("circle: {center: [0, 0, 0], radius: 1, period: 4, phase: 1}\n"),
              refused_at({.line = 1,
                          .key = "circle/phase",
                          .value = "phase",
                          .limit = "the keys: center, period, start_deg, radius, normal"}));
  EXPECT_THAT(said("ellipse: {center: [0, 0, 0], axis_1: [1, 0, 0], period: 4}\n"),
              refused_at({.line = 1, .key = "ellipse", .limit = "the key 'axis_2'"}));
  EXPECT_THAT(said("hold: [0, 0]\n"),
              refused_at({.line = 1, .key = "hold", .value = "2", .limit = "3 numbers"}));
  EXPECT_THAT(said("hold: [0, 0, 1]\nfrequency: 2\n"), refused_at({.line = 1, .key = "hold"}));
  EXPECT_THAT(said("hold: [0, 0, 1]\ncircle: {center: [0, 0, 0], radius: 1, period: 4}\n"),
              refused_at({.line = 1, .key = "hold"}));
  EXPECT_THAT(said("circle: {center: [0, 0, 0], radius: 1, period: 1.0e-320}\n"),
              refused_at({.line = 1, .key = "circle", .value = "inf", .limit = "at most 1e+06 rad/s"}));
  EXPECT_THAT(said("circle: {center: [0, 0, 0], radius: 1, period: 4, start_deg: 1.0e308}\n"),
              refused_at({.line = 1, .key = "circle", .value = "inf", .limit = "at most 1e+06 rad"}));
  EXPECT_THAT(said("center: [0, 0, 0]\nfrequency: 1.0e308\nterms: [{order: 1000, cos: [1, 0, 0]}]\n"),
              refused_at({.line = 2, .key = "frequency", .value = "inf", .limit = "at most 1e+06 rad/s"}));
  EXPECT_THAT(said("center: [0, 0, 0]\nfrequency: 1\nphase: 1.0e9\n"),
              refused_at({.line = 3, .key = "phase", .value = "1000000000", .limit = "at most 1e+06 rad"}));
  EXPECT_THAT(said("circel: {center: [0, 0, 0]}\n"),
              refused_at({.line = 1, .key = "", .limit = "the key 'center'"}));
}

TEST(PathFile, APolylineGoesThroughItsSidesAtItsSpeed) {
  const Path path =
      path_of("polyline: {corners: [[0, 0, 0], [1, 0, 0], [1, 1, 0]], speed: 0.5, blend: 0.1}\n");
  ASSERT_NE(path.spline, nullptr);
  EXPECT_FALSE(path.spline->loops());
  EXPECT_LT((path.at(0.4 + 0.8).position - Vec3(0.5, 0.0, 0.0)).norm(), kRounding);
  EXPECT_LT((path.at(0.4 + 0.8).velocity - Vec3(0.5, 0.0, 0.0)).norm(), kRounding);
  EXPECT_LT((path.at(1e3).position - Vec3(1.0, 1.0, 0.0)).norm(), kRounding);
  EXPECT_TRUE(
      path_of(
          "polyline: {corners: [[0, 0, 0], [1, 0, 0], [1, 1, 0]], speed: 0.5, blend: 0.1, closed: true}\n")
          .spline->loops());
}

TEST(PathFile, APolylineThatCannotBeIsRefusedWithItsCorners) {
  const auto refused = [](const std::string& text) { return error_of(text); };
  EXPECT_THAT(refused("polyline: {corners: [[0, 0, 0], [0.1, 0, 0]], speed: 1, blend: 0.06}\n"),
              refused_at({.line = 1, .key = "polyline/corners", .value = "0.1", .limit = "at least 0.12 m"}));
  EXPECT_THAT(
      refused("polyline: {corners: [[0, 0, 0]], speed: 1, blend: 0.06}\n"),
      refused_at({.line = 1, .key = "polyline/corners", .value = "1", .limit = "at least 2 corners"}));
  EXPECT_THAT(
      refused("polyline: {corners: [[0, 0, 0], [1, 0, 0]], speed: 1, blend: 0.06, closed: true}\n"),
      refused_at({.line = 1, .key = "polyline/corners", .value = "2", .limit = "at least 3 corners"}));
  EXPECT_THAT(refused("polyline: {corners: [[0, 0, 0], [1, 0, 0]], speed: 0, blend: 0.06}\n"),
              refused_at({.line = 1, .key = "polyline/speed", .value = "0", .limit = "above zero"}));
}

TEST(PathFile, WaypointsAreFoundBesideTheFileThatNamesThemAndAreInputsOfTheRun) {
  const test::TemporaryFolder folder;
  folder.write("points.csv", "time,x,y,z\n1,0,0,0\n2,0.1,0.2,0.3\n4,0,0.1,0\n");
  const yaml::Node node = yaml::parse_file(folder.write("path.yaml", "waypoints: points.csv\n"));
  yaml::MapReader map(node);
  std::vector<std::string> inputs;
  const Path path = read_path(map, inputs);
  map.finish();
  EXPECT_THAT(inputs, testing::ElementsAre(folder / "points.csv"));
  EXPECT_LT((path.at(2.0).position - Vec3(0.1, 0.2, 0.3)).norm(), kRounding);
  EXPECT_LT((path.at(0.0).position - Vec3(0.0, 0.0, 0.0)).norm(), kRounding);
  EXPECT_LT((path.at(9.0).position - Vec3(0.0, 0.1, 0.0)).norm(), kRounding);
}

TEST(PathFile, WaypointsThatCannotBeAreRefusedWithFileLineAndColumn) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const std::string& csv) {
    folder.write("points.csv", csv);
    const std::string file = folder.write("path.yaml", "waypoints: points.csv\n");
    return test::input_error([&] {
      const yaml::Node node = yaml::parse_file(file);
      yaml::MapReader map(node);
      std::vector<std::string> inputs;
      read_path(map, inputs);
    });
  };
  EXPECT_THAT(refused("time,x,y\n0,0,0\n1,1,1\n"),
              refused_at({.file = folder / "points.csv", .line = 1, .key = "z", .limit = "a column 'z'"}));
  EXPECT_THAT(
      refused("time,x,y,z\n0,0,0,0\n0,1,1,1\n"),
      refused_at(
          {.file = folder / "points.csv", .line = 3, .key = "time", .value = "0", .limit = "above 0"}));
  EXPECT_THAT(refused("time,x,y,z\n0,0,nan,0\n1,1,1,1\n"), refused_at({.file = folder / "points.csv",
                                                                       .line = 2,
                                                                       .key = "y",
                                                                       .value = "nan",
                                                                       .limit = "a finite number"}));
  EXPECT_THAT(
      refused("time,x,y,z\n0,0,0,0\n"),
      refused_at({.file = folder / "points.csv", .key = "", .value = "1", .limit = "at least 2 rows"}));
  EXPECT_THAT(refused("time,x,y,z,qw\n0,0,0,0,1\n1,1,1,1,1\n"),
              refused_at({.file = folder / "points.csv",
                          .line = 1,
                          .key = "qw",
                          .value = "qw",
                          .limit = "one of: time, x, y, z"}));
  EXPECT_THAT(refused("time,x,y,z,roll\n0,0,0,0,1\n1,1,1,1,1\n"),
              refused_at({.file = folder / "points.csv",
                          .line = 1,
                          .key = "roll",
                          .value = "roll",
                          .limit = "one of: time, x, y, z, qw, qx, qy, qz"}));
  EXPECT_THAT(
      refused("time,x,y,z\n0,0,0,0\n1e-9,1,1,1\n1,1,1,1\n"),
      refused_at(
          {.file = folder / "points.csv", .line = 2, .key = "", .limit = "at most 1e+06 m/s and m/s^2"}));
  EXPECT_THAT(refused("time,x,y,z\n0,0,0,0\n1e-9,1,1,1\n1,1,1,1\n").what(), HasSubstr("more time"));
}

TEST(PathFile, EveryPathThatIsAcceptedHasFiniteMotion) {
  // Magnitudes that overflow, underflow, or are nowhere near an arm, one at a time.
  const auto with = [](const std::string& corner, const std::string& speed, const std::string& blend) {
    return "polyline: {corners: [[0, 0, 0], [" + corner + ", 0, 0], [0, 1, 0]], speed: " + speed +
           ", blend: " + blend + "}\n";
  };
  int accepted = 0;
  int refused = 0;
  for (const std::string number :
       {"1e-300", "1e-200", "1e-30", "1e-6", "0.1", "1", "1e3", "1e30", "1e200", "1e300"}) {
    for (const std::string& text :
         {with("1", number, "0.01"), with("1", "0.1", number), with(number, "0.1", "0.01"),
          with("1", number, number), "circle: {center: [0, 0, 0], radius: " + number + ", period: 4}\n",
          "circle: {center: [0, 0, 0], radius: 1, period: " + number + "}\n",
          "hold: [" + number + ", 0, 0]\n",
          "center: [0, 0, 0]\nfrequency: 1\nterms: [{order: 1, cos: [" + number + ", 0, 0]}]\n"}) {
      SCOPED_TRACE(text);
      Path path;
      const std::string message = test::refusal([&] { path = path_of(text); });
      if (message != "nothing was refused") {
        EXPECT_THAT(message, testing::StartsWith("path.yaml:"));
        ++refused;
        continue;
      }
      ++accepted;
      for (const double t : {0.0, 1e-3, 0.5, 3.0, 1e4}) {
        const MotionPoint<Vec3> at = path.at(t);
        EXPECT_TRUE(at.position.allFinite() && at.velocity.allFinite() && at.acceleration.allFinite()) << t;
      }
    }
  }
  EXPECT_GT(accepted, 10);
  EXPECT_GT(refused, 10);
  EXPECT_THAT(error_of(with("1", "1e300", "0.01")),
              refused_at({.line = 1, .key = "polyline", .limit = "at most 1e+06 m/s and m/s^2"}));
}

TEST(PathFile, TwoOfOneNameAreRefused) {
  std::vector<std::string> inputs;
  const std::string two =
      "- {name: red, hold: [0, 0, 0]}\n- {name: blue, hold: [1, 0, 0]}\n- {name: red, hold: [2, 0, 0]}\n";
  const yaml::Node node = yaml::parse_text(two, "two.yaml");
  EXPECT_THAT([&] { read_targets(node, inputs); },
              refused_at({.file = "two.yaml", .line = 3, .value = "red", .limit = "another name"}));
  EXPECT_THAT([&] { read_obstacles(node, inputs); },
              refused_at({.file = "two.yaml", .line = 3, .value = "red", .limit = "another name"}));
}

}  // namespace path_file_test
}  // namespace armtune::internal
