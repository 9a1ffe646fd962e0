#include "tuner/robustness/margin_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/csv/cell.hpp"

namespace armtune::internal {
namespace {

constexpr int kScenarioWidth = 30;
constexpr int kMarginWidth = 24;
constexpr int kValueWidth = 16;

std::vector<MarginKind> all_kinds() {
  std::vector<MarginKind> kinds;
  kinds.reserve(kMarginCount);
  for (std::size_t k = 0; k < kMarginCount; ++k) kinds.push_back(static_cast<MarginKind>(k));
  return kinds;
}

std::string title(MarginKind kind) {
  return fmt::format("{} [{}]", name(kind), field(kind).unit);
}

/// Returns, for example, "2 (4 ms)"; ">= 100" if nothing failed; "none" if the nominal value fails.
std::string shown(const std::optional<Margin>& margin) {
  if (!margin) return "-";
  if (!margin->stands) return "none";
  std::string text = fmt::format("{:.4g}", *margin->stands);
  if (margin->kind == MarginKind::kTorqueDelay) {
    constexpr double kMilliseconds = 1e3;
    text += fmt::format(" ({:.4g} ms)", *margin->stands * margin->control_period * kMilliseconds);
  }
  if (margin->fails) return text;
  return (field(margin->kind).search.stride > 1.0 ? ">= " : "<= ") + text;
}

/// Returns one line for each margin with a failure. If the loop fails without any change, returns only one
/// line, which says so.
std::string what_ends(const std::vector<Scenario>& scenarios, const ComparedMargins& set) {
  std::string text;
  for (const MarginKind kind : all_kinds()) {
    const auto smallest = least(scenarios, set.margins, kind);
    if (!smallest || !smallest->fails) continue;
    if (!smallest->stands) {
      return fmt::format(
          "{}: the closed loop fails in {} without any change of delay, gains, rate or noise: {}\n", set.name,
          smallest->scenario, smallest->reason);
    }
    text += fmt::format("{}: the closed loop fails at {} {:.4g} in {}: {}\n", set.name, name(kind),
                        *smallest->fails, smallest->scenario, smallest->reason);
  }
  return text;
}

std::string row(const Margin& margin, const std::string& scenario, const std::string& reason) {
  return fmt::format("{},{},{},{},{},{},{}\n", name(margin.kind), field(margin.kind).unit, cell(scenario),
                     cell(margin.nominal), cell(margin.stands.value_or(NAN)),
                     cell(margin.fails.value_or(NAN)), cell(reason));
}

}  // namespace

std::string margins_csv(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins) {
  std::string text = "margin,unit,scenario,nominal,stands,fails,reason\n";
  for (const MarginKind kind : all_kinds()) {
    for (const Margin& margin : margins) {
      if (margin.kind == kind) text += row(margin, margin.scenario, margin.reason);
    }
    const auto smallest = least(scenarios, margins, kind);
    if (!smallest) continue;
    text += row(*smallest, kAllScenarios,
                smallest->fails ? smallest->scenario + ": " + smallest->reason : std::string());
  }
  return text;
}

std::string margins_by_scenario(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins) {
  std::string text = fmt::format("{:<{}}", "", kScenarioWidth);
  for (const MarginKind kind : all_kinds()) text += fmt::format("{:>{}}", title(kind), kMarginWidth);
  text += '\n';
  for (const Scenario& scenario : scenarios) {
    text += fmt::format("{:<{}}", scenario.name, kScenarioWidth);
    for (const MarginKind kind : all_kinds()) {
      const auto found = std::find_if(margins.begin(), margins.end(), [&](const Margin& margin) {
        return margin.kind == kind && margin.scenario == scenario.name;
      });
      text += fmt::format("{:>{}}", shown(found != margins.end() ? std::optional(*found) : std::nullopt),
                          kMarginWidth);
    }
    text += '\n';
  }
  return text;
}

std::string margins_table(const std::vector<Scenario>& scenarios, const std::vector<ComparedMargins>& sets) {
  std::size_t width = kValueWidth;
  for (const ComparedMargins& set : sets) width = std::max(width, set.name.size() + 2);
  std::string text = fmt::format("{:<{}}", "margin", kScenarioWidth);
  for (const ComparedMargins& set : sets) text += fmt::format("{:>{}}", set.name, width);
  text += '\n';
  for (const MarginKind kind : all_kinds()) {
    text += fmt::format("{:<{}}", title(kind), kScenarioWidth);
    for (const ComparedMargins& set : sets) {
      text += fmt::format("{:>{}}", shown(least(scenarios, set.margins, kind)), width);
    }
    text += '\n';
  }
  text += '\n';
  for (const ComparedMargins& set : sets) text += what_ends(scenarios, set);
  return text;
}

}  // namespace armtune::internal
