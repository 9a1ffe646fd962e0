#pragma once
// What there is to know of every controller and its gains, as its declaration says it.

#include <string>

namespace armtune::internal::cli {

/// Every gain with its shape, default search range, meaning and unit: first those that every controller has,
/// then each controller's.
std::string controllers_text();

}  // namespace armtune::internal::cli
