// Reads and writes scene.json, by the declarations of the types of a scene. Also checks the indices and paths
// in the file, because it may come from another person.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "armtune/error.hpp"
#include "tuner/record/json_reader.hpp"
#include "tuner/record/json_writer.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal {
namespace {

/// Time [s], position [m], velocity and acceleration.
using KnotRow = Eigen::Matrix<double, 10, 1>;

/// A path in the form of the file.
struct StoredPath {
  Path path;
  std::vector<KnotRow> knots;
  bool loops = false;

  static void declare(auto& f, auto& stored) {
    f("center", stored.path.center)("frequency", stored.path.frequency)("phase", stored.path.phase);
    f("terms", stored.path.terms)("knots", stored.knots, "", record::Presence::kIfAny);
    if (!stored.knots.empty()) f("loops", stored.loops, "", record::Presence::kLater);
  }
};

}  // namespace

static void declare(auto& f, record::Of<HarmonicTerm> auto& term) {
  f("order", term.order)("cosine", term.cosine)("sine", term.sine);
}

static void write(std::string& out, const Path& path) {
  StoredPath stored{path, {}, false};
  if (path.spline) {
    stored.loops = path.spline->loops();
    for (std::size_t k = 0; k < path.spline->time().size(); ++k) {
      const MotionPoint<Vec3>& knot = path.spline->knots()[k];
      KnotRow& row = stored.knots.emplace_back();
      row << path.spline->time()[k], knot.position, knot.velocity, knot.acceleration;
    }
  }
  record::write(out, stored);
}

static void read(const yaml::Node& node, Path& path) {
  StoredPath stored;
  record::read(node, stored);
  path = std::move(stored.path);
  if (node.find("knots") == nullptr) return;
  std::vector<double> time;
  std::vector<MotionPoint<Vec3>> knots;
  for (const KnotRow& row : stored.knots) {
    time.push_back(row[0]);
    knots.push_back({row.segment<3>(1), row.segment<3>(4), row.segment<3>(7)});
  }
  try {
    path.spline = std::make_shared<const PositionSpline>(time, knots, stored.loops);
  } catch (const InputError& e) {
    node.find("knots")->fail(e.what());
  }
}

namespace report {
namespace {

/// Enough for the meshes of about twenty arms. The limit is needed because the YAML reader can take a hundred
/// times the size of the file in memory.
constexpr std::size_t kMaxSceneBytes = 32 << 20;

/// Fails if the path leads out of the run's folder, because the file there would be read and shown.
void require_inside(const yaml::Node& node) {
  const std::filesystem::path path = node.as_string();
  if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end())
    node.fail(fmt::format("'{}' is outside the run's folder; expected a path inside it", path.string()));
}

/// Fails unless the text is base64 of nine float32 values for each triangle, which needs no padding.
void require_triangles(const yaml::Node& node) {
  constexpr std::size_t kOfTriangle = 48;
  constexpr const char* kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string text = node.as_string();
  if (text.size() % kOfTriangle != 0 || text.find_first_not_of(kAlphabet) != std::string::npos)
    node.fail("expected triangles in base64, nine float32 values each");
}

void require_index(const yaml::Node& node, long first, std::size_t count, const char* what) {
  const long index = node.as_integer();
  if (index < first || index >= static_cast<long>(count)) node.fail(fmt::format("there is no such {}", what));
}

/// Checks what the declarations do not express: paths, indices and triangles. The scene must match the
/// declarations.
void check(const yaml::Node& root) {
  for (const yaml::Node& set : root.find("sets")->items()) {
    require_inside(*set.find("folder"));
    require_inside(*set.find("errors"));
  }
  const std::vector<yaml::Node>& arms = root.find("robots")->items();
  for (const yaml::Node& arm : arms) {
    for (const yaml::Node& shape : arm.find("shapes")->items()) {
      require_index(*shape.find("joint"), -1, arm.find("joints")->items().size(), "joint of this robot");
      if (const yaml::Node* triangles = shape.find("triangles")) require_triangles(*triangles);
    }
  }
  for (const yaml::Node& scenario : root.find("scenarios")->items())
    require_index(*scenario.find("robot"), 0, arms.size(), "robot in this file");
}

}  // namespace

/// Reads an obstacle. In older files it is only a path, and the obstacle is a point.
static void read(const yaml::Node& node, SceneObstacle& obstacle) {
  if (node.find("path") == nullptr) return armtune::internal::read(node, obstacle.path);
  record::read(node, obstacle);
}

std::string scene_json(const Scene& scene) {
  return record::json_of(scene) + '\n';
}

Scene read_scene(const std::string& path) {
  const yaml::Node root = yaml::parse_file(path, kMaxSceneBytes);
  Scene scene;
  record::read(root, scene);
  check(root);
  return scene;
}

}  // namespace report
}  // namespace armtune::internal
