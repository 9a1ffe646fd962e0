#pragma once
// The scene of a run. A 3D replay needs the CSV files of a run and the scene, which is stored beside them in
// scene.json. The scene contains the arms, the tool paths, the obstacles and the parts of the robot's cell.

#include <optional>
#include <string>
#include <vector>

#include "core/trajectory/path.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/report/arm.hpp"
#include "tuner/run/run_kind.hpp"

namespace armtune::internal::report {

/// A gain set of the run, with the paths of its files. The paths are relative to the run folder.
struct SceneSet {
  std::string name;
  std::string folder = ".";           ///< folder of gains.yaml and rollout_<scenario>.csv
  std::string errors = "errors.csv";  ///< file of the metrics; empty if there is none
  std::optional<long> point = {};     ///< number in pareto.csv, if the set is a point of a front

  static void declare(auto& f, auto& set) {
    f("name", set.name)("folder", set.folder)("errors", set.errors);
    f("point", set.point, "", record::Presence::kIfAny);
  }
};

struct SceneObstacle {
  Path path;
  double radius = 0.0;  ///< radius of its body [m]

  static void declare(auto& f, auto& obstacle) { f("radius", obstacle.radius)("path", obstacle.path); }
};

/// A part of the robot's cell, such as a table.
struct ScenePart {
  std::string name;
  ArmShape shape;  ///< belongs to no joint
  Path path;       ///< path of the shape's centre

  static void declare(auto& f, auto& part) { f("name", part.name)("shape", part.shape)("path", part.path); }
};

struct SceneScenario {
  std::string name;
  double duration = 0.0;  ///< [s]
  std::size_t arm = 0;    ///< index into Scene::arms
  Path path;              ///< path of the tool
  std::vector<SceneObstacle> obstacles;
  double influence_radius = 0.0;  ///< of the obstacles, with the first set's gains [m]; 0 without obstacles
  std::vector<ScenePart> cell;
  std::optional<double> floor;  ///< height above the base frame's origin [m]

  static void declare(auto& f, auto& scenario) {
    f("name", scenario.name)("duration", scenario.duration)("robot", scenario.arm)("path", scenario.path);
    f("obstacles", scenario.obstacles)("influence_radius", scenario.influence_radius);
    f("cell", scenario.cell, "", record::Presence::kLater)("floor", scenario.floor, "",
                                                           record::Presence::kLater);
  }
};

struct Scene {
  std::vector<SceneSet> sets;  ///< the reference first, the result last
  std::vector<Arm> arms;
  std::vector<SceneScenario> scenarios;

  static void declare(auto& f, auto& scene) {
    f("sets", scene.sets)("scenarios", scene.scenarios)("robots", scene.arms);
  }
};

/// Returns the gain sets of a run folder without scene.json. They depend on the kind of run. The gain sets of
/// a comparison are those that run.json names. Throws InputError if run.json is needed and cannot be read, or
/// names none.
std::vector<SceneSet> usual_sets(RunKind kind, const std::string& folder);

/// Returns the scene of these scenarios and gain sets. influence_radius: the obstacles' influence radius in
/// the first set's gains [m].
Scene scene_of(const std::vector<Scenario>& scenarios, std::vector<SceneSet> sets, double influence_radius);

/// Returns points of a path as a closed polyline [m]; coordinates are rounded to 0.01 mm. If the path has a
/// period, the polyline covers one period. Otherwise it goes along the path and back. If the path is at rest,
/// it is a single point.
std::vector<Vec3> drawn_path(const Path& path);

/// Returns the text of scene.json.
std::string scene_json(const Scene& scene);

/// Reads scene.json. Throws InputError naming file, key, value and what is expected.
Scene read_scene(const std::string& path);

}  // namespace armtune::internal::report
