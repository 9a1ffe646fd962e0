#pragma once
// Sums a calibration up for people: by how much the error on the held-out part fell, which parameters the log
// does not tell, what motion would tell them, and what limits the result. Sentences have no full stop.

#include <optional>
#include <string>
#include <vector>

#include "tuner/calibration/calibrate.hpp"

namespace armtune::internal {

/// The error of the calibrated arm beside that of the robot file, at the longest horizon that held-out
/// windows reach.
struct HeldOutGain {
  std::size_t at = 0;    ///< index of the horizon in kReportedHorizons
  double horizon = 0.0;  ///< [s]
  long windows = 0;      ///< that reach it
  double ratio = 1.0;    ///< after over before: root mean square over the joints

  bool better() const { return ratio < 1.0; }
};

/// Compares both errors. The encoder noise is added to the errors, so that errors below it do not count.
HeldOutGain held_out_gain(const Calibration& found);

/// The parameters of one kind that the log does not tell.
struct UntoldKind {
  std::string what;                 ///< such as "rotor_inertia" or "payload/mass"
  std::vector<std::string> joints;  ///< names; empty: a parameter of the whole arm
  bool every_joint = false;         ///< true if the kind is told for no joint
};

/// Returns the kinds with parameters that the log does not tell; with `need` only those that this motion
/// would tell.
std::vector<UntoldKind> untold_kinds(const Calibration& found, std::optional<CalibrationNeed> need = {});

/// Returns the result as one sentence: the change of the error, and what the log does not tell.
std::string headline(const Calibration& found);

/// Returns one sentence for each motion that is missing in the log, with the parameters that it would tell.
std::vector<std::string> untold_sentences(const Calibration& found);

/// Returns what limits the result, one sentence each.
std::vector<std::string> caution_sentences(const Calibration& found);

}  // namespace armtune::internal
