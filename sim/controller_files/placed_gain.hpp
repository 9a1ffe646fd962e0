#pragma once
// Represents a gain in a ROS parameter file by its value and the place of its number in the file. Tuned gains
// are written back to this place.

#include <string>

#include "sim/yaml/placed_value.hpp"

namespace armtune::internal {

struct PlacedGain {
  const yaml::PlacedValue* at;  ///< null: the file has no number for this gain
  std::string name;             ///< for messages: "p of shoulder"
  double value;
};

}  // namespace armtune::internal
