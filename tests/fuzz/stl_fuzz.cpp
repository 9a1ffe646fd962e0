// Whatever the bytes of a mesh, read as STL and as OBJ: it has whole triangles with finite coordinates, which
// come through scene.json to the page, or it is refused with a reason on one line.

#include "sim/cell/mesh_file.hpp"
#include "tests/fuzz/support/run_folder.hpp"
#include "tuner/report/base64.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::fuzz {
namespace {

constexpr std::size_t kMost = 500;

void check_page(const RunFolder& folder, const Mesh& read) {
  static const report::Scene scene = report::read_scene(folder.path() + "/scene.json");
  report::Scene with_mesh = scene;
  report::ArmShape mesh;
  mesh.kind = ShapeKind::kMesh;
  mesh.triangles = report::base64_f32(read.corners);
  with_mesh.arms.front().shapes.push_back(mesh);
  folder.write("scene.json", report::scene_json(with_mesh));
  const report::ReportData data = report::report_of(folder.path());
  require(data.left_out.empty() && data.arms.front().shapes.back().triangles == mesh.triangles);
  require(report::report_json(data).find(mesh.triangles) != std::string::npos);
}

void check(std::string_view bytes) {
  static const RunFolder folder;
  for (const char* name : {"mesh.stl", "mesh.obj"}) {
    folder.write(name, bytes);
    const Mesh mesh = read_mesh(folder.path() + "/" + name, kMost);
    require(mesh.corners.empty() != mesh.refusal.empty());
    require(mesh.refusal.find('\n') == std::string::npos && mesh.refusal.size() < 300);
    require(mesh.corners.size() % 9 == 0 && mesh.corners.size() <= 9 * kMost);
    for (const float corner : mesh.corners) require(std::isfinite(corner));
    if (mesh.refusal.empty()) check_page(folder, mesh);
  }
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}
