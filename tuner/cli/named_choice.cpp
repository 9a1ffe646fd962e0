#include "tuner/cli/named_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/plant/engine.hpp"
#include "sim/plant/stepper.hpp"

namespace armtune::internal::cli {
namespace {

/// Returns a validator that only shows the names in --help, the manual page and shell completion. It accepts
/// every word, because the function that converts the name refuses an unknown one with a better message.
template <typename List, typename NameOf>
CLI::Validator names_shown(const List& list, NameOf name_of) {
  std::vector<std::string> names(list.size());
  std::transform(list.begin(), list.end(), names.begin(), name_of);
  return {[](std::string&) { return std::string(); }, fmt::format("{{{}}}", fmt::join(names, ","))};
}

}  // namespace

CLI::Option* add_stepper_option(CLI::App& command, std::string& stepper) {
  return command
      .add_option(
          "--stepper", stepper,
          "numerical integration method of the simulation; 'reference' controls its error and is slow")
      ->check(names_shown(kSteppers, [](Stepper one) { return name(one); }))
      ->capture_default_str();
}

CLI::Option* add_engine_option(CLI::App& command, std::string& engine) {
  return command
      .add_option("--engine", engine,
                  "dynamics engine: Simbody, or armtune's own (native), which is several times faster")
      ->check(names_shown(kEngines, [](Engine one) { return name(one); }))
      ->capture_default_str();
}

CLI::Option* add_controller_option(CLI::App& command, std::string& controller) {
  return command
      .add_option("--controller", controller,
                  "tune this controller instead of the study's controller; the search varies the gains that "
                  "'armtune controllers' marks with *")
      ->check(names_shown(controller_kinds(), [](const ControllerKind* kind) { return kind->name; }));
}

CLI::Option* add_joint_motion_controller_option(CLI::App& command, std::string& controller) {
  return command
      .add_option("--controller", controller,
                  "tune one of armtune's controllers that follow motions, without a parameter file; its "
                  "start gains are computed from the arm")
      ->check(names_shown(motion_controllers(), [](const std::string& name) { return name; }));
}

}  // namespace armtune::internal::cli
