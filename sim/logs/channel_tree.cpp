#include "sim/logs/channel_tree.hpp"

#include <fmt/format.h>

#include <utility>

#include "sim/logs/message_units.hpp"

namespace armtune::internal {
namespace {

std::string element_path(const std::string& path, const MessageField& field, std::size_t i) {
  return field.shape == FieldShape::kSingle ? path : fmt::format("{}[{}]", path, i);
}

}  // namespace

ChannelTree::ChannelTree(const MessageDefinition& definition, const std::string& topic, std::size_t most)
    : definition_(definition), most_(most), root_(fields_of(definition.types.front(), topic, {})) {}

bool ChannelTree::add_channels(ChannelField& place, const MessageField& field, std::size_t count) {
  const bool is_time = field.kind == FieldKind::kTime || field.kind == FieldKind::kDuration;
  if (paths_.size() + count - place.channels.size() > most_) return false;
  while (place.channels.size() < count) {
    const std::size_t i = place.channels.size();
    place.channels.push_back(static_cast<std::uint32_t>(paths_.size()));
    paths_.push_back(element_path(place.path, field, i));
    units_.emplace_back(is_time ? std::string_view("s") : place.unit);
  }
  return true;
}

std::vector<ChannelField>* ChannelTree::add_element(ChannelField& place, const MessageField& field,
                                                    std::size_t i) {
  while (place.elements.size() <= i) {
    const MessageType& type = definition_.types[field.type];
    if (places_ + type.fields.size() > most_) return nullptr;
    place.elements.push_back(
        fields_of(type, element_path(place.path, field, place.elements.size()), place.unit));
  }
  return &place.elements[i];
}

std::vector<ChannelField> ChannelTree::fields_of(const MessageType& type, const std::string& path,
                                                 std::string_view unit) {
  std::vector<ChannelField> fields;
  fields.reserve(type.fields.size());
  places_ += type.fields.size();
  for (const MessageField& field : type.fields) {
    const std::string_view own = unit_of(type.name, field.name);
    fields.push_back({fmt::format("{}/{}", path, field.name), own.empty() ? unit : own, {}, {}});
  }
  return fields;
}

}  // namespace armtune::internal
