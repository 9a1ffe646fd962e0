#include "tuner/report/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "tuner/rollouts/comparison.hpp"

namespace armtune::internal::report {
namespace {

/// A smaller relative change is not mentioned.
constexpr double kNoticeable = 0.01;

/// Returns, for example, "falls by 62 %".
std::string how_much(double ratio) {
  const double percent = 100.0 * (ratio - 1.0);
  return percent > 1000.0
             ? fmt::format("rises {:.3g}-fold", ratio)
             : fmt::format("{} by {:.0f} %", percent < 0.0 ? "falls" : "rises", std::abs(percent));
}

}  // namespace

bool noticeable(double ratio) {
  return std::abs(ratio - 1.0) >= kNoticeable;
}

bool improvement(const Change& change) {
  return change.worsening() < 1.0 - kNoticeable;
}

std::string words(const Change& change, std::size_t all_scenarios) {
  const std::size_t of = change.scenarios.size();
  const std::string where = of == all_scenarios ? std::string()
                            : of == 1           ? " in " + change.scenarios.front()
                                                : fmt::format(" in {} of {} scenarios", of, all_scenarios);
  return fmt::format("the {} {}{}", field(change.metric).words, how_much(change.ratio), where);
}

std::string exact_words(const Change& change, std::size_t all_scenarios) {
  const std::size_t of = change.scenarios.size();
  const std::string where = of == 1 ? "in " + change.scenarios.front()
                            : of == all_scenarios
                                ? fmt::format("mean of all {} scenarios", of)
                                : fmt::format("mean of {}", fmt::join(change.scenarios, " and "));
  return fmt::format("the {} ({}) {}, {}", field(change.metric).words, name(change.metric),
                     how_much(change.ratio), where);
}

std::string improvements(const std::vector<Change>& all, std::size_t scenarios) {
  std::vector<std::string> told;
  for (const Change& change : all) {
    if (told.size() < 2 && improvement(change)) told.push_back(words(change, scenarios));
  }
  return fmt::format("{}", fmt::join(told, " and "));
}

std::string price(const std::vector<Table>& tables, std::size_t set) {
  const auto step = worst_step(tables, headline_metrics(), set);
  if (!step) return {};
  const double ratio = step->after / step->before;
  if (!noticeable(ratio)) return {};
  const std::string unit = field(step->metric).unit;
  return fmt::format("the {} {}, from {:.4g} to {:.4g}{}, in {}", field(step->metric).words, how_much(ratio),
                     step->before, step->after, unit == "1" ? "" : " " + unit, step->scenario);
}

std::string capital(std::string text) {
  const std::string first = text.substr(0, text.find(' '));
  const bool is_name = first.find_first_of("_/:") != std::string::npos;
  if (!is_name && !text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

std::string joined(const std::vector<std::string>& parts) {
  std::vector<std::string> told;
  for (const std::string& part : parts) {
    if (!part.empty()) told.push_back(part);
  }
  return told.empty() ? std::string() : capital(fmt::format("{}.", fmt::join(told, "; ")));
}

std::string first_of(const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  return lines.size() == 1 ? lines.front() : fmt::format("{} (and {} more)", lines.front(), lines.size() - 1);
}

void add(std::vector<std::string>& details, const std::vector<std::string>& lines, std::size_t most) {
  for (std::size_t i = 0; i < lines.size() && i < most; ++i) details.push_back(lines[i]);
  if (lines.size() > most) details.push_back(fmt::format("and {} more", lines.size() - most));
}

}  // namespace armtune::internal::report
