#include "tuner/cli/identify_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace armtune::cli {
namespace {

constexpr double kUncertain = 0.3;  ///< relative standard deviation from which a group is called uncertain
constexpr std::size_t kShownGroup = 44;

std::string shortened(const std::string& name) {
  return name.size() <= kShownGroup ? name : name.substr(0, kShownGroup - 3) + "...";
}

void print_base_parameters(const RobotModel& model, const Identification& found) {
  const Eigen::VectorXd file = found.base.map * theta_of(model.chain);
  const Eigen::VectorXd deviation = found.estimate.deviation();
  fmt::print("{:<44}{:>12}{:>10}{:>12}\n", "base parameter (group of inertial ones)", "estimate", "+-",
             "robot file");
  for (Eigen::Index b = 0; b < file.size(); ++b) {
    fmt::print("{:<44}{:>12.5g}{:>10}{:>12.5g}\n", shortened(found.base.names[static_cast<std::size_t>(b)]),
               found.estimate.theta[b],
               std::isfinite(deviation[b]) ? fmt::format("{:.2g}", deviation[b]) : "unknown", file[b]);
  }
}

std::string share(double part, double whole) {
  return whole > 0.0 ? fmt::format("{:.2f} %", 100.0 * part / whole) : "-";
}

void print_unexplained(const RobotModel& model, const Identification& found) {
  const bool held_out = found.held_out.rows > 0;
  fmt::print("\nShare of each joint's torque that is not explained (RMS):\n");
  fmt::print("{:<28}{:>12}{:>13}{:>13}{:>13}\n", "", "torque RMS", "theta.yaml", "theta.yaml", "robot file");
  fmt::print("{:<28}{:>12}{:>13}{:>13}{:>13}\n", "joint", "[N m, N]", "fitted to", "held out",
             "as it stands");
  for (int j = 0; j < model.n(); ++j) {
    const Unexplained& fitted = found.fitted;
    const Unexplained& out = found.held_out;
    fmt::print("{:<28} {:>11.4g}{:>13}{:>13}{:>13}\n", model.joints[static_cast<std::size_t>(j)].name,
               fitted.torque[j], share(fitted.by_theta[j], fitted.torque[j]),
               held_out ? share(out.by_theta[j], out.torque[j]) : "-",
               share(fitted.by_file[j], fitted.torque[j]));
  }
}

void print_not_excited(const Identification& found) {
  const std::vector<int>& groups = found.estimate.not_excited;
  if (groups.empty()) return;
  fmt::print("\nThese logs do not excite {} groups, which stay near the robot file's values:\n",
             groups.size());
  for (const int b : groups) fmt::print("  {}\n", found.base.names[static_cast<std::size_t>(b)]);
}

}  // namespace

void print_identification(const RobotModel& model, const Identification& found) {
  print_base_parameters(model, found);
  print_unexplained(model, found);
  print_not_excited(found);
  fmt::print(
      "\n{} samples, {} rows to fit and {} held out, {} base parameters of {}, condition number {:.4g}\n",
      found.samples, found.fitted.rows * model.n(), found.held_out.rows * model.n(), found.base.rank(),
      found.theta.size(), found.estimate.condition);
  if (found.made_physical) {
    fmt::print("The estimate is not one that a physical arm can have. theta.yaml is the nearest that is.\n");
  }
  const Eigen::VectorXd deviation = found.estimate.deviation();
  long uncertain = 0;
  for (Eigen::Index b = 0; b < deviation.size(); ++b) {
    if (std::isfinite(deviation[b]) && deviation[b] > kUncertain * std::abs(found.estimate.theta[b]))
      ++uncertain;
  }
  if (uncertain > 0) {
    fmt::print(
        "{} groups have a standard deviation above {:.0f} % of their value: they are small, or the motion "
        "hardly "
        "excites them.\n",
        uncertain, 100.0 * kUncertain);
  }
}

}  // namespace armtune::cli
