#pragma once
// Writes the files with which a run ends: scene.json for the 3D replay, report.html and verdict.yaml.

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

/// Writes the result of `scene` as scene.json, and writes report.html if armtune is built with its page.
/// Returns the names of the files written. Never throws, because the run itself is finished: it only warns.
std::vector<std::string> add_report(const std::string& folder, const std::function<report::Scene()>& scene,
                                    SessionObserver& observer);

/// Writes scene.json when a run begins, so that a page made while the run is under way, or after it was
/// killed, has a replay too. `add_report` rewrites the file at the end. Throws InputError if it cannot be
/// written.
void write_scene(const std::string& folder, const report::Scene& scene);

/// Warns of each part that is missing in the report.
void warn_of_left_out(const report::Written& written, SessionObserver& observer);

/// The way in which a gain set is simulated for the report only.
struct RecordOptions {
  Stepper stepper = Stepper::kMidpoint;
  int workers = 1;
};

/// Simulates a gain set and writes gains.yaml, errors.csv and rollout_SCENARIO.csv into FOLDER/BELOW. Call it
/// inside the `scene` of add_report.
report::SceneSet record_set(const std::string& name, const std::string& folder, const std::string& below,
                            const std::vector<Scenario>& scenarios, const Gains& gains,
                            const RecordOptions& options);

/// Writes FOLDER/verdict.yaml, which the report shows first.
void write_verdict(const std::string& folder, const SimulationVerdict& verdict);

}  // namespace armtune::internal
