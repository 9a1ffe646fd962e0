#pragma once
// The report at the end of a run.

#include <functional>
#include <string>

#include "core/control/gains.hpp"
#include "sim/plant/stepper.hpp"
#include "tuner/report/report.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::cli {

/// Writes what `scene` gives as scene.json, and report.html where armtune has its page. Never throws: what
/// went wrong is told on stderr, for the run itself is finished. Returns ", scene.json, report.html" or what
/// of it was written, to follow the names of the other files.
std::string add_report(const std::string& folder, const std::function<report::Scene()>& scene);

/// Writes scene.json, which `add_report` writes anew, when a run begins: a page that is made while the run
/// goes on, or after it was killed, has a replay too. Throws InputError if it cannot be written.
void write_scene(const std::string& folder, const report::Scene& scene);

/// On stderr, a line each.
void warn_of_left_out(const report::Written& written);

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

}  // namespace armtune::cli
