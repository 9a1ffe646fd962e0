#include "tuner/cli/report_file.hpp"

#include <fmt/format.h>

#include <atomic>
#include <exception>

#include "sim/csv/text_file.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/rollouts/simulate.hpp"

namespace armtune::cli {

void warn_of_left_out(const report::Written& written) {
  for (const std::string& why : written.left_out) {
    fmt::print(stderr, "armtune: warning: left out of the report: {}\n", why);
  }
}

void write_scene(const std::string& folder, const report::Scene& scene) {
  write_text_file(folder + "/scene.json", report::scene_json(scene));
}

std::string add_report(const std::string& folder, const std::function<report::Scene()>& scene) {
  std::string written;
  try {
    write_scene(folder, scene());
    written = ", scene.json";
    if (!report::available()) return written;
    warn_of_left_out(report::write_report(folder, folder + "/report.html"));
    written += ", report.html";
  } catch (const std::exception& error) {
    fmt::print(stderr, "armtune: warning: the run is finished, but its report is not: {}\n", error.what());
  }
  return written;
}

report::SceneSet record_set(const std::string& name, const std::string& folder, const std::string& below,
                            const std::vector<Scenario>& scenarios, const Gains& gains,
                            const RecordOptions& options) {
  const std::atomic<bool> never{false};  // seconds, at the end of a run that took much longer
  SimulateOptions how;
  how.stepper = options.stepper;
  how.workers = options.workers;
  how.folder = folder + "/" + below;
  make_folder(how.folder);
  const auto results = simulate(
      scenarios, [&gains](const Scenario&) { return gains; }, how, never);
  write_text_file(how.folder + "/gains.yaml", gains_yaml(gains, {name}));
  write_text_file(how.folder + "/errors.csv", errors_csv(results));
  return {name, below, below + "/errors.csv"};
}

}  // namespace armtune::cli
