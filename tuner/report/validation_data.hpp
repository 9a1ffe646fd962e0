#pragma once
// The data about a validation on a report page: measured torques beside those that the robot file predicts,
// and the errors of simulated motion against the time ahead.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tuner/record/declaration.hpp"
#include "tuner/report/series.hpp"

namespace armtune::internal::report {

using enum record::Presence;

struct ValidatedTorque {
  std::string joint;
  std::optional<double> explained, residual_rms, torque_rms;
  Series measured, predicted, residual;

  static void declare(auto& f, auto& one) {
    f.type("ValidatedTorque", "The torque of a joint, N m, or N of a joint that slides.")("joint", one.joint);
    f("explained", one.explained, "Share of the torque's variance that the robot file explains.");
    f("residual_rms", one.residual_rms)("torque_rms", one.torque_rms);
    f("measured", one.measured, "As many points as `time`.")("predicted", one.predicted);
    f("residual", one.residual, "Measured minus predicted.");
  }
};

struct ValidatedMotion {
  std::string joint;
  std::vector<double> rms, low, high, yardstick;

  static void declare(auto& f, auto& one) {
    f.type("ValidatedMotion", "Position errors of a joint, rad or m, one for each horizon.");
    f("joint", one.joint)("rms", one.rms, "RMS over the windows of simulated minus logged position.",
                          kOrNull);
    f("low", one.low, "95 % interval of `rms`.", kOrNull)("high", one.high, "", kOrNull);
    f("yardstick", one.yardstick,
      "Error of the better of two predictions without a model: the joint stays, or keeps its velocity.",
      kOrNull);
  }
};

struct ValidationData {
  Series time;
  std::vector<ValidatedTorque> torques;
  std::vector<double> horizons;
  std::string commands;
  std::vector<ValidatedMotion> motion;
  std::vector<std::pair<std::string, std::string>> thresholds;

  static void declare(auto& f, auto& all) {
    f.type("Validation", "A log beside the predictions of a robot file.");
    f("time", all.time, "Time of the torques, s, thinned as the time of a run.")("torques", all.torques);
    f("horizons", all.horizons, "Times ahead, s.")("motion", all.motion);
    f("commands", all.commands, "Kind of the commands that the motion was simulated with.");
    f("thresholds", all.thresholds, "Name and value.");
  }
};

}  // namespace armtune::internal::report
