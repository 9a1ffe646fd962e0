// Writes study files, for study_yaml of study.hpp.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sim/scenario/arm_distribution.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/yaml/quoted.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace {

std::string subset_text(const std::vector<std::size_t>& subset, const std::vector<Scenario>& scenarios) {
  std::vector<std::string> names;
  names.reserve(subset.size());
  for (const std::size_t s : subset) names.push_back(yaml::word(scenarios[s].name));
  return fmt::format("[{}]", fmt::join(names, ", "));
}

const char* constraint_handling_name(ConstraintHandling handling) {
  switch (handling) {
    case ConstraintHandling::kAuto:
      return "auto";
    case ConstraintHandling::kLagrangian:
      return "lagrangian";
    case ConstraintHandling::kPenalty:
      return "penalty";
  }
  return "";
}

/// Returns the value of `hopeless: auto` as a YAML comment. A number in the file would also apply to the
/// start gains, but the default does not.
std::string auto_text(const Constraint& c) {
  if (c.hopeless.kind != Hopeless::Kind::kAuto) return {};
  if (!default_hopeless(c.metric, c.upper, 0.0)) return "  # hopeless: never";
  if (!c.limit)
    return fmt::format("  # hopeless: {}", c.upper ? "twice the start value" : "0.1 below the start value");
  return fmt::format(
      "  # an evaluation is abandoned from {} on, unless the start gains are already past this value",
      *default_hopeless(c.metric, c.upper, *c.limit));
}

std::string parameters_yaml(const ParameterSpace& space) {
  std::string text = "parameters:\n";
  for (const Parameter& p : space.free) {
    text += fmt::format("  - {{name: {}, start: {}, lower: {}, upper: {}, scale: {}}}\n",
                        yaml::word(p.entry.name), p.start, p.lower, p.upper,
                        p.scale == Scale::kLog ? "log" : "linear");
  }
  for (const Link& link : space.links) {
    text += fmt::format("  - {{name: {}, link: {}, factor: {}}}\n", yaml::word(link.entry.name),
                        yaml::word(space.free[link.parameter].entry.name), link.factor);
  }
  return text;
}

std::string objective_yaml(const Study& study) {
  std::string text = "objective:\n";
  for (const ObjectiveTerm& term : study.terms) {
    text += fmt::format("  - {{metric: {}, weight: {}, floor: {}, scenarios: {}}}\n", name(term.metric),
                        term.weight, term.floor, subset_text(term.scenarios, study.scenarios));
  }
  return text;
}

std::string constraints_yaml(const Study& study) {
  const auto of_margin = [](const Constraint& c) { return c.margin.has_value(); };
  std::string text;
  if (!std::all_of(study.constraints.begin(), study.constraints.end(), of_margin)) text += "constraints:\n";
  for (const Constraint& c : study.constraints) {
    if (of_margin(c)) continue;
    text += fmt::format("  - {{metric: {}, {}: {}, hopeless: {}, scenarios: {}}}{}\n", name(c.metric),
                        c.upper ? "at_most" : "at_least", c.limit ? fmt::format("{}", *c.limit) : "start",
                        hopeless_text(c.hopeless), subset_text(c.scenarios, study.scenarios), auto_text(c));
  }
  return text;
}

std::string sweep_yaml(const Study& study) {
  std::string text;
  if (!study.sweep.empty()) text += "sweep:\n";
  for (const SweepAxis& axis : study.sweep) {
    std::vector<std::string> names;
    for (const std::size_t p : axis.parameters) names.push_back(yaml::word(study.space.free[p].entry.name));
    text += fmt::format("  - {{parameters: [{}], factors: [{}]}}\n", fmt::join(names, ", "),
                        fmt::join(axis.factors, ", "));
  }
  return text;
}

