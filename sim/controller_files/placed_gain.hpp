#pragma once
// Represents a gain in a ROS parameter file by its value and the place of its number in the file. Tuned gains
// are written back to this place.

#include <string>

#include "sim/yaml/placed_value.hpp"

namespace armtune::internal {

/// The name of a gain in messages.
struct GainName {
  std::string gain;  ///< "p"
  std::string part;  ///< the joint "shoulder", or the direction "x" of the tool; empty for a single number
};

/// Returns "p of shoulder", or "p" if the gain is a single number.
inline std::string words(const GainName& name) {
  return name.part.empty() ? name.gain : name.gain + " of " + name.part;
}

struct PlacedGain {
  const yaml::PlacedValue* at;  ///< null: the file has no number for this gain
  GainName name;                ///< for messages
  double value;                 ///< of the number in the file
  std::string entry;            ///< name of the gain in studies: "jtc_p/shoulder"
  double factor = 1.0;          ///< the gain is this factor times the number in the file
  bool same_place = false;      ///< true: a map binds another gain before this one to the same place
};

}  // namespace armtune::internal
