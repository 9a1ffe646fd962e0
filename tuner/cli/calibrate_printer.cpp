#include "tuner/cli/calibrate_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "tuner/calibration/calibration_summary.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/wrapped_text.hpp"

namespace armtune::internal::cli {
namespace {

constexpr int kNameWidth = 34;
constexpr int kHeldOutJointWidth = 20;

/// Prints a row for each parameter that the log tells, those of one kind below a line with its name and unit.
void print_told(const Calibration& found) {
  say(fmt::format("\n{:<{}}{:>11}{:>11}{:>24}\n", "parameters that the log tells", kNameWidth, "robot file",
                  "calibrated", "95 % interval"));
  std::string last;
  for (const FittedParameter& p : found.parameters) {
    if (!p.told) continue;
    const std::size_t slash = p.prior.joint < 0 ? std::string::npos : p.prior.name.rfind('/');
    const std::string kind = slash == std::string::npos ? "whole arm" : p.prior.name.substr(slash + 1);
    if (kind != last)
      say(slash == std::string::npos ? kind + "\n" : fmt::format("{} [{}]\n", kind, p.prior.unit));
    last = kind;
    const std::string row = slash == std::string::npos ? fmt::format("{} [{}]", p.prior.name, p.prior.unit)
                                                       : p.prior.name.substr(0, slash);
    say(fmt::format("  {:<{}.{}}{:>11.4g}{:>11.4g}{:>24}\n", row, kNameWidth - 2, kNameWidth - 3,
                    p.prior.nominal, p.value, fmt::format("{:.4g} to {:.4g}", p.low, p.high)));
  }
}

/// Returns an error in mrad or mm.
std::string in_thousandths(double error) {
  return 1e3 * error < 999.5 ? fmt::format("{:.3g}", 1e3 * error) : fmt::format("{:.0f}", 1e3 * error);
}

/// Prints the errors of the robot file and of the calibrated arm, in mrad or mm.
void print_held_out(const RobotModel& model, const Calibration& found) {
  say("\nError on the held-out part [mrad, mm]: robot file > calibrated arm\n");
  std::string head = fmt::format("{:<{}}", "joint", kHeldOutJointWidth);
  for (const double horizon : kReportedHorizons) head += fmt::format("{:>15}", fmt::format("{} s", horizon));
  say(head + "\n");
  for (Eigen::Index j = 0; j < model.n(); ++j) {
    std::string row = fmt::format("{:<{}.{}}", model.joints[static_cast<std::size_t>(j)].name,
                                  kHeldOutJointWidth, kHeldOutJointWidth - 1);
    for (Eigen::Index h = 0; h < found.before.rms.rows(); ++h) {
      const double before = found.before.rms(h, j);
      const double after = found.after.rms(h, j);
      row += fmt::format("{:>15}", std::isfinite(before)
                                       ? fmt::format("{} > {}", in_thousandths(before), in_thousandths(after))
                                       : "-");
    }
    say(row + "\n");
  }
}

}  // namespace

void print_calibration(const CalibrateSettings& settings, const CalibrateOutcome& outcome) {
  const CalibrationFacts& facts = outcome.facts;
  say(fmt::format("{}: {} samples in {:.4g} s, {} commands\n", fmt::join(settings.logs, ", "), facts.samples,
                  facts.duration, facts.commands));
  for (const std::string& note : facts.notes) say_wrapped(note);
  print_told(outcome.found);
  say_list("What the log does not tell", untold_sentences(outcome.found));
  print_held_out(*settings.model, outcome.found);
  say_list("What limits the result", facts.cautions);
  if (!outcome.files.empty())
    say(fmt::format("\nwrote {}: {}\n", settings.folder, fmt::join(outcome.files, ", ")));
  say("\n");
  say_wrapped(facts.headline + ".", "");
}

}  // namespace armtune::internal::cli
