#include "tuner/controller_study/shared_numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "core/common/message_text.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {

std::vector<SharedNumber> shared_numbers(const ControllerInFile& from) {
  if (from.file.empty()) return {};
  std::unordered_map<std::string, std::pair<const GainField*, std::size_t>> searched;
  for (const GainField* field : searched_fields(from)) {
    const std::vector<std::string> parts = component_names(*field, from.joints);
    for (std::size_t k = 0; k < parts.size(); ++k) searched[entry_name(*field, parts[k])] = {field, k};
  }
  std::vector<SharedNumber> numbers;
  std::unordered_map<const yaml::PlacedValue*, std::size_t> places;
  for (const PlacedGain& gain : placed_gains(from.controller, from.file, from.gains, from.joints)) {
    const auto found = searched.find(gain.entry);
    if (gain.at == nullptr || found == searched.end()) continue;
    const auto [at, is_new] = places.emplace(gain.at, numbers.size());
    if (is_new) numbers.emplace_back();
    numbers[at->second].push_back(
        {found->second.first, found->second.second, gain.entry, gain.name, gain.factor});
  }
  std::erase_if(numbers, [](const SharedNumber& number) { return number.size() < 2; });
  return numbers;
}

const SharedNumber* number_of(const std::vector<SharedNumber>& shared, const GainField& field,
                              std::size_t k) {
  for (const SharedNumber& number : shared) {
    const bool found = std::any_of(number.begin(), number.end(), [&field, k](const SharedGain& gain) {
      return gain.field == &field && gain.component == k;
    });
    if (found) return &number;
  }
  return nullptr;
}

std::string link_lines(const SharedNumber& number, const SharedGain& tuned) {
  std::string text;
  for (const SharedGain& gain : number) {
    if (&gain == &tuned) continue;
    const double factor = gain.factor / tuned.factor;
    text += fmt::format("  - {{name: {}, link: {}{}}}\n", yaml::quoted(gain.entry), yaml::quoted(tuned.entry),
                        factor == 1.0 ? "" : fmt::format(", factor: {}", factor));
  }
  return text;
}

std::string sharing_note(const ControllerInFile& from, const std::vector<const SharedNumber*>& shared) {
  // "p, d of j1, j2" says the same as "p of j1, j2" and "d of j1, j2".
  std::vector<std::pair<std::string, std::vector<std::string>>> by_parts;  // ("j1, j2", {"p", "d"})
  for (const SharedNumber* number : shared) {
    std::vector<std::string> parts, names;
    const std::string& gain = number->front().name.gain;
    bool same = true;
    for (const SharedGain& other : *number) {
      same = same && other.name.gain == gain;
      parts.push_back(other.name.part);
      names.push_back(words(other.name));
    }
    const std::string of = same ? fmt::format("{}", fmt::join(parts, ", ")) : std::string();
    const std::string what = same ? gain : fmt::format("{}", fmt::join(names, ", "));
    const auto found = std::find_if(by_parts.begin(), by_parts.end(),
                                    [&of](const auto& other) { return other.first == of; });
    if (found != by_parts.end() && same)
      found->second.push_back(what);
    else
      by_parts.push_back({of, {what}});
  }
  std::vector<std::string> groups;
  groups.reserve(by_parts.size());
  for (const auto& [parts, gains] : by_parts)
    groups.push_back(
        fmt::format("{}{}{}", fmt::join(gains, ", "), parts.empty() ? "" : " of ", one_line(parts)));
  return fmt::format(
      "in {}, several gains share one number: {}. They are linked in the study and get one value; to tune "
      "them separately, write a number for each of them{}",
      from.file, fmt::join(groups, "; "),
      from.controller.layout == GainLayout::kMapped ? ", and give the place of each in the map"
                                                    : " in place of the YAML alias");
}

}  // namespace armtune::internal
