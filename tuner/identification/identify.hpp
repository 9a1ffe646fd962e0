#pragma once
// Identifies theta, an arm's inertial and friction parameters, from logs. The logs are converted to the rows
// of a regression, weighted or robust. The regression estimates the base parameters, the combinations of
// theta that can be identified (base_parameters.hpp). The estimate is then completed to a physically valid
// theta.

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "tuner/identification/log_mistakes.hpp"
#include "tuner/identification/physical_fit.hpp"
#include "tuner/identification/row_stream.hpp"

namespace armtune::internal {

struct IdentifyOptions {
  RowOptions rows;
  bool robust = false;   ///< true: repeated passes with Huber's weights, so that outliers count less; with
                         ///< normal errors, the reported standard deviations are some 10 % too small
  int passes = 5;        ///< passes of robust regression over all logs; at least 2 are made
  bool hold_out = true;  ///< true: every fifth second of a log is not fitted but used to check the result
  std::function<void(int pass, std::size_t log, long samples)> progress;
};

/// RMS values per joint (n) [N m, N] over some rows of the logs: of the torque, and of the part of it that
/// the parameters do not explain.
struct Unexplained {
  long rows = 0;             ///< number of rows per joint
  Eigen::VectorXd torque;    ///< RMS of the filtered torque itself
  Eigen::VectorXd by_theta;  ///< RMS of the part that the identified theta leaves unexplained
  Eigen::VectorXd by_file;   ///< RMS of the part that the unchanged robot file leaves unexplained
  Eigen::VectorXd file;      ///< RMS of the torque that the unchanged robot file predicts
};

struct Identification {
  BaseParameters base;
  Estimate estimate;
  ParameterVector theta;       ///< 13 n, physically valid
  bool made_physical = false;  ///< true if the estimate itself was not physically valid
  Unexplained fitted;          ///< on the rows that theta was fitted to
  Unexplained held_out;        ///< on the rows that were held out; no rows without IdentifyOptions::hold_out
  JointVector torque_noise;    ///< standard deviation of the noise in the rows' torques (n) [N m, N]
  LogComparison comparison;    ///< comparison of the logs with the robot file
  long samples = 0;            ///< number of samples in all logs
  std::vector<std::string> log_hashes;  ///< hash of each log, as it was read
  bool interrupted = false;
};

/// Identifies theta of an arm whose geometry is that of the model. Throws InputError for logs that cannot be
/// used.
Identification identify(const RobotModel& model, const std::vector<std::string>& logs,
                        const LogColumns& columns, const IdentifyOptions& options,
                        const std::atomic<bool>& stop);

}  // namespace armtune::internal
