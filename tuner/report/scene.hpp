#pragma once
// The scene of a run, stored in scene.json beside the CSV files. It contains what a 3D replay needs in
// addition to these: the arms, the tool paths, the obstacles and the parts of the cell.

#include <optional>
#include <string>
#include <vector>

#include "core/trajectory/path.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/report/arm.hpp"
#include "tuner/report/run_kind.hpp"

namespace armtune::internal::report {

/// A gain set of the run, with the place of its files gains.yaml and rollout_<scenario>.csv.
struct SceneSet {
  std::string name;
  std::string folder = ".";           ///< below the run's folder
  std::string errors = "errors.csv";  ///< below the run's folder

  static void declare(auto& f, auto& set) { f("name", set.name)("folder", set.folder)("errors", set.errors); }
};

struct SceneObstacle {
  Path path;
  double radius = 0.0;  ///< radius of its body [m]

  static void declare(auto& f, auto& obstacle) { f("radius", obstacle.radius)("path", obstacle.path); }
};

/// A part of the robot's cell, such as a table. Its shape belongs to no joint, and its path is that of its
/// centre.
struct ScenePart {
  std::string name;
  ArmShape shape;
  Path path;

  static void declare(auto& f, auto& part) { f("name", part.name)("shape", part.shape)("path", part.path); }
};

struct SceneScenario {
  std::string name;
  double duration = 0.0;  ///< [s]
  std::size_t arm = 0;    ///< index into Scene::arms
  Path path;              ///< path of the tool
  std::vector<SceneObstacle> obstacles;
  double influence_radius = 0.0;  ///< from the first set's gains [m]; 0 without obstacles
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

/// Returns the gain sets of a run without scene.json, by the kind of run. For a comparison it reads them
/// from the run's file. Throws InputError if that cannot be read.
std::vector<SceneSet> usual_sets(RunKind kind, const std::string& folder);

/// Makes the scene of scenarios and sets. influence_radius: of the reference gains [m].
Scene scene_of(const std::vector<Scenario>& scenarios, std::vector<SceneSet> sets, double influence_radius);

/// Returns a path as a closed polyline, accurate to a hundredth of a millimetre [m]. It covers one period, or
/// the way there and back if the path has no period, or is a single point if the path is at rest.
std::vector<Vec3> drawn_path(const Path& path);

/// Returns the text of scene.json.
std::string scene_json(const Scene& scene);

/// Reads scene.json. Throws InputError naming file, key, value and what is expected.
Scene read_scene(const std::string& path);

}  // namespace armtune::internal::report
