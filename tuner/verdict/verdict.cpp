#include "tuner/verdict/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace armtune::internal {
namespace {

/// Largest number of failures that are listed. The text gives only the number of further failures.
constexpr std::size_t kMostListed = 6;

std::vector<const Check*> failures(const SimulationVerdict& verdict) {
  std::vector<const Check*> failed;
  for (const Check& check : verdict.checks) {
    if (!check.passed) failed.push_back(&check);
  }
  return failed;
}

/// Returns the kinds of checks that were made, each once.
std::vector<std::string> kinds_of(const SimulationVerdict& verdict) {
  std::vector<std::string> kinds;
  for (const Check& check : verdict.checks) {
    const std::string kind = name(check.kind);
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace

std::string headline(const SimulationVerdict& verdict) {
  if (verdict.checks.empty()) return "Simulation checks: none were made";
  const auto failed = failures(verdict);
  if (failed.empty()) {
    return fmt::format("Simulation checks: passed ({})", fmt::join(kinds_of(verdict), ", "));
  }
  return "Simulation checks: failed: " + to_text(*failed.front());
}

void add_once(std::string text, std::vector<std::string>& list) {
  if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(std::move(text));
}

const std::vector<std::string>& never_checked() {
  static const std::vector<std::string> all = {"cables and hoses", "flexible joints and links"};
  return all;
}

}  // namespace armtune::internal

namespace armtune {

const char* name(CheckKind kind) {
  constexpr const char* kNames[] = {"completion",
                                    "velocity limit",
                                    "position limit",
                                    "effort limit",
                                    "acceleration limit",
                                    "oscillation",
                                    "clear of obstacles",
                                    "clear of itself",
                                    "clear of the cell",
                                    "clear of the floor",
                                    "constraints",
                                    "delay margin",
                                    "gain margin",
                                    "control rate margin",
                                    "noise margin",
                                    "rotor estimate",
                                    "yield",
                                    "endurance",
                                    "error growth",
                                    "better than the start",
                                    ""};
  static_assert(std::size(kNames) == static_cast<std::size_t>(CheckKind::kBetterThanStart) + 2);
  return kNames[static_cast<std::size_t>(kind)];
}

bool Verdict::passed() const {
  return !checks.empty() &&
         std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed; });
}

std::string to_text(const Check& check) {
  std::string text = name(check.kind);
  if (!check.joint.empty()) text += ", " + check.joint;
  if (!std::isnan(check.time)) text += fmt::format(", {:.3f} s", check.time);
  if (!check.scenario.empty()) text += ", in " + check.scenario;
  if (!check.arm.empty()) text += ", " + check.arm;
  if (!check.detail.empty()) text += ": " + check.detail;
  if (!std::isnan(check.value)) {
    text += fmt::format("{}{:.4g}{}", check.detail.empty() ? ": " : ", ", check.value,
                        check.unit.empty() || check.unit == "1" ? "" : " " + check.unit);
    if (!std::isnan(check.threshold)) text += fmt::format(", threshold {:.4g}", check.threshold);
  }
  return text;
}

std::string to_text(const Verdict& verdict) {
  std::string text = internal::headline(verdict) + "\n";
  const auto failed = internal::failures(verdict);
  for (std::size_t i = 1; i < std::min(failed.size(), internal::kMostListed); ++i) {
    text += "  also failed: " + to_text(*failed[i]) + "\n";
  }
  if (failed.size() > internal::kMostListed)
    text += fmt::format("  and {} more failed checks\n", failed.size() - internal::kMostListed);
  const auto line = [&text](const char* what, const std::vector<std::string>& items) {
    if (!items.empty()) text += fmt::format("{}: {}\n", what, fmt::join(items, "; "));
  };
  line("Not checked", verdict.not_checked);
  line("Assumes", verdict.assumes);
  for (const std::string& note : verdict.notes) text += "Note: " + note + "\n";
  return text;
}

}  // namespace armtune
