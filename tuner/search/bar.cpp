#include "tuner/search/bar.hpp"

namespace armtune {
namespace {

/// NLopt's parents of ESCH, and of CRS2 per parameter and one.
constexpr std::size_t kEschParents = 40;
constexpr std::size_t kCrsPerParameter = 10;

}  // namespace

Bar::Bar(const std::string& algorithm, std::size_t parameters) {
  if (algorithm == "ESCH") size_ = kEschParents;
  if (algorithm == "CRS2") size_ = kCrsPerParameter * (parameters + 1);
}

void Bar::told(double value) {
  if (!exists()) return;
  best_.push(value);
  if (best_.size() > size_) best_.pop();
}

}  // namespace armtune
