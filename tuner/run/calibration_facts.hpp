#pragma once
// The part of a run's record (run_record.hpp) with the result of `calibrate`.

#include <optional>
#include <string>
#include <vector>

#include "tuner/record/declaration.hpp"

namespace armtune::internal {

/// A parameter that the logs of `calibrate` do not tell.
struct UntoldFact {
  std::string parameter;  ///< such as "elbow_joint/coulomb_friction"
  std::string needs;      ///< the motion that would tell it, as in calibrate.hpp, such as "reversals"
  bool operator==(const UntoldFact&) const = default;

  static void declare(auto& f, auto& one) {
    f.type("UntoldFact")("parameter", one.parameter)("needs", one.needs, "The motion that would tell it.");
  }
};

/// The result of `calibrate`.
struct CalibrationFacts {
  bool better = false;    ///< true if the calibrated arm is better on the held-out part of the logs
  std::string headline;   ///< the result as a sentence, for people
  std::string robot;      ///< name
  std::string commands;   ///< their kind
  long samples = 0;       ///< of all logs
  double duration = 0.0;  ///< of all logs [s]
  double horizon = 0.0;   ///< at which the arm is judged [s]
  long windows = 0;       ///< of the held-out part that reach it
  std::optional<double> error_ratio;  ///< error of the calibrated arm over that of the robot file
  long parameters = 0;                ///< number of fitted parameters
  std::vector<UntoldFact> not_told;
  std::vector<std::string> cautions;  ///< what limits the result, each a sentence
  std::vector<std::string> notes;     ///< how the logs were read
  bool operator==(const CalibrationFacts&) const = default;

  static void declare(auto& f, auto& found) {
    using enum record::Presence;
    f.type("CalibrationFacts")("better", found.better)("headline", found.headline)("robot", found.robot);
    f("commands", found.commands)("samples", found.samples)("duration", found.duration, "s");
    f("horizon", found.horizon, "s")("windows", found.windows);
    f("error_ratio", found.error_ratio, "Error of the calibrated arm over that of the robot file.", kIfAny);
    f("parameters", found.parameters)("not_told", found.not_told, "", kIfAny);
    f("cautions", found.cautions, "", kIfAny)("notes", found.notes, "", kIfAny);
  }
};

}  // namespace armtune::internal
