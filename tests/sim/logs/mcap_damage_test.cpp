#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

#include "tests/sim/logs/support/mcap_files.hpp"

namespace armtune::internal {
namespace mcap_damage_test {

using test::KeptBag;
using test::KeptMessage;

std::string byte_key(std::size_t offset) {
  return "byte " + std::to_string(offset);
}

/// Writes a file that is not there yet: ext4 flushes one that is written again to the disk, which takes 10
/// ms.
std::string write_again(const test::TemporaryFolder& folder, const std::string& bytes) {
  std::filesystem::remove(folder / "a.mcap");
  return folder.write("a.mcap", bytes);
}

class McapDamage : public testing::TestWithParam<ChunkCompression> {};

TEST_P(McapDamage, EveryPrefixIsUnfinishedWithTheFirstMessagesOrRefused) {
  const test::TemporaryFolder folder;
  const std::vector<KeptMessage> written = test::write_bag(folder / "whole.mcap", GetParam(), 20);
  const std::string whole = test::read_text(folder / "whole.mcap");
  std::size_t most = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string path = write_again(folder, whole.substr(0, size));
    if (size < kMcapMagic.size()) {
      EXPECT_THAT([&] { open_mcap(path); }, test::refused_at({.file = path}));
      continue;
    }
    const KeptBag bag = test::read_whole(path);
    EXPECT_TRUE(bag.unfinished) << size;
    ASSERT_LE(bag.messages.size(), written.size()) << size;
    EXPECT_TRUE(std::equal(bag.messages.begin(), bag.messages.end(), written.begin())) << size;
    EXPECT_GE(bag.messages.size(), most) << "fewer messages in a longer file, of " << size << " bytes";
    most = bag.messages.size();
  }
  EXPECT_EQ(most, written.size());
}

TEST_P(McapDamage, EveryFlippedBitIsRefusedUnfinishedOrWithoutEffectOnTheMessages) {
  const test::TemporaryFolder folder;
  const std::vector<KeptMessage> written = test::write_bag(folder / "whole.mcap", GetParam(), 4);
  const std::string whole = test::read_text(folder / "whole.mcap");
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    const std::string path = write_again(folder, flipped);
    KeptBag bag;
    const InputError error = test::input_error([&] { bag = test::read_whole(path); });
    // Some bits, such as those of a time in the index, say nothing of the messages if no checksum covers them
    // any more.
    if (error.place().file.empty()) {
      EXPECT_TRUE(bag.messages == written) << "bit " << bit;
      EXPECT_FALSE(bag.unfinished) << "bit " << bit << ": the file has an end";
    } else {
      EXPECT_EQ(error.place().file, path) << "bit " << bit;
    }
  }
}

