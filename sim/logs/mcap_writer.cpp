#include "sim/logs/mcap_writer.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostNumbers = std::numeric_limits<std::uint16_t>::max();

void check_count(std::size_t count, const char* what) {
  if (count > kMostNumbers) {
    throw InputError(InputPlace{.key = what},
                     InputFault{.problem = fmt::format("an MCAP file cannot hold {} of these", count),
                                .value = std::to_string(count),
                                .limit = fmt::format("at most {}", kMostNumbers)});
  }
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& path, McapOptions options)
    : path_(path.string()), options_(std::move(options)), file_(path_) {
  out_.add(kMcapMagic);
  const std::size_t header = out_.begin(McapRecord::kHeader);
  out_.text(options_.profile);
  out_.text("armtune");  // the library
  out_.end(header);
}

std::uint16_t McapWriter::schema_of(const BagTopic& topic) {
  if (topic.type.empty() && topic.schema_encoding.empty() && topic.schema.empty()) return 0;
  check_count(schemas_.size() + 1, "schemas");
  const auto number = static_cast<std::uint16_t>(schemas_.size() + 1);
  const auto [entry, is_new] =
      schemas_.try_emplace({topic.type, topic.schema_encoding, topic.schema}, number);
  if (is_new) {
    const std::size_t record = chunk_.begin(McapRecord::kSchema);
    chunk_.number<std::uint16_t>(number);
    chunk_.text(topic.type);
    chunk_.text(topic.schema_encoding);
    chunk_.text(topic.schema);
    chunk_.end(record);
    index_.add_schema(chunk_.bytes().subspan(record));
  }
  return entry->second;
}

std::size_t McapWriter::add_topic(const BagTopic& topic) {
  check_count(sequence_.size() + 1, "topics");
  const std::uint16_t schema = schema_of(topic);
  const std::size_t record = chunk_.begin(McapRecord::kChannel);
  chunk_.number<std::uint16_t>(static_cast<std::uint16_t>(sequence_.size()));
  chunk_.number<std::uint16_t>(schema);
  chunk_.text(topic.name);
  chunk_.text(topic.encoding);
  chunk_.number<std::uint32_t>(0);  // metadata
  chunk_.end(record);
  index_.add_channel(chunk_.bytes().subspan(record));
  sequence_.push_back(0);
  if (chunk_.size() >= options_.chunk_size) end_chunk();
  return sequence_.size() - 1;
}

void McapWriter::write(std::size_t topic, std::int64_t time, std::span<const std::byte> bytes) {
  const auto refuse = [](const char* key, const std::string& value, const std::string& limit) {
    throw InputError(
        InputPlace{.key = key},
        InputFault{fmt::format("the value {} cannot be written to an MCAP file", value), value, limit});
  };
  constexpr std::size_t kMost = kLargestMcapRecord / 2;  // with its topic and others in one chunk
  if (topic >= sequence_.size())
    refuse("topic", std::to_string(topic), fmt::format("below {}", sequence_.size()));
  if (time < 0) refuse("time", std::to_string(time), "not negative");
  if (bytes.size() > kMost)
    refuse("bytes", std::to_string(bytes.size()), fmt::format("at most {} bytes", kMost));
  if (chunk_.size() > 0 && chunk_.size() + bytes.size() > kMost) end_chunk();
  const auto stamp = static_cast<std::uint64_t>(time);
  const auto channel = static_cast<std::uint16_t>(topic);
  const std::size_t record = chunk_.begin(McapRecord::kMessage);
  index_.add_message(channel, stamp, record);
  chunk_.number<std::uint16_t>(channel);
  chunk_.number<std::uint32_t>(sequence_[topic]++);
  chunk_.number<std::uint64_t>(stamp);
  chunk_.number<std::uint64_t>(stamp);  // publish_time, which is not known
  chunk_.add(bytes);
  chunk_.end(record);
  if (chunk_.size() >= options_.chunk_size) end_chunk();
}

void McapWriter::end_chunk() {
  const std::vector<std::byte> frame = compressed_chunk(options_.compression, chunk_.bytes());
  const std::string_view compression = chunk_compression_name(options_.compression);
  const std::size_t record = out_.begin(McapRecord::kChunk);
  out_.number<std::uint64_t>(index_.chunk_times().first);
  out_.number<std::uint64_t>(index_.chunk_times().last);
  out_.number<std::uint64_t>(chunk_.size());
  out_.number<std::uint32_t>(crc32_of(chunk_.bytes()));
  out_.text(compression);
  out_.number<std::uint64_t>(frame.size());
  out_.add(frame);
  out_.end(record);
  index_.end_chunk({offset_ + record, out_.size() - record, compression, frame.size(), chunk_.size()}, out_);
  chunk_.clear();
  flush();
}

void McapWriter::flush() {
  const auto bytes = out_.bytes();
  crc_.add(bytes);
  file_.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});  // bytes as text
  offset_ += bytes.size();
  out_.clear();
}

void McapWriter::finish() {
  if (chunk_.size() > 0) end_chunk();
  flush();
  const std::size_t record = out_.begin(McapRecord::kDataEnd);
  out_.number<std::uint32_t>(crc_.value());
  out_.end(record);
  flush();
  index_.write_end(offset_, out_);
  flush();
  file_.replace();
}

}  // namespace armtune::internal
