// Writes and reads verdict.yaml.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/common/message_text.hpp"
#include "sim/yaml/quoted.hpp"
#include "tuner/record/json_reader.hpp"
#include "tuner/verdict/verdict.hpp"

// These functions are in the namespace of the types, so that argument-dependent lookup finds them.
namespace armtune {

static void declare(auto& f, internal::record::Of<Check> auto& check) {
  using enum internal::record::Presence;
  f("check", check.kind)("passed", check.passed)("scenario", check.scenario, "", kIfAny);
  f("arm", check.arm, "", kIfAny)("joint", check.joint, "", kIfAny)("time", check.time, "", kIfAny);
  f("value", check.value, "", kIfAny)("threshold", check.threshold, "", kIfAny);
  f("unit", check.unit, "", kIfAny)("detail", check.detail, "", kIfAny);
}

static void declare(auto& f, internal::record::Of<Verdict> auto& verdict) {
  f("passed", verdict.passed())("checks", verdict.checks)("not_checked", verdict.not_checked);
  f("assumes", verdict.assumes)("notes", verdict.notes);
}

}  // namespace armtune

namespace armtune::internal {
namespace {

std::string list(const std::vector<std::string>& texts) {
  std::vector<std::string> quoted;
  quoted.reserve(texts.size());
  for (const std::string& text : texts) quoted.push_back(yaml::quoted(one_line(text)));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

void add_number(const char* key, double value, std::string& line) {
  if (std::isfinite(value)) line += fmt::format(", {}: {}", key, value);
}

}  // namespace

std::string verdict_yaml(const SimulationVerdict& verdict) {
  std::string text = "# The simulation checks of this run: which were made, and what they found.\n";
  text += fmt::format("passed: {}\nchecks:{}\n", verdict.passed(), verdict.checks.empty() ? " []" : "");
  for (const Check& check : verdict.checks) {
    std::string line = fmt::format("check: {}, passed: {}", yaml::quoted(name(check.kind)), check.passed);
    const auto add = [&line](const char* key, const std::string& value) {
      if (!value.empty()) line += fmt::format(", {}: {}", key, yaml::quoted(one_line(value)));
    };
    add("scenario", check.scenario);
    add("arm", check.arm);
    add("joint", check.joint);
    add_number("time", check.time, line);
    add_number("value", check.value, line);
    add_number("threshold", check.threshold, line);
    add("unit", check.unit);
    add("detail", check.detail);
    text += "  - {" + line + "}\n";
  }
  text += fmt::format("not_checked: {}\nassumes: {}\nnotes: {}\n", list(verdict.not_checked),
                      list(verdict.assumes), list(verdict.notes));
  return text;
}

SimulationVerdict read_verdict(const std::string& path) {
  SimulationVerdict verdict;
  record::read(yaml::parse_file(path), verdict);
  return verdict;
}

}  // namespace armtune::internal
