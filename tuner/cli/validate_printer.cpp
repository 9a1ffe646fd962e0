#include "tuner/cli/validate_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "tuner/cli/say.hpp"
#include "tuner/cli/wrapped_text.hpp"

namespace armtune::internal::cli {
namespace {

constexpr std::size_t kJointWidth = 20;

/// Returns an error in mrad or mm.
std::string shown_error(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", 1e3 * value) : "-";
}

void print_joints(const RobotModel& model, const LogValidation& found) {
  std::string head = fmt::format("\n{:<{}}", "joint", kJointWidth);
  std::string units = fmt::format("{:<{}}", "", kJointWidth);
  if (found.torques) {
    head += fmt::format("{:>10}{:>9}{:>8}", "explained", "residual", "torque");
    units += fmt::format("{:>10}{:>9}{:>8}", "", "[N m, N]", "");
  }
  if (found.motion) {
    for (const double horizon : kReportedHorizons) head += fmt::format("{:>7}", fmt::format("{} s", horizon));
    units += fmt::format("{:>28}", "prediction error [mrad, mm]");
  }
  units.erase(units.find_last_not_of(' ') + 1);
  say(head + "  ok?\n" + units + "\n");
  for (int j = 0; j < model.n(); ++j) {
    const auto joint = static_cast<std::size_t>(j);
    std::string row = fmt::format("{:<{}.{}}", model.joints[joint].name, kJointWidth, kJointWidth - 1);
    if (found.torques) {
      const JointResidual& residual = found.torques->residuals.joint[joint];
      row += fmt::format("{:>10}{:>9.3g}{:>8.3g}", fmt::format("{:.1f} %", 100.0 * residual.explained),
                         residual.rms, residual.torque_rms);
    }
    if (found.motion) {
      for (const double horizon : kReportedHorizons) {
        const std::size_t at = found.motion->index_of(horizon);
        // A log that has only shorter parts has no error at this horizon.
        const bool reached = found.motion->horizons[at] > horizon - 0.011;
        row += fmt::format("{:>7}", reached ? shown_error(found.motion->joint[joint].rms[at]) : "-");
      }
    }
    say(row + (found.matches(j) ? "  yes\n" : "  NO\n"));
  }
}

void print_thresholds(const ValidationThresholds& thresholds) {
  say("\nThresholds\n");
  for (const ValidationThresholdField& field : validation_threshold_fields()) {
    const std::string unit = *field.unit == '\0' ? "" : fmt::format(" [{}]", field.unit);
    say_wrapped(fmt::format("{} = {:.4g}: {}{}", field.name, thresholds.*field.value, field.meaning, unit));
  }
}

}  // namespace

void print_validation(const ValidateSettings& settings, const ValidateOutcome& outcome) {
  const RobotModel& model = *settings.model;
  const JointLog& log = outcome.logged.log;
  const LogValidation& found = outcome.found;
  say(fmt::format("{}: {} samples in {:.4g} s, compared with {} as its file describes it\n", log.source,
                  log.samples(), log.time.back() - log.time.front(), model.name));
  for (const std::string& note : outcome.logged.notes) say_wrapped(note);
  if (found.torques || found.motion) print_joints(model, found);
  say_list("Joints and likely causes", cause_sentences(found, model));
  say_list("Findings about the log", finding_sentences(found, model));
  say_list("Not compared", found.not_compared);
  print_thresholds(found.thresholds);
  if (!outcome.files.empty())
    say(fmt::format("\nwrote {}: {}\n", settings.folder, fmt::join(outcome.files, ", ")));
  say("\n");
  say_wrapped(headline(found, model) + ".", "");
}

}  // namespace armtune::internal::cli
