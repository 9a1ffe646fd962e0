// verdict.yaml: writer and reader.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/common/message_text.hpp"
#include "sim/yaml/map_reader.hpp"
#include "sim/yaml/quoted.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune {
namespace {

constexpr int kKinds = static_cast<int>(CheckKind::kBetterThanStart) + 1;

std::string list(const std::vector<std::string>& texts) {
  std::vector<std::string> quoted;
  quoted.reserve(texts.size());
  for (const std::string& text : texts) quoted.push_back(yaml::quoted(one_line(text)));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

void add_number(const char* key, double value, std::string& line) {
  if (std::isfinite(value)) line += fmt::format(", {}: {}", key, value);
}

CheckKind read_kind(const yaml::Node& node) {
  const std::string text = node.as_string();
  for (int kind = 0; kind < kKinds; ++kind) {
    if (text == name(static_cast<CheckKind>(kind))) return static_cast<CheckKind>(kind);
  }
  node.fail(fmt::format("'{}' is not a check that this version knows", text));
}

std::vector<std::string> read_list(const yaml::Node& node) {
  return node.items().empty() ? std::vector<std::string>() : node.as_strings();
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
  const yaml::Node root = yaml::parse_file(path);
  yaml::MapReader map(root);
  SimulationVerdict verdict;
  map.ignore("passed");
  for (const yaml::Node& item : map.required("checks").items()) {
    yaml::MapReader one(item);
    Check& check = verdict.checks.emplace_back();
    check.kind = read_kind(one.required("check"));
    check.passed = one.required("passed").as_boolean();
    check.scenario = one.string("scenario", "");
    check.arm = one.string("arm", "");
    check.joint = one.string("joint", "");
    check.time = one.number("time", NAN);
    check.value = one.number("value", NAN);
    check.threshold = one.number("threshold", NAN);
    check.unit = one.string("unit", "");
    check.detail = one.string("detail", "");
    one.finish();
  }
  verdict.not_checked = read_list(map.required("not_checked"));
  verdict.assumes = read_list(map.required("assumes"));
  verdict.notes = read_list(map.required("notes"));
  map.finish();
  return verdict;
}

}  // namespace armtune
