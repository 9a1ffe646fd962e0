#pragma once
// Formats floating-point numbers as decimal text that every YAML reader takes for a floating-point number.

#include <string>

namespace armtune::internal::yaml {

/// Returns the shortest text that reads back to the same bits. It always has a decimal point, also before an
/// exponent, because ROS 2 takes 5 for an integer and YAML 1.1 takes 1e-05 for a string.
std::string decimal(double value);

}  // namespace armtune::internal::yaml
