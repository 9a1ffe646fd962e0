#include "tuner/identification/identify.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/common/error.hpp"

namespace armtune {
namespace {

/// Huber's constant: 95 % of the efficiency of least squares on normal errors. Huber, Robust Statistics,
/// 1981.
constexpr double kHuber = 1.345;

/// Multiplies each row by the root of Huber's weight of its residual.
void weigh(const Estimate& last, Eigen::MatrixXd& rows) {
  const Eigen::Index rank = last.theta.size();
  for (Eigen::Index j = 0; j < rows.rows(); ++j) {
    const double residual = std::abs(rows(j, rank) - rows.row(j).head(rank).dot(last.theta));
    const double bound = kHuber * last.torque_residual[j];
    if (residual > bound) rows.row(j) *= std::sqrt(bound / residual);
  }
}

}  // namespace

Identification identify(const RobotModel& model, const std::vector<std::string>& logs,
                        const LogColumns& columns, const IdentifyOptions& options,
                        const std::atomic<bool>& stop) {
  Identification found;
  found.base = base_parameters(model);
  const ParameterVector file_theta = theta_of(model.chain);
  const Eigen::VectorXd prior = found.base.map * file_theta;
  const int passes = options.robust ? std::max(2, options.passes) : 1;
  for (int pass = 0; pass < passes && !stop; ++pass) {
    Regression regression(model.n(), found.base.rank());
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(model.n());
    long rows_seen = 0;
    found.samples = 0;
    for (std::size_t i = 0; i < logs.size() && !stop; ++i) {
      LogFile log(logs[i], columns);
      RowStream stream(model, found.base, log, options.rows);
      regression.begin_log();
      Eigen::MatrixXd rows;
      long of_this_log = 0;
      while (!stop && stream.next(rows)) {
        squares += rows.rightCols<1>().cwiseAbs2();
        ++of_this_log;
        if (pass > 0) weigh(found.estimate, rows);
        regression.add(rows);
        if (options.progress) options.progress(pass, i, found.samples + stream.samples());
      }
      found.samples += stream.samples();
      rows_seen += of_this_log;
      if (of_this_log == 0 && !stop) {
        throw InputError(fmt::format(
            "{}: {} samples of {:.4g} s are shorter than the filters' window at a cutoff of {} Hz; "
            "log longer or raise --cutoff",
            logs[i], stream.samples(), log.period(), options.rows.cutoff));
      }
    }
    if (stop) break;
    if (rows_seen * model.n() <= found.base.rank()) {
      throw InputError(fmt::format("{} rows for {} base parameters: log longer", rows_seen * model.n(),
                                   found.base.rank()));
    }
    found.estimate = regression.solve(prior);
    found.torque_rms = (squares / static_cast<double>(rows_seen)).cwiseSqrt();
  }
  found.interrupted = stop;
  if (found.interrupted) return found;
  const PhysicalFit fit = physical_fit(found.base, found.estimate, file_theta);
  found.theta = fit.theta;
  found.made_physical = fit.changed;
  return found;
}

}  // namespace armtune
