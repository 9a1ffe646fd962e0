#include "sim/logs/mcap_summary_check.hpp"

#include <fmt/format.h>

#include "sim/logs/byte_cursor.hpp"

namespace armtune::internal {

McapFooter mcap_footer(std::span<const std::byte> content, const McapPlace& place) {
  if (content.size() != kMcapFooter) {
    throw mcap_error(place, {.problem = fmt::format("has {} bytes", content.size()),
                             .value = std::to_string(content.size()),
                             .limit = fmt::format("{} bytes", kMcapFooter)});
  }
  ByteCursor record(content, place);
  McapFooter footer;
  footer.summary_start = record.number<std::uint64_t>();
  footer.summary_offset_start = record.number<std::uint64_t>();
  footer.summary_crc = record.number<std::uint32_t>();
  return footer;
}

void check_mcap_crc(const McapPlace& place, std::uint32_t stated, std::uint32_t computed,
                    std::string_view what) {
  if (stated == 0 || stated == computed) return;
  throw mcap_error(place,
                   {.problem = fmt::format("states the CRC {:08x} for {}, but its content has the CRC {:08x}",
                                           stated, what, computed),
                    .value = fmt::format("{:08x}", computed),
                    .limit = fmt::format("{:08x}", stated)});
}

InputError too_long_mcap_record(const McapPlace& place, std::uint64_t length) {
  return mcap_error(place, {.problem = fmt::format("has {} bytes of content", length),
                            .value = std::to_string(length),
                            .limit = fmt::format("at most {} bytes", kLargestMcapRecord)});
}

void McapSummaryCheck::set_statistics(std::span<const std::byte> content, const McapPlace& place) {
  stated_messages_ = ByteCursor(content, place).number<std::uint64_t>();
}

void McapSummaryCheck::check(const McapFooter& footer, std::uint32_t crc, const McapPlace& place) const {
  if (begin_) {
    if (footer.summary_start != 0 && footer.summary_start != *begin_) {
      throw mcap_error(place, {.problem = fmt::format(
                                   "states that the summary begins at byte {}, but it begins at byte {}",
                                   footer.summary_start, *begin_),
                               .value = std::to_string(footer.summary_start),
                               .limit = std::to_string(*begin_)});
    }
    check_mcap_crc(place, footer.summary_crc, crc, "the file's summary");
  }
  if (!begin_ && footer.summary_start != 0)
    throw mcap_error(place, {.problem = "states a summary, but no DataEnd record ends the data before it"});
  if (stated_messages_ && *stated_messages_ != messages_) {
    throw mcap_error(
        place, {.problem = fmt::format("ends a file with {} messages, but its Statistics count {}", messages_,
                                       *stated_messages_),
                .value = std::to_string(messages_),
                .limit = std::to_string(*stated_messages_)});
  }
}

}  // namespace armtune::internal
