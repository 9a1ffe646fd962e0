#include <string_view>
#include <unordered_map>

#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

Node overlay(const std::vector<Node>& layers) {
  Node merged = layers.back();
  merged.entries_.clear();
  std::unordered_map<std::string_view, std::size_t> places;  // index of each key in `merged`
  for (const Node& layer : layers) {
    for (const auto& [key, value] : layer.entries()) {
      const auto [place, is_new] = places.emplace(key, merged.entries_.size());
      if (is_new) {
        merged.entries_.emplace_back(key, value);
      } else {
        merged.entries_[place->second].second = value;
      }
    }
  }
  return merged;
}

}  // namespace armtune::internal::yaml
