#pragma once
// A warm start: the search starts at gains that an earlier run found. The objective is still relative to the
// study's own start gains.

#include <optional>
#include <string>
#include <vector>

#include "tuner/study/parameter.hpp"

namespace armtune::internal {

struct WarmStart {
  std::string source;                   ///< path of the gains file
  Gains gains;                          ///< gains in this file
  std::vector<std::string> parameters;  ///< names of the gains that are used; empty: all tuned gains
  double box = 1.0;                     ///< searched share of each parameter's range, (0, 1]; 1: all of it
  std::optional<double> step;           ///< initial step; none: the study's initial step times `box`
};

/// The point where the search starts, and the bounds of the search, in search coordinates.
struct WarmPoint {
  std::vector<double> x;
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<std::string> clamped;  ///< one line for each gain that lies outside the study's bounds
};

/// Sets source and gains from a run folder, or from a gains file that load_gains can read. relative_to: a
/// further folder to which a relative path in `folder_or_file` may refer. Throws InputError if the gains
/// cannot be read, or if they are for another controller than the start gains of `space`.
void load_warm_gains(WarmStart& warm, const std::string& folder_or_file, const ParameterSpace& space,
                     const std::vector<std::string>& joints, const std::string& relative_to = {});

/// Returns the point of a warm start. The bounds are centred on it; with `box` 1 they are those of the study.
/// Throws InputError if a name in `parameters` is not the name of a tuned gain, or if a gain that is used is
/// missing in the warm start.
WarmPoint warm_point(const ParameterSpace& space, const WarmStart& warm);

}  // namespace armtune::internal
