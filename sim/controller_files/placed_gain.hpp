#pragma once
// A gain that a ROS parameter file gives, with the place of its number in the file.

#include <string>

#include "sim/yaml/placed_value.hpp"

namespace armtune::internal {

struct PlacedGain {
  const yaml::PlacedValue* at;  ///< null: the file has no number for it
  std::string name;             ///< for messages: "p of shoulder"
  double value;
};

}  // namespace armtune::internal
