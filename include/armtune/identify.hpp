#pragma once
// An arm's inertial parameters from logs of its motion. Needs armtune built with SuiteSparse: link
// armtune::identification.

#include <string>
#include <vector>

#include "armtune/progress.hpp"
#include "armtune/robot.hpp"

namespace armtune {

struct IdentifyOptions {
  std::string folder = {};  ///< new, for all files of the run; empty: nothing is written
  std::string columns =
      {};  ///< a YAML file that names the logs' columns; empty: they are called as armtune calls them
  bool robust = false;  ///< outliers count less
  bool accept = false;  ///< write the result although the logs do not fit the model
  Watch watch = {};
};

/// RMS torques of the n joints [N m, N].
struct Residuals {
  std::vector<double> torque = {};    ///< the measured torque itself
  std::vector<double> by_theta = {};  ///< left unexplained by what was identified
  std::vector<double> by_file = {};   ///< left unexplained by the robot as it was given
};

struct Identified {
  std::vector<double> theta = {};        ///< 13 numbers for each joint, of an arm that can exist
  Residuals fitted = {}, held_out = {};  ///< on the samples of the fit, and on those left out of it
  std::vector<std::string> doubts = {};  ///< why the logs may not be of this arm, one sentence each
  bool interrupted = false;
  std::vector<std::string> files = {};  ///< names of those in the folder
};

/// Throws InputError for logs that cannot be used or a folder that is used; FailedError if a file cannot be
/// written.
Identified identify(const Robot& robot, const std::vector<std::string>& logs,
                    const IdentifyOptions& options = {});

}  // namespace armtune
