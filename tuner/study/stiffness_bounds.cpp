#include "tuner/study/stiffness_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "tuner/study/shared_gains.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kOption = "--max-stiffness";

/// True for a gain with a number for each axis of the task.
bool is_of_task(const GainEntry& entry) {
  const auto* own = std::get_if<OwnGain>(&entry.field->member);
  return own != nullptr && own->shape == GainShape::kTask;
}

/// True if the number acts in any scenario of the study. Those of the task act only on its axes.
bool acts(const GainEntry& entry, const std::vector<Scenario>& scenarios) {
  return !is_of_task(entry) || std::any_of(scenarios.begin(), scenarios.end(), [&](const Scenario& scenario) {
    return scenario.has_task() && (entry.component < 3 || tracks_orientation(scenario.mask));
  });
}

/// Returns the numbers of the start gains that are a stiffness and act in the study.
std::vector<GainEntry> stiffness_of(const Study& study) {
  std::vector<GainEntry> all = gain_entries(study.space.start, joint_names(*study.scenarios.front().robot));
  std::erase_if(all, [&study](const GainEntry& entry) {
    return entry.field->search != SearchRange::kBounded || !acts(entry, study.scenarios);
  });
  return all;
}

bool is_tuned_or_linked(const GainEntry& entry, const ParameterSpace& space) {
  const auto same = [&entry](const auto& other) { return other.entry.name == entry.name; };
  return std::any_of(space.free.begin(), space.free.end(), same) ||
         std::any_of(space.links.begin(), space.links.end(), same);
}

/// Returns the bound of a number of the gain. Returns 0 if the count of the bounds is wrong.
double bound_of(const GainEntry& entry, const std::vector<double>& most) {
  const bool task = is_of_task(entry);
  if (most.size() == entry.count) return most[entry.component];
  if (task && most.size() == 2) return most[entry.component < 3 ? 0 : 1];
  return !task && most.size() == 1 ? most.front() : 0.0;
}

/// Throws InputError because the number of bounds does not fit the gain.
[[noreturn]] void refuse_count(const GainEntry& entry, std::size_t count) {
  const std::string fewest =
      is_of_task(entry) ? "one for translations and one for rotations" : "one for all joints";
  throw InputError(InputPlace{.key = kOption},
                   fmt::format("{} numbers are given, but {} has {}; give {}, or one for each of them", count,
                               entry.field->name, entry.count, fewest))
      .with_value(fmt::to_string(count),
                  fmt::format("{} or {} numbers", is_of_task(entry) ? 2 : 1, entry.count));
}

}  // namespace

void bound_stiffness(const std::vector<double>& most, Study& study) {
  const std::vector<GainEntry> entries = stiffness_of(study);
  if (entries.empty())
    throw InputError(
        InputPlace{.key = kOption},
        fmt::format(
            "has no effect, because {} has no stiffness that acts in the scenarios; leave the option out",
            study.space.start.controller));
  for (const GainEntry& entry : entries) {
    if (is_tuned_or_linked(entry, study.space))
      throw InputError(InputPlace{where(study), 0, entry.name},
                       fmt::format("the study tunes {} itself; change its bounds there, or leave {} out",
                                   entry.name, kOption));
    const double upper = bound_of(entry, most);
    if (upper <= 0.0) refuse_count(entry, most.size());
    double& start = value(study.space.start, entry);
    if (start == 0.0) continue;
    start = std::min(start, upper);
    study.space.free.push_back({entry, start, entry.field->lower_factor * start, upper, Scale::kLog});
  }
  validate(study.space, where(study));
  refuse_split_numbers(study);
}

std::string note_on_stiffness(const Study& study) {
  for (const GainEntry& entry : stiffness_of(study)) {
    if (is_tuned_or_linked(entry, study.space) || value(study.space.start, entry) == 0.0) continue;
    return fmt::format(
        "{} is not tuned: how stiff the arm may become depends on contacts, which are not simulated. To tune "
        "it, give 'upper' in the study, or its largest values with --max-stiffness",
        entry.field->name);
  }
  return {};
}

}  // namespace armtune::internal
