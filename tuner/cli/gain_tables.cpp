#include "tuner/cli/gain_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tuner/verdict/search_checks.hpp"

namespace armtune::internal::cli {
namespace {

/// Width of the column of names, unless a name is longer.
constexpr std::size_t kNameWidth = 38;

}  // namespace

std::string gains_table(const Study& study, const TuneResult& result) {
  const Gains& gains = result.best.gains;
  const std::string found = name(outcome_of(result));
  std::size_t width = kNameWidth;
  for (const Parameter& p : study.space.free) width = std::max(width, p.entry.name.size());
  std::string text = fmt::format("{:<{}}{:>10}{:>16}{:>8}\n", "gain", width, "start", found, "ratio");
  for (const Parameter& p : study.space.free) {
    const double tuned = value(gains, p.entry);
    text += fmt::format("{:<{}}{:>10.5g}{:>16.5g}{:>8}{}\n", p.entry.name, width, p.start, tuned,
                        p.start > 0.0 ? fmt::format("{:.3f}", tuned / p.start) : "-",
                        on_bound(p, tuned) ? "  bound" : "");
  }
  return text;
}

std::string sensitivity_table(const Study& study, const Sensitivity& sensitivity, std::size_t most) {
  const std::size_t shown = std::min(most, sensitivity.parameters.size());
  const auto parameter = [&](std::size_t i) -> const Parameter& {
    return study.space.free[sensitivity.parameters[i].parameter];
  };
  std::size_t width = kNameWidth;
  for (std::size_t i = 0; i < shown; ++i) width = std::max(width, parameter(i).entry.name.size());
  std::string text = fmt::format("{:<{}}{:>10}{:>10}{:>12}{:>10}\n", "gain, most important first", width,
                                 "start", "best", "importance", "local");
  for (std::size_t i = 0; i < shown; ++i) {
    const ParameterSensitivity& s = sensitivity.parameters[i];
    text += fmt::format("{:<{}}{:>10.4g}{:>10.4g}{:>12.4f}{:>10}\n", parameter(i).entry.name, width,
                        parameter(i).start, s.best, s.importance, fmt::format("{:.2f} %", 100.0 * s.local));
  }
  return text;
}

}  // namespace armtune::internal::cli