std::string margins_yaml(const Study& study) {
  if (study.margins.empty()) return {};
  std::vector<std::string> demands;
  for (const MarginThreshold& margin : margin_thresholds()) {
    for (const MarginDemand& demand : study.margins) {
      if (demand.kind == margin.kind) demands.push_back(fmt::format("{}: {}", margin.key, demand.value));
    }
  }
  return fmt::format("margins: {{{}}}\n", fmt::join(demands, ", "));
}

std::string robust_yaml(const Study& study) {
  if (!study.robust) return {};
  std::string text =
      fmt::format("robust:\n  samples: {}\n  seed: {}\n  measure: {}\n  level: {}\n", study.robust->samples,
                  study.robust->seed, risk_measure_names()[static_cast<std::size_t>(study.robust->measure)],
                  study.robust->level);
  if (const auto& distribution = study.robust->perturbation.distribution)
    text += fmt::format("  distribution: {}\n", yaml::quoted(portable_reference(distribution->file)));
  text += "  uncertainty:\n";
  for (const PerturbationField& f : perturbation_fields()) {
    text += fmt::format("    {}: {}\n", f.name, study.robust->perturbation.*f.width);
  }
  text += fmt::format("    phases: {}\n", study.robust->perturbation.phases);
  return text;
}

std::string thresholds_yaml(const Study& study) {
  std::string text = "verdict:\n";
  for (const ThresholdField& field : threshold_fields()) {
    text += fmt::format("  {}: {}   # {}\n", field.name, study.thresholds.*field.value, field.meaning);
  }
  return text;
}

std::string search_yaml(const Study& study) {
  return fmt::format(
      "search: {{algorithm: {}, constraints: {}, penalty: {}, max_evaluations: {}, max_minutes: {}, "
      "initial_step: {}, x_tolerance: {}, "
      "objective_tolerance: {}, seed: {}, stepper: {}, differences: {}, difference_step: {}, starts: "
      "{}{}{}{}}}\n",
      study.solver.algorithm, constraint_handling_name(study.solver.constraints), study.solver.penalty,
      study.max_evaluations, study.max_minutes, study.solver.initial_step, study.solver.x_tolerance,
      study.solver.objective_tolerance, study.solver.seed, name(study.stepper),
      study.solver.differences == Differences::kForward ? "forward" : "central", study.solver.difference_step,
      study.starts,
      study.engine == Engine::kSimbody
          ? ""
          : fmt::format(", engine: {}, verify_share: {}", name(study.engine), study.verify_share),
      global_of(study).empty()
          ? ""
          : fmt::format(", global: {}, global_share: {}", global_of(study), study.global_share),
      study.final_phase ? fmt::format(", final_phase: minimax, final_share: {}", study.final_share) : "");
}

std::string warm_start_yaml(const Study& study, const std::string& warm_file) {
  if (!study.warm || warm_file.empty()) return {};
  const WarmStart& warm = *study.warm;
  std::vector<std::string> parameters;
  for (const std::string& name : warm.parameters) parameters.push_back(yaml::word(name));
  return fmt::format(
      "warm_start: {{from: {}, box: {}{}{}}}\n", yaml::quoted(warm_file), warm.box,
      warm.step ? fmt::format(", step: {}", *warm.step) : "",
      parameters.empty() ? "" : fmt::format(", parameters: [{}]", fmt::join(parameters, ", ")));
}

}  // namespace

std::string study_yaml(const Study& study, const std::string& gains_file, const std::string& warm_file) {
  std::string text =
      fmt::format("description: {}\ngains: {}\nscenarios:\n", yaml::quoted(study.description), gains_file);
  for (const Scenario& scenario : study.scenarios)
    text += fmt::format("  - {}\n", yaml::quoted(portable_reference(scenario.source)));
  text += parameters_yaml(study.space);
  text += objective_yaml(study);
  text += constraints_yaml(study);
  text += sweep_yaml(study);
  text += margins_yaml(study);
  text += robust_yaml(study);
  text += thresholds_yaml(study);
  text += search_yaml(study);
  text += warm_start_yaml(study, warm_file);
  return text;
}

}  // namespace armtune::internal
