#pragma once
// A search that begins where another one ended, while the study's own start stays what everything is relative
// to.

#include <optional>
#include <string>
#include <vector>

#include "tuner/study/parameter.hpp"

namespace armtune::internal {

struct WarmStart {
  std::string source;                   ///< the gains file
  Gains gains;                          ///< as read from it
  std::vector<std::string> parameters;  ///< gains, or fields, taken from there; empty: all that are tuned
  double box = 1.0;                     ///< width of the box searched, of each parameter's range; in (0, 1]
  std::optional<double> step;           ///< initial step, of the unit box; none: the study's times `box`
};

/// Where the search begins, and the box it keeps to, in search coordinates.
struct WarmPoint {
  std::vector<double> x;
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<std::string> clamped;  ///< one line for each gain that lies outside the study's bounds
};

/// Reads source and gains: of a run folder, or of a gains file as load_gains finds it. Throws InputError,
/// also if they are those of another controller than the space's.
void load_warm_gains(WarmStart& warm, const std::string& folder_or_file, const ParameterSpace& space,
                     const std::vector<std::string>& joints, const std::string& relative_to = {});

/// Throws InputError if a name is none of a tuned gain or field, or if the gains leave one out that is taken
/// from them.
WarmPoint warm_point(const ParameterSpace& space, const WarmStart& warm);

}  // namespace armtune::internal
