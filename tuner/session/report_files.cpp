#include "tuner/session/report_files.hpp"

#include <fmt/format.h>

#include <atomic>
#include <exception>

#include "sim/csv/text_file.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/rollouts/simulate.hpp"

namespace armtune::internal {
namespace {

void warn_of_no_report(const std::exception& error, SessionObserver& observer) {
  observer.warned(fmt::format("the run is finished, but its report was not written: {}", error.what()));
}

}  // namespace

void warn_of_left_out(const report::Written& written, SessionObserver& observer) {
  for (const std::string& why : written.left_out) observer.warned("left out of the report: " + why);
}

void write_scene(const std::string& folder, const report::Scene& scene) {
  write_text_file(folder + "/" + kScene, report::scene_json(scene));
}

void write_verdict(const std::string& folder, const SimulationVerdict& verdict) {
  write_text_file(folder + "/verdict.yaml", verdict_yaml(verdict));
}

std::vector<std::string> add_report(const std::string& folder, const std::function<report::Scene()>& scene,
                                    SessionObserver& observer) {
  std::vector<std::string> written;
  try {
    write_scene(folder, scene());
    written.emplace_back(kScene);
  } catch (const std::exception& error) {
    warn_of_no_report(error, observer);
    return written;
  }
  if (add_page(folder, observer)) written.emplace_back(kReport);
  return written;
}

bool add_page(const std::string& folder, SessionObserver& observer) {
  if (!report::available()) return false;
  try {
    warn_of_left_out(report::write_report(folder, folder + "/" + kReport), observer);
    return true;
  } catch (const std::exception& error) {
    warn_of_no_report(error, observer);
    return false;
  }
}

report::SceneSet record_set(const std::string& name, const std::string& folder, const std::string& below,
                            const std::vector<Scenario>& scenarios, const Gains& gains,
                            const RecordOptions& options) {
  const std::atomic<bool> never{false};  // takes only seconds, at the end of a long run
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

}  // namespace armtune::internal