TEST_P(McapDamage, AChunkThatStatesAnotherSizeIsRefused) {
  const test::TemporaryFolder folder;
  ByteBuffer records;
  test::add_record(records, McapRecord{0x20}, test::as_raw(std::string(3000, 'x')));
  const auto frame = compressed_chunk(GetParam(), records.bytes());
  const std::string_view name = chunk_compression_name(GetParam());
  for (const std::uint64_t size :
       {std::uint64_t{0}, records.size() - 1, records.size() + 1, std::uint64_t{100'000'000},
        std::uint64_t{kLargestMcapRecord} + 1, ~std::uint64_t{0}}) {
    ByteBuffer out = test::mcap_begin();
    const std::size_t place = out.size();
    test::add_chunk(out, frame, {.compression = name, .size = size});
    test::add_mcap_end(out);
    const std::string path = folder.write("a.mcap", test::as_text(out.bytes()));
    EXPECT_THAT([&] { test::read_whole(path); }, test::refused_at({.file = path, .key = byte_key(place)}))
        << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Compressions, McapDamage,
                         testing::Values(ChunkCompression::kNone, ChunkCompression::kLz4,
                                         ChunkCompression::kZstd));

/// Expects that a file with these bytes behind its Header is refused at their first record.
void expect_refused(const std::function<void(ByteBuffer&)>& add,
                    const testing::Matcher<std::string>& limit = testing::_) {
  const test::TemporaryFolder folder;
  ByteBuffer out = test::mcap_begin();
  const std::size_t place = out.size();
  add(out);
  test::add_mcap_end(out);
  const std::string path = folder.write("a.mcap", test::as_text(out.bytes()));
  EXPECT_THAT([&] { test::read_whole(path); },
              test::refused_at({.file = path, .key = byte_key(place), .limit = limit}));
}

TEST(McapDamage, RecordsThatMayNotBeInChunksAreRefused) {
  for (int kind = 0; kind <= 0x0F; ++kind) {
    if (kind >= 3 && kind <= 5) continue;  // Schema, Channel, Message
    expect_refused([&](ByteBuffer& out) {
      ByteBuffer records;
      test::add_record(records, static_cast<McapRecord>(kind), test::as_raw(std::string(100, '\0')));
      test::add_chunk(out, records.bytes());
    });
  }
}

TEST(McapDamage, RecordsInTheWrongPartOfTheFileAreRefused) {
  expect_refused([](ByteBuffer& out) {
    test::add_record(out, McapRecord::kHeader, test::as_raw(std::string(8, '\0')));
  });
  expect_refused([](ByteBuffer& out) { test::add_record(out, McapRecord{0}); });
  const test::TemporaryFolder folder;
  for (const McapRecord kind :
       {McapRecord::kDataEnd, McapRecord::kChunk, McapRecord::kMessage, McapRecord::kAttachment}) {
    ByteBuffer out = test::mcap_begin();
    test::add_record(out, McapRecord::kDataEnd, test::as_raw(std::string(4, '\0')));
    const std::size_t place = out.size();
    test::add_record(out, kind, test::as_raw(std::string(100, '\0')));
    const std::string path = folder.write("a.mcap", test::as_text(out.bytes()));
    EXPECT_THAT([&] { test::read_whole(path); }, test::refused_at({.key = byte_key(place)}));
  }
  const std::string path =
      folder.write("b.mcap", test::as_text(kMcapMagic) + std::string("\x05", 1) + std::string(8, '\0'));
  EXPECT_THAT([&] { test::read_whole(path); }, test::refused_at({.file = path, .key = byte_key(8)}));
}

TEST(McapDamage, LengthsThatLieAreRefusedInAFileThatHasAnEnd) {
  for (const int kind : {0x03, 0x05, 0x06, 0x07, 0x09, 0x7F}) {
    for (const std::uint64_t length :
         {std::uint64_t{5000}, std::uint64_t{200'000'000}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
      expect_refused([&](ByteBuffer& out) {
        out.number<std::uint8_t>(static_cast<std::uint8_t>(kind));
        out.number<std::uint64_t>(length);
        out.add(test::as_raw(std::string(200, '\0')));
      });
    }
  }
}

TEST(McapDamage, FieldsThatLieAreRefused) {
  expect_refused([](ByteBuffer& out) {
    test::add_record(out, McapRecord::kMessage, test::as_raw(std::string(21, '\0')));
  });
  expect_refused([](ByteBuffer& out) { test::add_message(out, 9, 1, "of a channel that is not there"); });
  expect_refused([](ByteBuffer& out) { test::add_channel(out, 1, 3, "/of_a_schema_that_is_not_there"); });
  expect_refused([](ByteBuffer& out) { test::add_channel(out, 1, 0, "/\xFF"); });
  expect_refused([](ByteBuffer& out) {
    test::add_record(out, McapRecord::kSchema, test::as_raw("\1\1\xFF\xFF\xFF\xFFname"));
  });
  expect_refused([](ByteBuffer& out) { test::add_record(out, McapRecord::kDataEnd, test::as_raw("abcd")); },
                 testing::Not(""));
  expect_refused([](ByteBuffer& out) { test::add_chunk(out, {}, {.compression = "bz2"}); }, testing::Not(""));
  expect_refused([](ByteBuffer& out) {
    test::add_chunk(out, test::as_raw("12345678"), {.size = 8, .compressed_size = 9});
  });
  expect_refused([](ByteBuffer& out) { test::add_chunk(out, test::as_raw("short of a record head"), {}); });
  expect_refused([](ByteBuffer& out) {
    ByteBuffer records;
    test::add_record(records, McapRecord{0x20});
    test::add_chunk(out, records.bytes(), {.crc = crc32_of(records.bytes()) ^ 1U});
  });
}

TEST(McapDamage, ATimeThatDoesNotFitIsRefused) {
  const test::TemporaryFolder folder;
  ByteBuffer out = test::mcap_begin();
  test::add_channel(out, 1, 0, "/a");
  test::add_message(out, 1, (std::uint64_t{1} << 63) - 1, "the last one that fits");
  const std::size_t place = out.size();
  test::add_message(out, 1, std::uint64_t{1} << 63, "");
  const auto bag = open_mcap(folder.write("a.mcap", test::as_text(out.bytes())));
  EXPECT_EQ(bag->next()->time, std::numeric_limits<std::int64_t>::max());
  EXPECT_THAT([&] { bag->next(); },
              test::refused_at({.key = byte_key(place), .value = "9223372036854775808"}));
}

TEST(McapDamage, TheSameNumberForSomethingElseIsRefused) {
  const test::TemporaryFolder folder;
  const auto second = [&](const std::function<void(ByteBuffer&)>& add) {
    ByteBuffer out = test::mcap_begin();
    test::add_schema(out, 1, "pkg/msg/A");
    test::add_schema(out, 1, "pkg/msg/A");
    test::add_channel(out, 1, 1, "/a");
    test::add_channel(out, 1, 1, "/a");
    const std::size_t place = out.size();
    add(out);
    const std::string path = folder.write("a.mcap", test::as_text(out.bytes()));
    EXPECT_THAT([&] { test::read_whole(path); }, test::refused_at({.key = byte_key(place), .value = "1"}));
  };
  second([](ByteBuffer& out) { test::add_schema(out, 1, "pkg/msg/B"); });
  second([](ByteBuffer& out) { test::add_schema(out, 1, "pkg/msg/A", "float64 x\n"); });
  second([](ByteBuffer& out) { test::add_channel(out, 1, 1, "/b"); });
  second([](ByteBuffer& out) { test::add_channel(out, 1, 0, "/a"); });
}

TEST(McapDamage, AWrongNumberOfMessagesAndAWrongSummaryAreRefused) {
  const test::TemporaryFolder folder;
  const auto end_with = [&](std::uint64_t stated, std::uint64_t start_error, std::uint32_t crc_error) {
    ByteBuffer out = test::mcap_begin();
    test::add_channel(out, 1, 0, "/a");
    test::add_message(out, 1, 1, "one");
    test::add_record(out, McapRecord::kDataEnd, test::as_raw(std::string(4, '\0')));
    const std::size_t summary = out.size();
    const std::size_t statistics = out.begin(McapRecord::kStatistics);
    out.number<std::uint64_t>(stated);
    out.end(statistics);
    const std::size_t footer = out.begin(McapRecord::kFooter);
    out.number<std::uint64_t>(summary + start_error);
    out.number<std::uint64_t>(0);
    out.put<std::uint64_t>(footer + 1, kMcapFooter);
    out.number<std::uint32_t>(crc32_of(out.bytes().subspan(summary)) ^ crc_error);
    out.end(footer);
    out.add(kMcapMagic);
    return std::pair(folder.write("a.mcap", test::as_text(out.bytes())), footer);
  };
  EXPECT_EQ(test::read_whole(end_with(1, 0, 0).first).messages.size(), 1U);
  for (const auto& [stated, start_error, crc_error] :
       {std::tuple<std::uint64_t, std::uint64_t, std::uint32_t>{2, 0, 0}, {0, 0, 0}, {1, 1, 0}, {1, 0, 1}}) {
    const auto [path, footer] = end_with(stated, start_error, crc_error);
    EXPECT_THAT([&p = path] { test::read_whole(p); },
                test::refused_at({.file = path, .key = byte_key(footer)}));
  }
}

TEST(McapDamage, BombsAreRefusedBeforeTheyFillMemory) {
  // 240 MB of an unknown record that compress to 8 kB each: the second one is too much for a file of this
  // size.
  ByteBuffer records;
  test::add_record(records, McapRecord{0x20}, std::vector<std::byte>(60'000'000));
  const auto frame = compressed_chunk(ChunkCompression::kZstd, records.bytes());
  ASSERT_LT(frame.size(), 50'000U);
  const test::TemporaryFolder folder;
  ByteBuffer out = test::mcap_begin();
  for (int n = 0; n < 50; ++n) test::add_chunk(out, frame, {.compression = "zstd", .size = records.size()});
  const std::string path = folder.write("a.mcap", test::as_text(out.bytes()));
  EXPECT_THAT([&] { test::read_whole(path); },
              test::refused_at({.file = path, .limit = testing::HasSubstr("1024")}));
}

TEST(McapDamage, DefinitionsThatFillMemoryAreRefused) {
  // Each of the topics has a copy of a definition of a megabyte.
  const test::TemporaryFolder folder;
  ByteBuffer out = test::mcap_begin();
  test::add_schema(out, 1, "pkg/msg/A", std::string(1U << 20, 'x'));
  for (std::uint16_t n = 0; n < 100; ++n) test::add_channel(out, n, 1, "/" + std::to_string(n));
  const std::string path = folder.write("a.mcap", test::as_text(out.bytes()));
  EXPECT_THAT([&] { test::read_whole(path); }, test::refused_at({.file = path, .limit = testing::Not("")}));
}

TEST(McapDamage, WhatIsNoFileIsRefused) {
  const test::TemporaryFolder folder;
  EXPECT_THAT([&] { open_mcap(folder / "none.mcap"); }, test::refused_at({.file = folder / "none.mcap"}));
  EXPECT_THAT([&] { open_mcap(folder.path()); }, test::refused_at({.limit = testing::Not("")}));
  const std::string text = folder.write("text.mcap", "t,q1,q2\n0,1,2\n");
  EXPECT_THAT([&] { open_mcap(text); }, test::refused_at({.file = text}));
}

}  // namespace mcap_damage_test
}  // namespace armtune::internal
