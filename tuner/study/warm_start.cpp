#include "tuner/study/warm_start.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal {
namespace {

/// Returns, for each parameter, true if the warm start gives its value.
std::vector<bool> given(const ParameterSpace& space, const std::vector<std::string>& names) {
  std::vector<bool> chosen(space.free.size(), names.empty());
  for (const std::string& name : names) {
    bool found = false;
    std::vector<std::string> tuned;
    for (std::size_t i = 0; i < space.free.size(); ++i) {
      const GainEntry& entry = space.free[i].entry;
      tuned.push_back(entry.name);
      if (!is_named(entry, name)) continue;
      chosen[i] = true;
      found = true;
    }
    if (!found) {
      throw InputError(fmt::format("'{}' is not tuned by this study{}; name only tuned gains", name,
                                   suggestion(name, tuned)))
          .with_value(name, fmt::format("one of: {}", fmt::join(tuned, ", ")));
    }
  }
  return chosen;
}

}  // namespace

void load_warm_gains(WarmStart& warm, const std::string& folder_or_file, const ParameterSpace& space,
                     const std::vector<std::string>& joints, const std::string& relative_to) {
  namespace fs = std::filesystem;
  std::string file = folder_or_file;
  for (const fs::path& folder : {fs::path(folder_or_file), fs::path(relative_to) / folder_or_file}) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) continue;
    file = run_file(folder.string(), "gains.yaml");
    break;
  }
  warm.source = find_data_file("gains", file, relative_to);
  warm.gains = load_gains(warm.source, joints);
  if (warm.gains.controller != space.start.controller) {
    throw InputError(
        InputPlace{warm.source, 0, "controller"},
        fmt::format(
            "holds gains of the controller {}, but the study tunes the controller {}; give a warm start for "
            "the study's controller",
            warm.gains.controller, space.start.controller))
        .with_value(warm.gains.controller, space.start.controller);
  }
}

WarmPoint warm_point(const ParameterSpace& space, const WarmStart& warm) {
  const std::vector<bool> chosen = given(space, warm.parameters);
  WarmPoint point;
  point.x = space.start_point();
  Gains there = space.start;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (!chosen[i]) continue;
    const GainEntry& entry = space.free[i].entry;
    if (!has(warm.gains, entry)) {
      throw InputError(
          InputPlace{warm.source, 0, entry.name},
          fmt::format("no {} is given, but the study tunes this gain; add the gain to this file, or restrict "
                      "warm_start/parameters in the study to gains that this file has",
                      entry.name));
    }
    value(there, entry) = value(warm.gains, entry);
  }
  const std::vector<double> coordinates = space.point_of(there);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) {
      const Parameter& p = space.free[i];
      const double v = value(warm.gains, p.entry);
      point.x[i] = coordinates[i];
      if (v < p.lower || v > p.upper) {
        point.clamped.push_back(
            fmt::format("{}: {} is {}, outside its bounds {} .. {}; the search starts at the nearer bound",
                        warm.source, p.entry.name, v, p.lower, p.upper));
      }
    }
    point.lower.push_back(std::max(0.0, point.x[i] - 0.5 * warm.box));
    point.upper.push_back(std::min(1.0, point.x[i] + 0.5 * warm.box));
  }
  if (warm.box >= 1.0) {  // the whole range, wherever the point lies in it
    point.lower.assign(chosen.size(), 0.0);
    point.upper.assign(chosen.size(), 1.0);
  }
  return point;
}

}  // namespace armtune::internal
