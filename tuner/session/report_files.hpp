#pragma once
// The end of a run: its scene, its report and its verdict as files.

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

/// The pages of a run, by their names in its folder.
inline constexpr const char* kScene = "scene.json";
inline constexpr const char* kReport = "report.html";

/// Writes what `scene` gives as scene.json, and report.html where armtune has its page. Returns the names of
/// what was written. Never throws: what went wrong is warned of, for the run itself is finished.
std::vector<std::string> add_report(const std::string& folder, const std::function<report::Scene()>& scene,
                                    SessionObserver& observer);

/// Writes scene.json, which `add_report` writes anew, when a run begins: a page that is made while the run
/// is under way, or after it was killed, has a replay too. Throws InputError if it cannot be written.
void write_scene(const std::string& folder, const report::Scene& scene);

/// Warns of each part that the report does not have.
void warn_of_left_out(const report::Written& written, SessionObserver& observer);

/// How a gain set is simulated for the report alone.
struct RecordOptions {
  Stepper stepper = Stepper::kMidpoint;
  int workers = 1;
};

/// Simulates a gain set and leaves gains.yaml, errors.csv and rollout_SCENARIO.csv in FOLDER/BELOW. For
/// use inside `scene` of add_report.
report::SceneSet record_set(const std::string& name, const std::string& folder, const std::string& below,
                            const std::vector<Scenario>& scenarios, const Gains& gains,
                            const RecordOptions& options);

/// Writes FOLDER/verdict.yaml, which the report begins with.
void write_verdict(const std::string& folder, const SimulationVerdict& verdict);

}  // namespace armtune::internal
