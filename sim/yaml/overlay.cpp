#include <algorithm>

#include "sim/yaml/document.hpp"

namespace armtune::yaml {

Node overlay(const std::vector<Node>& layers) {
  Node merged = layers.back();
  merged.entries_.clear();
  for (const Node& layer : layers) {
    for (const auto& [key, value] : layer.entries()) {
      const auto same = [&key = key](const auto& entry) { return entry.first == key; };
      const auto found = std::find_if(merged.entries_.begin(), merged.entries_.end(), same);
      if (found != merged.entries_.end()) {
        found->second = value;
      } else {
        merged.entries_.emplace_back(key, value);
      }
    }
  }
  return merged;
}

}  // namespace armtune::yaml
