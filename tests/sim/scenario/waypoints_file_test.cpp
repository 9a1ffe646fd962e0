#include "sim/scenario/waypoints_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace waypoints_file_test {

using test::refused_at;
using testing::HasSubstr;

const std::string kCommas = "time,x,y,z\n0,-0.65,0.16,0.5\n5,-0.7,0.16,0.5\n9,-0.7,0.2,0.4\n";

Vec3 halfway(const std::string& path) {
  return load_waypoints({path, {}, {}}, false).at(2.5).position;
}

TEST(WaypointsFile, AnySeparatorAndCapitalsGiveTheSamePath) {
  const test::TemporaryFolder folder;
  const Vec3 expected = halfway(folder.write("commas.csv", kCommas));
  EXPECT_NE(expected.x(), 0.0);
  for (const char separator : {';', '\t', ' '}) {
    std::string text = kCommas;
    std::replace(text.begin(), text.end(), ',', separator);
    EXPECT_EQ(halfway(folder.write("other.csv", text)), expected) << separator;
  }
  EXPECT_EQ(
      halfway(folder.write("capitals.csv", "Time, X, Y, Z\r\n" + kCommas.substr(kCommas.find('\n') + 1))),
      expected);
  EXPECT_EQ(halfway(folder.write("quoted.csv", "\xEF\xBB\xBF\"time\",\"x\",\"y\",\"z\"\n" +
                                                   kCommas.substr(kCommas.find('\n') + 1))),
            expected);
}

TEST(WaypointsFile, UnitsBehindNamesHaveToBeTheFiles) {
  const test::TemporaryFolder folder;
  const Vec3 expected = halfway(folder.write("commas.csv", kCommas));
  const std::string rows = kCommas.substr(kCommas.find('\n') + 1);
  for (const char* names :
       {"t,x,y,z", "T;X;Y;Z", "Time [s],x [m],y [m],z [m]", "time_from_start,x(m),y (m),z"}) {
    std::string text = std::string(names) + "\n" + rows;
    if (text.find(';') != std::string::npos) std::replace(text.begin(), text.end(), ',', ';');
    EXPECT_EQ(halfway(folder.write("named.csv", text)), expected) << names;
  }
  const std::string path = folder.write("units.csv", "time [ms],x [mm],y [mm],z [mm]\n" + rows);
  const auto read = [&](const yaml::FileUnits& units) { return load_waypoints({path, units, {}}, false); };
  const InputError time = test::input_error([&] { read({}); });
  EXPECT_THAT(time, refused_at({.file = path, .line = 1, .key = "time [ms]", .value = "ms"}));
  EXPECT_THAT(time.what(), HasSubstr("units: {time: ms}"));
  yaml::FileUnits units;
  units.time = 1e-3;
  const InputError length = test::input_error([&] { read(units); });
  EXPECT_THAT(length, refused_at({.file = path, .line = 1, .key = "x [mm]", .value = "mm"}));
  EXPECT_THAT(length.what(), HasSubstr("units: {length: mm}"));
  units.length = 1e-3;
  EXPECT_LT((read(units).at(2.5e-3).position - 1e-3 * expected).norm(), 1e-15);
  const std::string speed = folder.write("speed.csv", "time [s],x,y,z,speed [m/s]\n" + rows);
  EXPECT_THAT([&] { halfway(speed); }, refused_at({.file = speed,
                                                   .line = 1,
                                                   .key = "speed [m/s]",
                                                   .value = "speed [m/s]",
                                                   .limit = "column names without units"}));
  // What is no unit is part of the name.
  EXPECT_THAT([&] { halfway(folder.write("other.csv", "time,x,y,z [up]\n" + rows)); },
              refused_at({.line = 1, .key = "z [up]", .value = "z [up]"}));
}

