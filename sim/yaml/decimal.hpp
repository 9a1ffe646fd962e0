#pragma once
// Numbers as every reader of YAML takes them for numbers that need not be whole.

#include <string>

namespace armtune::internal::yaml {

/// The shortest text that reads back to the same bits, with a point, and one before an exponent: 5 is a whole
/// number to ROS 2, and 1e-05 a word to YAML 1.1.
std::string decimal(double value);

}  // namespace armtune::internal::yaml
