#pragma once
// Writes the files that conclude a run: scene.json for the 3D replay, report.html and verdict.yaml.

#include <functional>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/plant/stepper.hpp"
#include "tuner/report/report.hpp"
#include "tuner/report/scene.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Names of the scene and of the report page in a run's folder.
inline constexpr const char* kScene = "scene.json";
inline constexpr const char* kReport = "report.html";

/// Calls `scene` and writes its result as scene.json. Then writes report.html if armtune was built with the
/// report page. Returns the names of the written files. Never throws but only warns, because the run itself
/// is finished.
std::vector<std::string> add_report(const std::string& folder, const std::function<report::Scene()>& scene,
                                    SessionObserver& observer);

/// Writes report.html of a run without a scene. Returns true if it was written. Only warns where add_report()
/// does.
bool add_page(const std::string& folder, SessionObserver& observer);

/// Writes scene.json when a run begins. Thus a report has a replay even if it is made during the run, or
/// after the run was killed. `add_report` rewrites the file at the end. Throws InputError if it cannot be
/// written.
void write_scene(const std::string& folder, const report::Scene& scene);

/// Warns about each file that the report leaves out.
void warn_of_left_out(const report::Written& written, SessionObserver& observer);

/// The options of record_set().
struct RecordOptions {
  Stepper stepper = Stepper::kMidpoint;
  int workers = 1;
};

/// Simulates a gain set for the report only, and writes gains.yaml, errors.csv and rollout_SCENARIO.csv into
/// FOLDER/BELOW. Call it in the function `scene` that is passed to add_report, which catches its errors.
report::SceneSet record_set(const std::string& name, const std::string& folder, const std::string& below,
                            const std::vector<Scenario>& scenarios, const Gains& gains,
                            const RecordOptions& options);

/// Writes FOLDER/verdict.yaml. Call it before add_report, because the report begins with the verdict.
void write_verdict(const std::string& folder, const SimulationVerdict& verdict);

}  // namespace armtune::internal
