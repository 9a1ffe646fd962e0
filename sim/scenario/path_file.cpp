#include "sim/scenario/path_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "armtune/error.hpp"
#include "core/trajectory/polyline.hpp"
#include "sim/scenario/waypoints_file.hpp"
#include "sim/yaml/source_text.hpp"

namespace armtune::internal {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr long kHighestOrder = 1000;
constexpr std::size_t kMostCorners = 5000;

struct Files {
  std::vector<std::string>& inputs;
  bool of_poses;
};

Vec3 read_vec3(const yaml::Node& node) {
  return Vec3(node.as_numbers(3).data());
}

/// Reads a vector that gives a direction or an extent, and must not be zero.
Vec3 read_extent(const yaml::Node& node) {
  Vec3 extent = read_vec3(node);
  if (extent.isZero(0.0)) node.fail("this vector is zero; it must have a direction and a length", "not zero");
  return extent;
}

/// Beyond these limits a double cannot distinguish one period from the next. No arm moves that fast.
constexpr double kFastest = 1e6;    // rad/s
constexpr double kMostTurns = 1e6;  // rad

constexpr double kFarthest = 1e6;   // m
constexpr double kSpeediest = 1e6;  // m/s, m/s^2, as for waypoints
constexpr double kLongest = 1e9;    // s

/// Throws InputError at `node` if the duration, positions, velocities or accelerations of a motion through
/// knots could overflow or are too large for an arm.
void require_sensible(const PositionSpline& spline, const yaml::Node& node) {
  if (!(spline.end() - spline.begin() <= kLongest))
    node.fail(InputFault{.problem = fmt::format("the path takes {:.3g} s", spline.end() - spline.begin()),
                         .value = fmt::format("{:.3g}", spline.end() - spline.begin()),
                         .limit = fmt::format("at most {:.0e} s", kLongest)});
  for (std::size_t k = 0; k < spline.knots().size(); ++k) {
    // A blend between two straight pieces has its largest acceleration in the middle.
    const double time = spline.time()[k];
    const double next = k + 1 < spline.knots().size() ? spline.time()[k + 1] : time;
    const MotionPoint<Vec3> middle = spline.at(0.5 * (time + next));
    const double v = spline.knots()[k].velocity.norm();
    const double a = middle.acceleration.norm();
    if (!(v <= kSpeediest && a <= kSpeediest && middle.position.norm() <= 2.0 * kFarthest)) {
      node.fail(
          fmt::format(
              "the speed or acceleration at {:.3g} s is above the limit of {:.0e} m/s or m/s^2; lower the speed, "
              "or increase the blend",
              time, kSpeediest),
          fmt::format("at most {:.0e} m/s and m/s^2", kSpeediest));
    }
  }
}

/// Returns the distance as text. It is infinite for the sum of the largest numbers that a file can contain.
std::string distance_text(double metres) {
  return std::isfinite(metres) ? fmt::format("{:.3g}", metres) : "over 1e308";
}

/// Throws InputError at `node` if the extent, the highest frequency or the phase of a path is too large for
/// an arm.
void require_sensible(const Path& path, const yaml::Node& node) {
  int highest = 1;
  double farthest = path.center.stableNorm();
  for (const HarmonicTerm& term : path.terms) {
    highest = std::max(highest, term.order);
    farthest += term.cosine.stableNorm() + term.sine.stableNorm();
  }
  if (!(farthest <= kFarthest))
    node.fail(
        InputFault{.problem = fmt::format("the path leads {} m away from the base", distance_text(farthest)),
                   .value = distance_text(farthest),
                   .limit = fmt::format("at most {:.0e} m", kFarthest)});
  if (path.spline) require_sensible(*path.spline, node);
  const double fastest = std::abs(path.frequency) * highest;
  if (!(fastest <= kFastest))
    node.fail(InputFault{.problem = fmt::format("the fastest harmonic has {} rad/s", fastest),
                         .value = fmt::to_string(fastest),
                         .limit = fmt::format("at most {:.0e} rad/s", kFastest)});
  if (!(std::abs(path.phase) <= kMostTurns))
    node.fail(InputFault{.problem = fmt::format("the path begins at a phase of {} rad", path.phase),
                         .value = fmt::to_string(path.phase),
                         .limit = fmt::format("at most {:.0e} rad", kMostTurns)});
}

double read_positive(const yaml::Node& node, const char* unit) {
  const double value = node.as_number();
  if (!(value > 0.0))
    node.fail(fmt::format("the value is {} {}; it must be above zero", value, unit), "above zero");
  return value;
}

/// Reads the keys that all closed curves have.
Path read_turning(yaml::MapReader& map) {
  Path path;
  path.center = read_vec3(map.required("center"));
  path.frequency = 2.0 * kPi / read_positive(map.required("period"), "s");
  path.phase = map.number("start_deg", 0.0) * kPi / 180.0;
  return path;
}

/// Returns two unit vectors that span the plane with this normal. The first is as close as possible to the x
/// axis, or to the y axis if the normal is nearly along x. The second is a right-handed quarter turn further.
std::array<Vec3, 2> plane_of(const Vec3& normal) {
  const Vec3 n = normal.stableNormalized();
  constexpr double kAlmostOne = 0.99;
  const Vec3 near = std::abs(n.x()) < kAlmostOne ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 first = (near - near.dot(n) * n).normalized();
  return {first, n.cross(first)};
}

Path read_circle(const yaml::Node& node, const Files&) {
  yaml::MapReader map(node);
  Path path = read_turning(map);
  const double radius = read_positive(map.required("radius"), "m");
  const yaml::Node* normal = map.optional("normal");
  const auto [first, second] = plane_of(normal == nullptr ? Vec3(Vec3::UnitZ()) : read_extent(*normal));
  map.finish();
  path.terms = {{1, radius * first, radius * second}};
  return path;
}

Path read_ellipse(const yaml::Node& node, const Files&) {
  yaml::MapReader map(node);
  Path path = read_turning(map);
  path.terms = {{1, read_extent(map.required("axis_1")), read_extent(map.required("axis_2"))}};
  map.finish();
  return path;
}

/// Reads the curve p = c + l sin(phi) + w sin(2 phi). One period covers both loops.
Path read_figure_eight(const yaml::Node& node, const Files&) {
  yaml::MapReader map(node);
  Path path = read_turning(map);
  path.terms = {{1, Vec3::Zero(), read_extent(map.required("length"))},
                {2, Vec3::Zero(), read_extent(map.required("width"))}};
  map.finish();
  return path;
}

Path read_hold(const yaml::Node& node, const Files&) {
  Path path;
  path.center = read_vec3(node);
  return path;
}

Path read_polyline(const yaml::Node& node, const Files&) {
  yaml::MapReader map(node);
  const yaml::Node& corners_node = map.required("corners");
  std::vector<Vec3> corners;
  for (const yaml::Node& item : corners_node.items()) {
    if (corners.size() == kMostCorners)
      corners_node.fail(fmt::format("the line has more than {} corners; give fewer", kMostCorners),
                        fmt::format("at most {} corners", kMostCorners));
    corners.push_back(read_vec3(item));
    const double distance = corners.back().stableNorm();
    if (!(distance <= kFarthest))
      item.fail(
          InputFault{.problem = fmt::format("the corner is {} m away from the base", distance_text(distance)),
                     .value = distance_text(distance),
                     .limit = fmt::format("at most {:.0e} m", kFarthest)});
  }
  const double speed = read_positive(map.required("speed"), "m/s");
  const double blend = read_positive(map.required("blend"), "m");
  const bool closed = map.boolean("closed", false);
  map.finish();
  Path path;
  try {
    path.spline = std::make_shared<const PositionSpline>(polyline(corners, speed, blend, closed));
  } catch (const InputError& e) {
    throw yaml::error_at(corners_node.file(), corners_node.line(), corners_node.key_path(),
                         {.problem = e.what()})
        .with_value(e.value(), e.limit());
  }
  return path;
}

Path read_waypoints(const yaml::Node& node, const Files& files) {
  const UserTable waypoints = read_waypoints_node(node);
  files.inputs.push_back(waypoints.path);
  Path path;
  path.spline = std::make_shared<const PositionSpline>(load_waypoints(waypoints, files.of_poses));
  return path;
}

struct Curve {
  const char* key;
  Path (*read)(const yaml::Node&, const Files& files);
};
constexpr std::array<Curve, 6> kCurves = {{{"circle", read_circle},
                                           {"ellipse", read_ellipse},
                                           {"figure_eight", read_figure_eight},
                                           {"hold", read_hold},
                                           {"polyline", read_polyline},
                                           {"waypoints", read_waypoints}}};

HarmonicTerm read_term(const yaml::Node& node) {
  yaml::MapReader map(node);
  HarmonicTerm term;
  const yaml::Node& order = map.required("order");
  const long value = order.as_integer();
  if (value < 0 || value > kHighestOrder)
    order.fail(fmt::format("order is {}; it must lie in 0 .. {}", value, kHighestOrder),
               fmt::format("0 .. {}", kHighestOrder));
  term.order = static_cast<int>(value);
  if (const yaml::Node* cosine = map.optional("cos")) term.cosine = read_vec3(*cosine);
  if (const yaml::Node* sine = map.optional("sin")) term.sine = read_vec3(*sine);
  map.finish();
  return term;
}

}  // namespace

