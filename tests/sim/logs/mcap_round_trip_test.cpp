#include <gmock/gmock.h>

#include <algorithm>

#include "sim/csv/text_file.hpp"
#include "tests/sim/logs/support/mcap_files.hpp"

namespace armtune::internal {
namespace mcap_round_trip_test {

namespace fs = std::filesystem;
using test::KeptBag;
using test::KeptMessage;

class McapRoundTrip : public testing::TestWithParam<ChunkCompression> {};

TEST_P(McapRoundTrip, GivesTopicsAndMessagesBackInTheOrderOfWriting) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.mcap";
  for (const int count : {0, 1, 100}) {
    const std::vector<KeptMessage> written = test::write_bag(path, GetParam(), count);
    const KeptBag bag = test::read_whole(path);
    EXPECT_EQ(bag.messages, written) << count;
    EXPECT_FALSE(bag.unfinished);
    ASSERT_EQ(bag.topics.size(), 2U);
    EXPECT_EQ(bag.topics[0].name, "/a");
    EXPECT_EQ(bag.topics[0].type, "pkg/msg/A");
    EXPECT_EQ(bag.topics[0].encoding, "cdr");
    EXPECT_EQ(bag.topics[0].schema, "float64 data\n");
    EXPECT_EQ(bag.topics[0].schema_encoding, "ros2msg");
    EXPECT_EQ(bag.topics[1].name, "/b");
    EXPECT_EQ(bag.topics[1].type + bag.topics[1].schema + bag.topics[1].schema_encoding, "");
  }
}

TEST_P(McapRoundTrip, HoldsMessagesThatAreLargerThanAChunkAndThanTheReadersBuffers) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.mcap";
  std::string large(9'000'000, 'x');
  for (std::size_t n = 0; n < large.size(); n += 3) large[n] = static_cast<char>(n * n >> 5);
  {
    McapWriter bag(path, {.compression = GetParam()});
    const std::size_t topic = bag.add_topic({"/image", "", "cdr", "", ""});
    for (const std::string& bytes : {std::string(), large, std::string("small")})
      bag.write(topic, 5, test::as_raw(bytes));
    bag.finish();
  }
  const KeptBag bag = test::read_whole(path);
  ASSERT_EQ(bag.messages.size(), 3U);
  EXPECT_TRUE(bag.messages[0].bytes.empty());
  EXPECT_TRUE(bag.messages[1].bytes == large);
  EXPECT_EQ(bag.messages[2].bytes, "small");
}

TEST_P(McapRoundTrip, IsByteIdenticalEachTime) {
  const test::TemporaryFolder folder;
  test::write_bag(folder / "a.mcap", GetParam(), 50);
  test::write_bag(folder / "b.mcap", GetParam(), 50);
  EXPECT_TRUE(test::read_text(folder / "a.mcap") == test::read_text(folder / "b.mcap"));
}

INSTANTIATE_TEST_SUITE_P(Compressions, McapRoundTrip,
                         testing::Values(ChunkCompression::kNone, ChunkCompression::kLz4,
                                         ChunkCompression::kZstd));

TEST(McapWriter, LeavesNothingWithoutFinishAndKeepsWhatWasThere) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.mcap", "old");
  {
    McapWriter bag(path);
    bag.write(bag.add_topic({"/a", "", "cdr", "", ""}), 0, {});
  }
  EXPECT_EQ(test::read_text(path), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(McapWriter, RefusesWhatItsOwnReaderWould) {
  const test::TemporaryFolder folder;
  McapWriter bag(folder / "a.mcap");
  const std::size_t topic = bag.add_topic({"/a", "", "cdr", "", ""});
  EXPECT_THAT([&] { bag.write(topic, -1, {}); }, test::refused_at({.key = "time", .value = "-1"}));
  EXPECT_THAT([&] { bag.write(topic + 1, 0, {}); }, test::refused_at({.key = "topic", .value = "1"}));
  EXPECT_THAT([&] { McapWriter(folder / "none/a.mcap"); },
              test::refused_at({.file = folder / "none/a.mcap"}));
}

TEST(McapTopics, ChannelsOfSeveralPublishersAreOneTopic) {
  const test::TemporaryFolder folder;
  ByteBuffer out = test::mcap_begin();
  test::add_schema(out, 1, "pkg/msg/A", "float64 x\n");
  test::add_schema(out, 2, "pkg/msg/A", "float64 x\n");
  test::add_schema(out, 3, "pkg/msg/A", "float64 y\n");
  test::add_channel(out, 7, 1, "/a");
  test::add_channel(out, 8, 2, "/a");
  test::add_channel(out, 9, 3, "/a");
  test::add_channel(out, 10, 1, "/b");
  for (const std::uint16_t channel : std::initializer_list<std::uint16_t>{8, 7, 9, 10, 8})
    test::add_message(out, channel, channel, "");
  test::add_mcap_end(out);
  const auto bag = open_mcap(folder.write("a.mcap", test::as_text(out.bytes())));
  std::vector<std::size_t> topics;
  while (const auto message = bag->next()) topics.push_back(message->topic);
  EXPECT_THAT(topics, testing::ElementsAre(0, 0, 1, 2, 0));
  EXPECT_EQ(bag->topics().size(), 3U);
}

TEST(McapReader, TakesWhatLaterVersionsMayAddAndSkipsWhatItDoesNotNeed) {
  const test::TemporaryFolder folder;
  ByteBuffer records;
  test::add_record(records, McapRecord{0x20}, test::as_raw("a kind of a later version"));
  test::add_message(records, 1, 2, "in a chunk");
  ByteBuffer out = test::mcap_begin();
  const std::size_t schema = out.begin(McapRecord::kSchema);
  out.number<std::uint16_t>(1);
  for (const char* text : {"pkg/msg/A", "ros2msg", "float64 x\n", "a field of a later version"})
    out.text(text);
  out.end(schema);
  test::add_channel(out, 1, 1, "/a");
  test::add_record(out, McapRecord{0x99}, test::as_raw("a record of an application"));
  test::add_record(out, McapRecord::kAttachment, test::as_raw(std::string(600'000, 'x')));
  test::add_message(out, 1, 1, "outside of chunks");
  test::add_chunk(out, records.bytes(), {.crc = crc32_of(records.bytes())});
  test::add_record(out, McapRecord::kMetadata);
  test::add_mcap_end(out);
  const KeptBag bag = test::read_whole(folder.write("a.mcap", test::as_text(out.bytes())));
  EXPECT_FALSE(bag.unfinished);
  ASSERT_EQ(bag.messages.size(), 2U);
  EXPECT_EQ(bag.messages[0], (KeptMessage{"/a", 1, "outside of chunks"}));
  EXPECT_EQ(bag.messages[1], (KeptMessage{"/a", 2, "in a chunk"}));
}

}  // namespace mcap_round_trip_test
}  // namespace armtune::internal
