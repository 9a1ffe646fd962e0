#pragma once
// Identification from logs: rows, weighted or robust regression, physically valid theta.

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "tuner/identification/physical_fit.hpp"
#include "tuner/identification/row_stream.hpp"

namespace armtune {

struct IdentifyOptions {
  RowOptions rows;
  bool robust = false;  ///< iteratively reweighted with Huber's weights: outliers count less; on
                        ///< normal errors stated deviations come out some 10 % small
  int passes = 5;       ///< of robust regression, over all logs
  std::function<void(int pass, std::size_t log, long samples)> progress;
};

struct Identification {
  BaseParameters base;
  Estimate estimate;
  ParameterVector theta;       ///< 13 n, physically valid
  bool made_physical = false;  ///< the estimate itself was not
  Eigen::VectorXd torque_rms;  ///< of the filtered torques per joint (n)
  long samples = 0;            ///< of all logs
  bool interrupted = false;
};

/// Identifies theta of an arm of the model's geometry. Throws InputError for logs that cannot be used.
Identification identify(const RobotModel& model, const std::vector<std::string>& logs,
                        const LogColumns& columns, const IdentifyOptions& options,
                        const std::atomic<bool>& stop);

}  // namespace armtune
