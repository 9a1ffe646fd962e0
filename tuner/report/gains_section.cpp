// The section with the gains before and after, from each set's gains.yaml.

#include <algorithm>
#include <cmath>

#include "sim/scenario/gains_file.hpp"
#include "tuner/report/sections.hpp"
#include "tuner/study/parameter.hpp"

namespace armtune::internal::report {

std::vector<Gain> gains_of(const std::vector<StudyGain>& tuned, const std::vector<std::string>& joints,
                           const std::vector<std::optional<std::string>>& paths) {
  std::vector<std::optional<Gains>> sets;
  sets.reserve(paths.size());
  for (const auto& path : paths) {
    sets.push_back(path ? std::optional(load_gains(*path, joints)) : std::nullopt);
  }
  // The sets of a run have one controller.
  const auto first = std::find_if(sets.begin(), sets.end(), [](const auto& set) { return set.has_value(); });
  if (first == sets.end()) return {};
  const auto entries = gain_entries(**first, joints);
  std::vector<Gain> gains;
  for (const StudyGain& g : tuned) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&g](const GainEntry& e) { return e.name == g.name; });
    if (found == entries.end()) continue;
    Gain gain{g.name, found->field->unit, g.lower, g.upper, g.scale, {}};
    for (const auto& set : sets) gain.values.push_back(set && has(*set, *found) ? value(*set, *found) : NAN);
    gains.push_back(std::move(gain));
  }
  return gains;
}

}  // namespace armtune::internal::report
