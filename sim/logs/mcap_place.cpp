#include "sim/logs/mcap_place.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace armtune::internal {

std::string_view mcap_record_name(McapRecord kind) {
  static constexpr std::array<std::string_view, 16> kNames{
      "unknown",  "Header",        "Footer",        "Schema",     "Channel",         "Message",
      "Chunk",    "MessageIndex",  "ChunkIndex",    "Attachment", "AttachmentIndex", "Statistics",
      "Metadata", "MetadataIndex", "SummaryOffset", "DataEnd"};
  const auto index = static_cast<std::size_t>(kind);
  return index < kNames.size() ? kNames[index] : kNames[0];
}

InputError mcap_error(const McapPlace& place, InputFault fault) {
  const std::string inside =
      place.in_chunk < 0 ? "" : fmt::format(", at byte {} of its decompressed content,", place.in_chunk);
  fault.problem =
      fmt::format("the {} record {} byte {}{} {}", mcap_record_name(place.kind),
                  place.in_chunk < 0 ? "at" : "in the chunk at", place.offset, inside, fault.problem);
  return InputError(InputPlace{place.file, 0, fmt::format("byte {}", place.offset)}, std::move(fault))
      .with("; record again, or save what is whole with 'mcap recover'");
}

}  // namespace armtune::internal