TEST(WaypointsFile, EmptyLinesMayStandAtTheEndAlone) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(halfway(folder.write("more.csv", kCommas + "\r\n  \n\n")),
            halfway(folder.write("commas.csv", kCommas)));
  EXPECT_THAT([&] { halfway(folder.write("first.csv", "\n" + kCommas)); },
              refused_at({.file = folder / "first.csv", .line = 1, .limit = "column names"}));
  EXPECT_THAT([&] { halfway(folder.write("amid.csv", kCommas + "\n10,-0.7,0.2,0.4\n")); },
              refused_at({.file = folder / "amid.csv", .line = 5}));
  EXPECT_THAT([&] { halfway(folder.write("none.csv", "")); }, refused_at({.file = folder / "none.csv"}));
}

TEST(WaypointsFile, NumbersWithCommasAreNamed) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("comma.csv", "time;x;y;z\n0;0,65;0;0\n1;0,7;0;0\n");
  const InputError error = test::input_error([&] { halfway(path); });
  EXPECT_THAT(
      error,
      refused_at({.file = path, .line = 2, .value = "0,65", .limit = "a number with a decimal point"}));
  EXPECT_THAT(error.what(), HasSubstr("semicolons"));
}

TEST(WaypointsFile, UnixTimeStampsAreNamed) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("stamps.csv", "time,x,y,z\n1700000000.5,0,0,0\n1700000001,1,0,0\n");
  const InputError error = test::input_error([&] { halfway(path); });
  EXPECT_THAT(error, refused_at({.file = path, .line = 2, .key = "time", .value = "1700000000.5"}));
  EXPECT_THAT(error.what(), HasSubstr("Unix"));
}

TEST(WaypointsFile, OtherUnitsAndColumnsWithoutNamesAreSaidWhereTheFileIsNamed) {
  const test::TemporaryFolder folder;
  const Vec3 expected = halfway(folder.write("commas.csv", kCommas));
  folder.write("robot.csv", "-650 160 500 0\n-700 160 500 5000\n-700 200 400 9000\n");
  const auto read = [&](const std::string& keys) {
    const std::string yaml = "{file: robot.csv" + keys + "}";
    return load_waypoints(read_waypoints_node(yaml::parse_text(yaml, folder / "scenario.yaml")), false);
  };
  const PositionSpline path = read(", units: {time: ms, length: mm}, columns: [x, y, z, time]");
  EXPECT_LT((path.at(2.5).position - expected).norm(), 1e-15);
  const auto refused = [&](const std::string& keys) { return test::input_error([&] { read(keys); }); };
  const InputError unnamed = refused("");
  EXPECT_THAT(unnamed, refused_at({.file = folder / "robot.csv", .line = 1, .limit = "column names"}));
  EXPECT_THAT(unnamed.what(), HasSubstr("columns: [time, x, y, z]"));
  EXPECT_THAT(refused(", columns: [x, y, z]"),
              refused_at({.file = folder / "robot.csv (with a line of names added)", .line = 2}));
  EXPECT_THAT(refused(", units: {length: feet}"), refused_at({.file = folder / "scenario.yaml",
                                                              .line = 1,
                                                              .key = "units/length",
                                                              .value = "feet",
                                                              .limit = "one of: m, cm, mm, in"}));
  EXPECT_THAT(
      refused(", units: {angle: deg}"),
      refused_at({.line = 1, .key = "units/angle", .value = "angle", .limit = "the keys: time, length"}));
  folder.write("robot.csv", kCommas);
  // Names of another language are replaced.
  folder.write("robot.csv", "Zeit;X-Pos;Y-Pos;Z-Pos\n0;1;2;3\n2;4;5;6\n");
  EXPECT_THAT(refused(""), refused_at({.line = 1, .key = "zeit", .value = "zeit"}));
  const PositionSpline german = read(", columns: [time, x, y, z]");
  EXPECT_EQ(german.end(), 2.0);
  EXPECT_EQ(german.at(2.0).position, Vec3(4, 5, 6));
  EXPECT_THAT(refused(", columns: [time, x, y]"), refused_at({.file = folder / "robot.csv", .line = 2}));
}

}  // namespace waypoints_file_test
}  // namespace armtune::internal
