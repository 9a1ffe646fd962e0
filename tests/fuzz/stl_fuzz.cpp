// Whatever the bytes of a mesh: as many triangles as it says, which come through scene.json to the page, or
// none.

#include "sim/cell/stl_file.hpp"
#include "tests/fuzz/support/run_folder.hpp"
#include "tuner/report/base64.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::fuzz {
namespace {

void check(std::string_view bytes) {
  constexpr std::size_t kMost = 500;
  static const RunFolder folder;
  static const report::Scene scene = report::read_scene(folder.path() + "/scene.json");
  folder.write("mesh.stl", bytes);
  const auto corners = read_binary_stl(folder.path() + "/mesh.stl", kMost);
  if (!corners) return;
  require(corners->size() % 9 == 0 && !corners->empty() && corners->size() <= 9 * kMost);
  for (const float corner : *corners) require(std::isfinite(corner));
  report::Scene with_mesh = scene;
  report::ArmShape mesh;
  mesh.kind = ShapeKind::kMesh;
  mesh.triangles = report::base64_f32(*corners);
  with_mesh.arms.front().shapes.push_back(mesh);
  folder.write("scene.json", report::scene_json(with_mesh));
  const report::ReportData data = report::report_of(folder.path());
  require(data.left_out.empty() && data.arms.front().shapes.back().triangles == mesh.triangles);
  require(report::report_json(data).find(mesh.triangles) != std::string::npos);
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}
