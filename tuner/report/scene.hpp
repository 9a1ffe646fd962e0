#pragma once
// What a run's CSV files do not say and its replay needs: scene.json, written beside them.

#include <string>
#include <vector>

#include "core/trajectory/path.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/report/arm.hpp"
#include "tuner/report/run_kind.hpp"

namespace armtune::report {

/// A gain set of the run and where its files are: gains.yaml and rollout_<scenario>.csv.
struct SceneSet {
  std::string name;
  std::string folder = ".";           ///< below the run's
  std::string errors = "errors.csv";  ///< below the run's
};

struct SceneObstacle {
  Path path;
  double radius = 0.0;  ///< of its body [m]
};

struct SceneScenario {
  std::string name;
  double duration = 0.0;  ///< [s]
  std::size_t arm = 0;    ///< index into Scene::arms
  Path path;              ///< of the tool
  std::vector<SceneObstacle> obstacles;
  double influence_radius = 0.0;  ///< [m], of the first set's gains; 0 without obstacles
};

struct Scene {
  std::vector<SceneSet> sets;  ///< the reference first, the result last
  std::vector<Arm> arms;
  std::vector<SceneScenario> scenarios;
};

/// The sets of a run that left no scene.json, by its kind; of a comparison by its file. Throws InputError if
/// that cannot be read.
std::vector<SceneSet> usual_sets(RunKind kind, const std::string& folder);

/// influence_radius: of the reference gains [m].
Scene scene_of(const std::vector<Scenario>& scenarios, std::vector<SceneSet> sets, double influence_radius);

/// A path [m] to be drawn closed: one period of it, there and back where it has none; a single point where it
/// is at rest.
std::vector<Vec3> drawn_path(const Path& path);

/// Text of scene.json.
std::string scene_json(const Scene& scene);

/// Throws InputError naming file, key, value and what is expected.
Scene read_scene(const std::string& path);

}  // namespace armtune::report
