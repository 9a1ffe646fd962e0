#pragma once
// The data about a calibration on a report page: the parameters of the arm before and after, and the error of
// simulated motion on the held-out part of the log.

#include <string>
#include <vector>

#include "tuner/record/declaration.hpp"

namespace armtune::internal::report {

using enum record::Presence;

struct CalibratedParameterRow {
  std::string name, unit;
  double before = 0.0, after = 0.0, low = 0.0, high = 0.0;
  bool told = false, kept = false;
  std::string motion;

  static void declare(auto& f, auto& one) {
    f.type("CalibratedParameter", "A parameter that was fitted to logs.")("name", one.name)("unit", one.unit);
    f("before", one.before, "Value of the robot file.", kOrNull)("after", one.after, "", kOrNull);
    f("low", one.low, "95 % interval of the value.", kOrNull)("high", one.high, "", kOrNull);
    f("told", one.told, "True if the log tells it.");
    f("kept", one.kept, "True if the calibrated arm keeps the value of the robot file.");
    f("motion", one.motion, "What a motion that tells it must contain.", kIfAny);
  }
};

struct HeldOutJoint {
  std::string joint;
  std::vector<double> before, after;

  static void declare(auto& f, auto& one) {
    f.type("HeldOutJoint", "RMS position errors of a joint, rad or m, one for each horizon.");
    f("joint", one.joint)("before", one.before, "With the robot file.", kOrNull);
    f("after", one.after, "With the calibrated arm.", kOrNull);
  }
};

struct CalibrationData {
  std::vector<CalibratedParameterRow> parameters;
  std::vector<double> horizons, windows;
  std::vector<HeldOutJoint> joints;

  static void declare(auto& f, auto& all) {
    f.type("Calibration", "The fit of an arm to logs.")("parameters", all.parameters);
    f("horizons", all.horizons, "Times ahead, s.", kOrNull);
    f("windows", all.windows, "Windows of the held-out part that reach each horizon.", kOrNull);
    f("joints", all.joints);
  }
};

}  // namespace armtune::internal::report
