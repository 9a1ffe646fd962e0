#pragma once
// Identifies the inertial and friction parameters of an arm from logs of its motion. This requires an armtune
// that was built with SuiteSparse. Link the library armtune::identification.

#include <string>
#include <vector>

#include "armtune/progress.hpp"
#include "armtune/robot.hpp"

namespace armtune {

struct IdentifyOptions {
  std::string folder = {};  ///< new folder for all files of the run; empty: nothing is written
  std::string columns =
      {};  ///< path of a YAML file that names the logs' columns; empty: they have armtune's names
  bool robust = false;  ///< give outliers less weight
  bool accept = false;  ///< write the result even if the logs do not fit the model
  Watch watch = {};
};

/// The RMS torques of the n joints [N m, N].
struct Residuals {
  std::vector<double> torque = {};    ///< the measured torque itself
  std::vector<double> by_theta = {};  ///< part that the identified parameters do not explain
  std::vector<double> by_file = {};   ///< part that the model of the given robot does not explain
};

struct Identified {
  std::vector<double> theta = {};        ///< 13 for each joint, physically valid
  Residuals fitted = {}, held_out = {};  ///< on samples used in the fit, and on samples left out
  std::vector<std::string> doubts = {};  ///< why the logs may be of another arm, one sentence each
  bool interrupted = false;
  std::vector<std::string> files = {};  ///< names of the files in the folder
};

/// Identifies the parameters of an arm. Throws InputError if logs cannot be used or if the folder is in use;
/// FailedError if a file cannot be written.
Identified identify(const Robot& robot, const std::vector<std::string>& logs,
                    const IdentifyOptions& options = {});

}  // namespace armtune
