#include "sim/scenario/orientation_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/waypoints_file.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

constexpr double kUnit = 1e-3;  // largest difference of a quaternion's length from 1
constexpr int kSamples = 2000;  // per lap of a path of harmonics
constexpr int kSamplesOfAPiece = 30;
constexpr double kFastest = 100.0;   // rad/s
constexpr double kLeastSine = 0.05;  // of the angle between path and approach
constexpr std::array kKeys{"rpy_deg", "quaternion", "along_path", "waypoints"};

Eigen::Quaterniond read_rpy(const yaml::Node& node) {
  const std::vector<double> angles = node.as_numbers(3);
  Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    const double angle = angles[static_cast<std::size_t>(axis)] * M_PI / 180.0;
    turned = Eigen::AngleAxisd(angle, Vec3::Unit(axis)) * turned;
  }
  return turned;
}

Eigen::Quaterniond read_quaternion(const yaml::Node& node) {
  const std::vector<double> q = node.as_numbers(4);
  const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
  const double length = quaternion.coeffs().stableNorm();
  if (!(std::abs(length - 1.0) <= kUnit))
    node.fail(InputFault{.problem = fmt::format("the quaternion has length {:.6g}", length),
                         .value = fmt::format("{:.6g}", length),
                         .limit = "[w, x, y, z] of length 1"});
  return quaternion.normalized();
}

/// Returns times [s] that are close enough together to find every corner of a path.
std::vector<double> times_along(const Path& path) {
  std::vector<double> times;
  const auto add = [&times](double from, double to, int samples) {
    for (int k = 0; k < samples; ++k) times.push_back(from + (to - from) * k / samples);
  };
  if (path.spline) {
    const std::vector<double>& knots = path.spline->time();
    for (std::size_t k = 1; k < knots.size(); ++k) add(knots[k - 1], knots[k], kSamplesOfAPiece);
    times.push_back(knots.back());
  } else {
    add(0.0, path.period(), kSamples);
    times.push_back(path.period());
  }
  return times;
}

/// Throws InputError at `node` if the path does not determine the tool's orientation, or turns it too fast.
void check_along(const yaml::Node& node, const Path& path, const ToolOrientation& along) {
  if (path.rests())
    node.fail("the path does not move and therefore has no direction; give rpy_deg", "a path that moves");
  const Vec3& approach = *along.approach;
  const std::vector<double> times = times_along(path);
  Vec3 last = heading(path, times.front()).position;
  for (const double time : times) {
    const Vec3 now = heading(path, time).position;
    if (!(now.dot(last) > 0.0)) {
      node.fail(
          fmt::format("the path stops or reverses at {:.4g} s, where the tool would turn in an instant; "
                      "round the path there, or give the orientation at waypoints",
                      time),
          "a path that neither stops nor reverses");
    }
    if (!(now.cross(approach).norm() > kLeastSine * approach.norm())) {
      node.fail(fmt::format(
                    "at {3:.4g} s the path runs along the wanted direction [{0:.4g}, {1:.4g}, {2:.4g}]. The "
                    "tool's z axis is always perpendicular to the path, so it cannot point there; give "
                    "another direction",
                    approach.x(), approach.y(), approach.z(), time),
                "a direction that crosses the path");
    }
    const double rate = along.at(time, path).angular_velocity.norm();
    if (!(rate <= kFastest)) {
      node.fail(
          fmt::format(
              "the tool would turn at {:.3g} rad/s at {:.4g} s; at most {} rad/s is allowed: round the path "
              "more, or lower its speed",
              rate, time, kFastest),
          fmt::format("at most {} rad/s", kFastest));
    }
    last = now;
  }
}

}  // namespace

ToolOrientation read_orientation(const yaml::Node& node, const Path& path, std::vector<std::string>& inputs) {
  yaml::MapReader map(node);
  ToolOrientation orientation;
  int given = 0;
  for (const char* key : kKeys) given += map.has(key) ? 1 : 0;
  if (given != 1) {
    const std::string limit = "one of: rpy_deg, quaternion, along_path, waypoints";
    node.fail("give " + limit, limit);
  }
  if (const yaml::Node* rpy = map.optional("rpy_deg")) orientation.start = read_rpy(*rpy);
  if (const yaml::Node* quaternion = map.optional("quaternion"))
    orientation.start = read_quaternion(*quaternion);
  if (const yaml::Node* along = map.optional("along_path")) {
    orientation.approach = Vec3(along->as_numbers(3).data());
    if (orientation.approach->isZero(0.0))
      along->fail("this vector is zero; it must have a direction", "not zero");
    check_along(*along, path, orientation);
  }
  if (const yaml::Node* waypoints = map.optional("waypoints")) {
    const UserTable file = read_waypoints_node(*waypoints);
    inputs.push_back(file.path);
    orientation = load_orientations(file);
  }
  map.finish();
  return orientation;
}

}  // namespace armtune::internal
