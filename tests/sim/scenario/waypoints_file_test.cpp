#include "sim/scenario/waypoints_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace waypoints_file_test {

using testing::AllOf;
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
  EXPECT_THAT(
      test::refusal([&] { read({}); }),
      AllOf(HasSubstr("units.csv:1: column 'time [ms]' has the unit ms"), HasSubstr("units: {time: ms}")));
  yaml::FileUnits units;
  units.time = 1e-3;
  EXPECT_THAT(test::refusal([&] { read(units); }),
              AllOf(HasSubstr("column 'x [mm]' has the unit mm"), HasSubstr("units: {length: mm}")));
  units.length = 1e-3;
  EXPECT_LT((read(units).at(2.5e-3).position - 1e-3 * expected).norm(), 1e-15);
  EXPECT_THAT(
      test::refusal([&] { halfway(folder.write("speed.csv", "time [s],x,y,z,speed [m/s]\n" + rows)); }),
      AllOf(HasSubstr("'speed [m/s]'"), HasSubstr("take the units out")));
  // What is no unit is part of the name.
  EXPECT_THAT(test::refusal([&] { halfway(folder.write("other.csv", "time,x,y,z [up]\n" + rows)); }),
              HasSubstr("z [up]"));
}

TEST(WaypointsFile, EmptyLinesMayStandAtTheEndAlone) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(halfway(folder.write("more.csv", kCommas + "\r\n  \n\n")),
            halfway(folder.write("commas.csv", kCommas)));
  EXPECT_THAT(test::refusal([&] { halfway(folder.write("first.csv", "\n" + kCommas)); }),
              HasSubstr("first.csv:1: the first line is empty"));
  EXPECT_THAT(test::refusal([&] { halfway(folder.write("amid.csv", kCommas + "\n10,-0.7,0.2,0.4\n")); }),
              HasSubstr("amid.csv:5"));
  EXPECT_THAT(test::refusal([&] { halfway(folder.write("none.csv", "")); }), HasSubstr("none.csv"));
}

TEST(WaypointsFile, NumbersWithCommasAreNamed) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("comma.csv", "time;x;y;z\n0;0,65;0;0\n1;0,7;0;0\n");
  EXPECT_THAT(
      test::refusal([&] {
        load_waypoints({path, {}, {}}, false);
      }),
      AllOf(HasSubstr("comma.csv:2:"), HasSubstr("0,65"), HasSubstr("semicolons"), HasSubstr("point")));
}

TEST(WaypointsFile, UnixTimeStampsAreNamed) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("stamps.csv", "time,x,y,z\n1700000000.5,0,0,0\n1700000001,1,0,0\n");
  EXPECT_THAT(test::refusal([&] {
                load_waypoints({path, {}, {}}, false);
              }),
              AllOf(HasSubstr("stamps.csv:2:"), HasSubstr("1700000000.5"), HasSubstr("Unix")));
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
  const auto refused = [&](const std::string& keys) { return test::refusal([&] { read(keys); }); };
  EXPECT_THAT(refused(""), AllOf(HasSubstr("robot.csv:1"), HasSubstr("columns: [time, x, y, z]")));
  EXPECT_THAT(refused(", columns: [x, y, z]"), HasSubstr("robot.csv (with a line of names added):2"));
  EXPECT_THAT(refused(", units: {length: feet}"), HasSubstr("'feet' is not one of: m, cm, mm, in"));
  EXPECT_THAT(refused(", units: {angle: deg}"), AllOf(HasSubstr("'angle'"), HasSubstr("time")));
  folder.write("robot.csv", kCommas);
  // Names of another language are replaced.
  folder.write("robot.csv", "Zeit;X-Pos;Y-Pos;Z-Pos\n0;1;2;3\n2;4;5;6\n");
  EXPECT_THAT(refused(""), HasSubstr("zeit"));
  const PositionSpline german = read(", columns: [time, x, y, z]");
  EXPECT_EQ(german.end(), 2.0);
  EXPECT_EQ(german.at(2.0).position, Vec3(4, 5, 6));
  EXPECT_THAT(refused(", columns: [time, x, y]"), HasSubstr("robot.csv:2"));
}

}  // namespace waypoints_file_test
}  // namespace armtune::internal
