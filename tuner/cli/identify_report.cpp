#include "tuner/cli/identify_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {
namespace {

constexpr double kUncertain = 0.3;  ///< relative standard deviation from which a group is called uncertain
constexpr std::size_t kShownGroup = 44;

std::string shortened(const std::string& name) {
  return name.size() <= kShownGroup ? name : fmt::format("{:.{}}...", name, kShownGroup - 3);
}

void print_base_parameters(const RobotModel& model, const Identification& found) {
  const Eigen::VectorXd file = found.base.map * theta_of(model.chain);
  const Eigen::VectorXd deviation = found.estimate.deviation();
  say(fmt::format("{:<44}{:>12}{:>10}{:>12}\n", "base parameter (sum of inertial parameters)", "estimate",
                  "+-", "robot file"));
  for (Eigen::Index b = 0; b < file.size(); ++b) {
    say(fmt::format("{:<44}{:>12.5g}{:>10}{:>12.5g}\n",
                    shortened(found.base.names[static_cast<std::size_t>(b)]), found.estimate.theta[b],
                    std::isfinite(deviation[b]) ? fmt::format("{:.2g}", deviation[b]) : "unknown", file[b]));
  }
}

std::string share(double part, double whole) {
  return whole > 0.0 ? fmt::format("{:.2f} %", 100.0 * part / whole) : "-";
}

void print_unexplained(const RobotModel& model, const Identification& found) {
  const bool held_out = found.held_out.rows > 0;
  say(fmt::format("\nShare of each joint's RMS torque that the model does not explain:\n"));
  say(fmt::format("{:<28}{:>12}{:>13}{:>13}{:>13}\n", "", "torque RMS", "theta.yaml", "theta.yaml",
                  "robot file"));
  say(fmt::format("{:<28}{:>12}{:>13}{:>13}{:>13}\n", "joint", "[N m, N]", "fitted", "held out",
                  "unchanged"));
  for (int j = 0; j < model.n(); ++j) {
    const Unexplained& fitted = found.fitted;
    const Unexplained& out = found.held_out;
    say(fmt::format("{:<28} {:>11.4g}{:>13}{:>13}{:>13}\n", model.joints[static_cast<std::size_t>(j)].name,
                    fitted.torque[j], share(fitted.by_theta[j], fitted.torque[j]),
                    held_out ? share(out.by_theta[j], out.torque[j]) : "-",
                    share(fitted.by_file[j], fitted.torque[j])));
  }
}

void print_not_excited(const Identification& found) {
  const std::vector<int>& groups = found.estimate.not_excited;
  if (groups.empty()) return;
  say(fmt::format("\nThese logs do not excite {} base parameters, which stay near the robot file's values:\n",
                  groups.size()));
  for (const int b : groups) say(fmt::format("  {}\n", found.base.names[static_cast<std::size_t>(b)]));
}

void print_fit(const RobotModel& model, const Identification& found) {
  print_base_parameters(model, found);
  print_unexplained(model, found);
  print_not_excited(found);
  say(
      fmt::format("\n{} samples, {} equations fitted and {} held out for the check; {} base parameters "
                  "(independent combinations of {} parameters); condition number {:.4g}\n",
                  found.samples, found.fitted.rows * model.n(), found.held_out.rows * model.n(),
                  found.base.rank(), found.theta.size(), found.estimate.condition));
  if (found.made_physical) {
    say(fmt::format(
        "No physical arm can have the estimated parameters. theta.yaml has the nearest possible ones.\n"));
  }
  if (!found.comparison.most_joints_move) {
    say("Fewer than half of the joints move, so signs, zero positions and columns were not checked.\n");
  }
  const Eigen::VectorXd deviation = found.estimate.deviation();
  long uncertain = 0;
  for (Eigen::Index b = 0; b < deviation.size(); ++b) {
    if (std::isfinite(deviation[b]) && deviation[b] > kUncertain * std::abs(found.estimate.theta[b]))
      ++uncertain;
  }
  if (uncertain > 0) {
    say(fmt::format(
        "{} base parameters have a standard deviation above {:.0f} % of their value: they are small, or the "
        "motion hardly excites them.\n",
        uncertain, 100.0 * kUncertain));
  }
}

}  // namespace

void print_identification(const IdentifySettings& settings, const IdentifyOutcome& outcome) {
  print_fit(*settings.model, outcome.found);
  if (!outcome.files.empty())
    say(fmt::format("wrote {}: {}\n", settings.folder, fmt::join(outcome.files, ", ")));
  if (outcome.doubts.empty()) return;
  say("\nThe logs do not fit the robot file:\n");
  for (const std::string& doubt : outcome.doubts) say(fmt::format("  {}.\n", doubt));
  if (!outcome.files.empty()) return;
  say(settings.accept ? "Nothing was written, because no folder is given; add --out.\n"
                      : "Nothing was written. If you know that the logs are right, add --accept.\n");
}

}  // namespace armtune::internal::cli
