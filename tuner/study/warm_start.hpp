#pragma once
// A warm start: a search begins at the gains that an earlier run found. The study's own start gains remain
// the reference of the objective.

#include <optional>
#include <string>
#include <vector>

#include "tuner/study/parameter.hpp"

namespace armtune::internal {

struct WarmStart {
  std::string source;                   ///< the gains file
  Gains gains;                          ///< as read from it
  std::vector<std::string> parameters;  ///< gains, or fields, taken from there; empty: all that are tuned
  double box = 1.0;                     ///< width of the searched box in each parameter's range, (0, 1]
  std::optional<double> step;           ///< initial step in the unit box; none: the study's times `box`
};

/// The point where the search begins, and the box that it does not leave, in search coordinates.
struct WarmPoint {
  std::vector<double> x;
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<std::string> clamped;  ///< one line for each gain that lies outside the study's bounds
};

/// Sets source and gains from a run folder, or from a gains file that load_gains reads. Throws InputError,
/// also if they are for another controller than the space's. relative_to: another folder to look for them
/// in.
void load_warm_gains(WarmStart& warm, const std::string& folder_or_file, const ParameterSpace& space,
                     const std::vector<std::string>& joints, const std::string& relative_to = {});

/// Returns the point of a warm start. Throws InputError if a name is not that of a tuned gain or field, or if
/// the gains lack one that is taken from them.
WarmPoint warm_point(const ParameterSpace& space, const WarmStart& warm);

}  // namespace armtune::internal
