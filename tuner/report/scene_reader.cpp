#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/common/error.hpp"
#include "sim/yaml/map_reader.hpp"
#include "tuner/report/arm_reader.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::report {
namespace {

/// Meshes of many arms.
constexpr std::size_t kMaxSceneBytes = 64 << 20;

Vec3 read_vec3(const yaml::Node& node) {
  const auto v = node.as_numbers(3);
  return {v[0], v[1], v[2]};
}

std::shared_ptr<const PositionSpline> read_knots(const yaml::Node& node, bool loops) {
  std::vector<double> time;
  std::vector<MotionPoint<Vec3>> knots;
  for (const yaml::Node& item : node.items()) {
    const auto row = item.as_numbers(10);
    time.push_back(row[0]);
    knots.push_back({Vec3(&row[1]), Vec3(&row[4]), Vec3(&row[7])});
  }
  try {
    return std::make_shared<const PositionSpline>(time, knots, loops);
  } catch (const InputError& e) {
    node.fail(e.what());
  }
}

Path read_path(const yaml::Node& node) {
  yaml::MapReader map(node);
  Path path;
  path.center = read_vec3(map.required("center"));
  path.frequency = map.number("frequency");
  path.phase = map.number("phase");
  for (const yaml::Node& item : map.required("terms").items()) {
    yaml::MapReader term_map(item);
    HarmonicTerm term;
    term.order = static_cast<int>(term_map.required("order").as_integer());
    term.cosine = read_vec3(term_map.required("cosine"));
    term.sine = read_vec3(term_map.required("sine"));
    term_map.finish();
    path.terms.push_back(term);
  }
  if (const yaml::Node* knots = map.optional("knots"))
    path.spline = read_knots(*knots, map.boolean("loops", false));
  map.finish();
  return path;
}

/// A path below the run's folder: what a scene names is read and shown.
std::string path_inside(const yaml::Node& node) {
  const std::filesystem::path path = node.as_string();
  if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end())
    node.fail(fmt::format("'{}' leads out of the run's folder", path.string()));
  return path.string();
}

/// A path alone, as it was written when obstacles had no body, is a point's.
SceneObstacle read_obstacle(const yaml::Node& node) {
  if (node.find("path") == nullptr) return {read_path(node), 0.0};
  yaml::MapReader map(node);
  SceneObstacle obstacle{read_path(map.required("path")), map.number("radius")};
  map.finish();
  return obstacle;
}

SceneScenario read_scenario(const yaml::Node& node, std::size_t arms) {
  yaml::MapReader map(node);
  SceneScenario s;
  s.name = map.required("name").as_string();
  s.duration = map.number("duration");
  const yaml::Node& robot = map.required("robot");
  const long arm = robot.as_integer();
  if (arm < 0 || static_cast<std::size_t>(arm) >= arms) robot.fail("there is no such robot in this file");
  s.arm = static_cast<std::size_t>(arm);
  s.path = read_path(map.required("path"));
  for (const yaml::Node& item : map.required("obstacles").items()) s.obstacles.push_back(read_obstacle(item));
  s.influence_radius = map.number("influence_radius");
  map.finish();
  return s;
}

}  // namespace

Scene read_scene(const std::string& path) {
  const yaml::Node root = yaml::parse_file(path, kMaxSceneBytes);
  yaml::MapReader map(root);
  Scene scene;
  for (const yaml::Node& item : map.required("sets").items()) {
    yaml::MapReader set(item);
    scene.sets.push_back({set.required("name").as_string(), path_inside(set.required("folder")),
                          path_inside(set.required("errors"))});
    set.finish();
  }
  for (const yaml::Node& item : map.required("robots").items()) scene.arms.push_back(read_arm(item));
  for (const yaml::Node& item : map.required("scenarios").items()) {
    scene.scenarios.push_back(read_scenario(item, scene.arms.size()));
  }
  map.finish();
  return scene;
}

}  // namespace armtune::report
