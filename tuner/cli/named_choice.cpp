#include "tuner/cli/named_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "sim/plant/engine.hpp"
#include "sim/plant/stepper.hpp"

namespace armtune::cli {
namespace {

/// Shows the names in --help, the manual page and shell completion. What is none of them is refused by the
/// function that takes the name, which says more than a list.
CLI::Validator names_shown(const std::vector<std::string>& names) {
  return {[](std::string&) { return std::string(); }, fmt::format("{{{}}}", fmt::join(names, ","))};
}

}  // namespace

CLI::Option* add_stepper_option(CLI::App& command, std::string& stepper) {
  std::vector<std::string> names;
  for (const Stepper one : kSteppers) names.emplace_back(name(one));
  return command.add_option("--stepper", stepper, "how a control period is stepped")
      ->check(names_shown(names))
      ->capture_default_str();
}

CLI::Option* add_engine_option(CLI::App& command, std::string& engine) {
  std::vector<std::string> names;
  for (const Engine one : kEngines) names.emplace_back(name(one));
  return command.add_option("--engine", engine, "native: armtune's own dynamics, several times faster")
      ->check(names_shown(names))
      ->capture_default_str();
}

CLI::Option* add_controller_option(CLI::App& command, std::string& controller) {
  std::vector<std::string> names;
  for (const ControllerKind* kind : controller_kinds()) names.push_back(kind->name);
  return command
      .add_option("--controller", controller,
                  "tune another controller on the study's task, all of its gains that are tuned by default; "
                  "armtune controllers says more of each")
      ->check(names_shown(names));
}

}  // namespace armtune::cli
