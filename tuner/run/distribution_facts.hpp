#pragma once
// The part of a run's record (run_record.hpp) about the joint distribution of its random arms.

#include <string>
#include <vector>

#include "tuner/record/declaration.hpp"

namespace armtune::internal {

/// The joint distribution from which random arms were drawn (arm_distribution.hpp).
struct DistributionFacts {
  std::string file;
  std::vector<std::string> drawn;      ///< names of the parameters that were drawn
  std::vector<std::string> not_drawn;  ///< names of the others, in which simulated arms cannot differ
  std::vector<std::string> not_told;   ///< parameters that the calibration's log does not tell
  bool operator==(const DistributionFacts&) const = default;

  static void declare(auto& f, auto& all) {
    f.type("DistributionFacts")("file", all.file)("drawn", all.drawn)("not_drawn", all.not_drawn);
    f("not_told", all.not_told, "Parameters that the log of the calibration does not tell.");
  }
};

}  // namespace armtune::internal