Path read_path(yaml::MapReader& map, std::vector<std::string>& inputs, bool of_poses) {
  const yaml::Node* chosen = nullptr;
  Path path;
  for (const Curve& curve : kCurves) {
    const yaml::Node* node = map.optional(curve.key);
    if (node == nullptr) continue;
    if (chosen != nullptr) node->fail("the path has a second curve; keep one of them");
    chosen = node;
    path = curve.read(*node, {inputs, of_poses});
    require_sensible(path, *node);
  }
  for (const char* key : {"center", "frequency", "phase", "terms"}) {
    if (map.has(key) && chosen != nullptr)
      chosen->fail(
          fmt::format("this curve cannot be combined with '{}', which belongs to a sum of harmonics; keep "
                      "one of the two",
                      key));
  }
  if (chosen != nullptr) return path;
  path.center = read_vec3(map.required("center"));
  path.frequency = map.number("frequency", 0.0);
  path.phase = map.number("phase", 0.0);
  if (const yaml::Node* terms = map.optional("terms")) {
    for (const yaml::Node& item : terms->items()) path.terms.push_back(read_term(item));
  }
  for (const char* key : {"phase", "frequency", "center"}) {
    if (const yaml::Node* node = map.optional(key)) require_sensible(path, *node);
  }
  return path;
}

}  // namespace armtune::internal
