#include "tuner/study/hold_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"
#include "sim/scenario/arm_distribution.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

/// Returns the threshold that the field's key gives, or `fallback` without it.
double read_threshold(yaml::MapReader& map, const ThresholdField& field, double fallback) {
  const double value = map.number_in(field.name, fallback, field.least, field.most);
  if (field.whole && value != std::floor(value))
    map.required(field.name).fail(fmt::format("{} must be a whole number", value), "a whole number");
  return value;
}

void read_widths(const yaml::Node& node, Perturbation& perturbation) {
  yaml::MapReader map(node);
  for (const PerturbationField& f : perturbation_fields()) {
    perturbation.*f.width = map.number(f.name, perturbation.*f.width);
    const yaml::Node* width = map.optional(f.name);
    try {
      validate(perturbation, "uncertainty");
    } catch (const InputError& e) {
      (width == nullptr ? node : *width).fail(e.what(), e.limit());
    }
  }
  perturbation.phases = map.boolean("phases", perturbation.phases);
  map.finish();
}

/// Adds one constraint for each margin, over its corners. The corners come after the study's scenarios.
void add_margin_constraints(Study& study) {
  std::size_t corner = study.scenarios.size();
  for (const MarginDemand& demand : study.margins) {
    Constraint& constraint = study.constraints.emplace_back();
    constraint.margin = demand;
    for (std::size_t s = 0; s < study.scenarios.size(); ++s) constraint.scenarios.push_back(corner++);
  }
}

}  // namespace

SampleSet read_samples(const yaml::Node& node, const std::vector<Scenario>& scenarios) {
  yaml::MapReader map(node);
  SampleSet set;
  set.perturbation = default_perturbation(scenarios);
  constexpr long kMostSamples = 1000;
  const long samples = map.integer("samples", static_cast<long>(set.samples));
  if (samples < 1 || samples > kMostSamples)
    map.required("samples").fail(
        fmt::format("{} samples; the number must lie in 1 .. {}", samples, kMostSamples),
        fmt::format("1 .. {}", kMostSamples));
  set.samples = static_cast<std::size_t>(samples);
  const long seed = map.integer("seed", static_cast<long>(set.seed));
  if (seed < 0) map.required("seed").fail("must not be negative", "not negative");
  set.seed = static_cast<std::uint64_t>(seed);
  const auto names = risk_measure_names();
  const std::string measure = map.string("measure", names[static_cast<std::size_t>(set.measure)]);
  const auto found = std::find(names.begin(), names.end(), measure);
  if (found == names.end()) {
    map.required("measure").fail_choice({names.begin(), names.end()});
  }
  set.measure = static_cast<RiskMeasure>(found - names.begin());
  set.level = map.number_in("level", set.level, 0.0, 1.0);
  if (set.level <= 0.0 || set.level >= 1.0)
    map.required("level").fail("must lie between 0 and 1, both excluded", "between 0 and 1, both excluded");
  if (const yaml::Node* file = map.optional("distribution"))
    draw_from(load_arm_distribution(file_beside(file->as_string(), file->file()), scenarios),
              set.perturbation);
  if (const yaml::Node* widths = map.optional("uncertainty")) read_widths(*widths, set.perturbation);
  map.finish();
  return set;
}

void read_margins(const yaml::Node& node, Study& study) {
  yaml::MapReader map(node);
  for (const MarginThreshold& margin : margin_thresholds()) {
    const auto field =
        std::find_if(threshold_fields().begin(), threshold_fields().end(),
                     [&margin](const ThresholdField& f) { return std::string(f.name) == margin.key; });
    if (!map.has(margin.key)) continue;
    if (margin.kind == MarginKind::kVelocityNoise && !has_noise(study.scenarios))
      map.required(margin.key)
          .fail("no scenario has velocity noise, so there is no noise margin; leave this key out");
    study.margins.push_back({margin.kind, read_threshold(map, *field, 0.0)});
  }
  map.finish();
  if (study.margins.empty())
    node.fail("no margin is given; leave the key out, or give one of: delay_periods, gain, rate, noise",
              "one of: delay_periods, gain, rate, noise");
  add_margin_constraints(study);
}

VerdictThresholds read_thresholds(const yaml::Node& node) {
  yaml::MapReader map(node);
  VerdictThresholds thresholds;
  for (const ThresholdField& field : threshold_fields()) {
    thresholds.*field.value = read_threshold(map, field, thresholds.*field.value);
  }
  map.finish();
  return thresholds;
}

}  // namespace armtune::internal
