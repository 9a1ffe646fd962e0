#include "tuner/cli/uncertainty_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "sim/scenario/arm_distribution.hpp"

namespace armtune::internal::cli {

void add_uncertainty_options(CLI::App& command, UncertaintyArguments& args) {
  command
      .add_option(
          "--distribution", args.distribution,
          "file with a joint distribution, such as the uncertainty.yaml of a calibration. Friction, rotor "
          "inertia, gains of drives, delay, payload, tilt of the base and encoder offsets of the arms are "
          "drawn from it. --mass, --center, --inertia and --payload are then 0 by default, and --rotor, --friction "
          "and --delay must not be given")
      ->default_str("none");
  Perturbation& p = args.given;
  for (const PerturbationField& f : perturbation_fields()) {
    std::string option = fmt::format("--{}", f.name);
    std::replace(option.begin(), option.end(), '_', '-');
    const bool has_unit = std::string_view(f.unit) != "1";
    const std::string meaning = has_unit ? fmt::format("{} [{}]", f.meaning, f.unit) : f.meaning;
    CLI::Option* width = command.add_option(option, p.*f.width, meaning)
                             ->capture_default_str()
                             ->group("Uncertainty (uniform)");
    args.widths.emplace_back(width, f.width);
    if (f.width == &Perturbation::payload)
      width->default_str("three times the heaviest payload of the scenarios");
  }
  command
      .add_flag("!--fixed-phases", p.phases,
                "let targets and obstacles begin at the positions that the scenario gives")
      ->default_str("at random positions on their paths")
      ->group("Uncertainty (uniform)");
}

Perturbation perturbation_of(const UncertaintyArguments& args, const std::vector<Scenario>& scenarios) {
  Perturbation perturbation = default_perturbation(scenarios);
  perturbation.phases = args.given.phases;
  if (!args.distribution.empty())
    draw_from(load_arm_distribution(args.distribution, scenarios), perturbation);
  for (const auto& [option, width] : args.widths) {
    if (option->count() > 0) perturbation.*width = args.given.*width;
  }
  return perturbation;
}

}  // namespace armtune::internal::cli
