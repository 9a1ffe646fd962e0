#include "sim/logs/sqlite_bag.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cstddef>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "sim/logs/message_decoder.hpp"
#include "sim/logs/open_bag.hpp"
#include "tests/sim/logs/cdr_writer.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace sqlite_bag_test {

using test::refused_at;

const char* const kTopics =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);";
const char* const kMessages =
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,"
    " data BLOB NOT NULL); CREATE INDEX timestamp_idx ON messages (timestamp ASC);";
const char* const kTwoTopics =
    "INSERT INTO topics VALUES(3, '/a', 'std_msgs/msg/Float64', 'cdr', ''),"
    " (7, '/b', 'pkg/msg/Own', 'cdr', '');";

/// Runs the statements on a new database, or on one that exists.
void run_sql(const std::string& path, const std::string& sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  char* error = nullptr;
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &error), SQLITE_OK) << error;
  sqlite3_free(error);
  sqlite3_close(database);
}

std::string hex(const std::vector<std::byte>& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : bytes) {
    text += kDigits[std::to_integer<unsigned>(byte) >> 4U];
    text += kDigits[std::to_integer<unsigned>(byte) & 15U];
  }
  return "x'" + text + "'";
}

std::string insert(int topic, long time, double value) {
  return "INSERT INTO messages(topic_id, timestamp, data) VALUES(" + std::to_string(topic) + "," +
         std::to_string(time) + "," + hex(test::CdrWriter().number(value).bytes()) + ");";
}

long count(BagReader& bag) {
  long messages = 0;
  while (bag.next()) ++messages;
  return messages;
}

TEST(SqliteBag, GivesTopicsAndMessagesInTheOrderOfRecording) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "strange name?#%.db3";
  run_sql(path, std::string(kTopics) + kMessages + kTwoTopics + insert(7, 900, 1.0) + insert(3, 500, 2.0) +
                    insert(3, 1'700'000'000'000'000'001, 3.0));
  const auto bag = open_sqlite_bag(path);
  ASSERT_EQ(bag->topics().size(), 2U);
  EXPECT_EQ(bag->topics()[1].name, "/b");
  EXPECT_EQ(bag->topics()[1].type, "pkg/msg/Own");
  EXPECT_EQ(bag->topics()[0].encoding, "cdr");
  EXPECT_EQ(bag->topics()[0].schema_encoding, "");
  MessageDecoder decoder(bag->topics()[0], MessageDefinitions(), path);
  DecodedMessage decoded;
  const std::vector<std::int64_t> times = {900, 500, 1'700'000'000'000'000'001};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto message = bag->next();
    ASSERT_TRUE(message);
    EXPECT_EQ(message->topic, i == 0 ? 1U : 0U);
    EXPECT_EQ(message->time, times[i]);
    decoder.decode(message->bytes, decoded);
    EXPECT_EQ(decoded.values.front(), static_cast<double>(i + 1));
  }
  EXPECT_FALSE(bag->next());
  EXPECT_FALSE(bag->next());
}

TEST(SqliteBag, GivesTheSchemasOfNewerFiles) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "new.db3";
  run_sql(path, std::string(kTopics) + kMessages + kTwoTopics +
                    "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL,"
                    " encoding TEXT NOT NULL,"
                    " encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);"
                    "INSERT INTO message_definitions VALUES(1, 'pkg/msg/Own', 'ros2msg', 'float32 x', '');");
  const auto bag = open_sqlite_bag(path);
  EXPECT_EQ(bag->topics()[1].schema, "float32 x");
  EXPECT_EQ(bag->topics()[1].schema_encoding, "ros2msg");
  EXPECT_EQ(bag->topics()[0].schema, "");
}

TEST(SqliteBag, LeavesTheFileAndItsFolderAsTheyAre) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.db3";
  run_sql(path, std::string(kTopics) + kMessages + kTwoTopics + insert(3, 1, 1.0));
  const std::string before = test::read_text(path);
  EXPECT_EQ(count(*open_sqlite_bag(path)), 1);
  EXPECT_EQ(test::read_text(path), before);
  long files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
  EXPECT_EQ(files, 1);
}

TEST(SqliteBag, OtherFilesAreRefused) {
  const test::TemporaryFolder folder;
  const auto opened = [](const std::string& path) {
    return [path] { return open_sqlite_bag(path)->next().has_value(); };
  };
  EXPECT_THAT(opened(folder / "none.db3"), refused_at({.file = folder / "none.db3"}));
  EXPECT_THAT(opened(folder.path()), refused_at({.file = folder.path()}));
  const std::string text = folder.write("text.db3", "no database, but a text that is longer than any header");
  EXPECT_THAT(opened(text), refused_at({.file = text}));
  const std::string other = folder / "other.db3";
  run_sql(other, kTopics);
  EXPECT_THAT(opened(other), refused_at({.file = other}));
  const std::string columns = folder / "columns.db3";
  run_sql(columns, std::string(kTopics) + "CREATE TABLE messages(id INTEGER PRIMARY KEY, data BLOB);");
  EXPECT_THAT(opened(columns), refused_at({.file = columns}));
  const std::string unknown = folder / "unknown.db3";
  run_sql(unknown, std::string(kTopics) + kMessages + kTwoTopics + insert(4, 1, 1.0));
  EXPECT_THAT(opened(unknown), refused_at({.file = unknown}));
  const std::string control = folder / "control.db3";
  run_sql(control, std::string(kTopics) + kMessages +
                       "INSERT INTO topics VALUES(1, '/a' || char(27), 'x', 'cdr', '');");
  EXPECT_THAT(opened(control), refused_at({.file = control}));
}

TEST(SqliteBag, ViewsAndComputedColumnsCannotRunOnAndOn) {
  const test::TemporaryFolder folder;
  const std::string view = folder / "view.db3";
  run_sql(
      view,
      std::string(kTopics) + kTwoTopics +
          "CREATE VIEW messages AS WITH RECURSIVE n(topic_id) AS (SELECT 3 UNION ALL SELECT topic_id FROM n)"
          " SELECT topic_id, 1 AS timestamp, x'00' AS data FROM n;");
  EXPECT_THAT([&] { return open_sqlite_bag(view)->topics().size(); }, refused_at({.file = view}));
  const std::string computed = folder / "computed.db3";
  run_sql(computed,
          std::string(kTopics) + kTwoTopics +
              "CREATE TABLE messages(topic_id INTEGER, timestamp INTEGER, data BLOB AS (zeroblob(1000000)));"
              "INSERT INTO messages VALUES(3, 1);");
  EXPECT_THAT([&] { return count(*open_sqlite_bag(computed)); }, refused_at({.file = computed}));
}

TEST(SqliteBag, AWriteAheadLogBesideTheFileIsRefused) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.db3";
  run_sql(path, std::string(kTopics) + kMessages + kTwoTopics);
  folder.write("a.db3-wal", "not merged");
  EXPECT_THAT([&] { return open_sqlite_bag(path)->topics().size(); }, refused_at({.file = path}));
}

TEST(SqliteBag, DamagedFilesEndInOneLineOrInFewerMessages) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.db3";
  std::string sql = std::string(kTopics) + kMessages + kTwoTopics;
  for (int i = 0; i < 200; ++i) sql += insert(3, i, i);
  run_sql(path, sql);
  const std::string whole = test::read_text(path);
  const auto read = [&](const std::string& bytes) {
    const std::string damaged = folder.write("damaged.db3", bytes);
    try {
      EXPECT_LE(count(*open_sqlite_bag(damaged)), static_cast<long>(bytes.size() / 6));
    } catch (const InputError& error) {
      EXPECT_EQ(error.place().file, damaged);
    }
  };
  for (std::size_t size = 0; size < whole.size(); size += 1021) read(whole.substr(0, size));
  for (std::size_t at = 0; at < whole.size(); at += 257) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(~bytes[at]);
    read(bytes);
  }
}

TEST(OpenBag, ReadsTheFilesOfAFolderInTheOrderOfItsMetadata) {
  const test::TemporaryFolder folder;
  run_sql(folder / "x_0.db3", std::string(kTopics) + kMessages + kTwoTopics + insert(3, 1, 1.0));
  run_sql(folder / "x_1.db3", std::string(kTopics) + kMessages +
                                  "INSERT INTO topics VALUES(1, '/c', 't', 'cdr', ''),"
                                  " (2, '/a', 'std_msgs/msg/Float64', 'cdr', '');" +
                                  insert(2, 5, 1.0) + insert(1, 6, 1.0));
  EXPECT_FALSE(is_bag(folder.path()));
  const auto topics_of = [&] {
    const auto bag = open_bag(folder.path());
    std::vector<std::string> names;
    while (const auto message = bag->next()) names.push_back(bag->topics()[message->topic].name);
    return names;
  };
  EXPECT_THAT(topics_of(), testing::ElementsAre("/a", "/a", "/c"));
  const std::string head = "rosbag2_bagfile_information:\n  relative_file_paths:\n";
  const std::string metadata =
      folder.write("metadata.yaml", head + "    - old_folder/x_1.db3\n    - x_0.db3\n");
  EXPECT_TRUE(is_bag(folder.path()));
  EXPECT_THAT(topics_of(), testing::ElementsAre("/a", "/c", "/a"));
  folder.write("metadata.yaml", head + "    - x_1.db3\n    - x_1.db3\n");
  EXPECT_THAT(topics_of, refused_at({.file = metadata, .line = 4}));
  folder.write("metadata.yaml", head + "    - ../../x_9.db3\n");
  EXPECT_THAT(topics_of, refused_at({.file = metadata, .line = 3, .value = "../../x_9.db3"}));
  folder.write("metadata.yaml", head + "    - renamed_0.db3\n    - renamed_1.db3\n");
  EXPECT_THAT(topics_of(), testing::ElementsAre("/a", "/a", "/c"));
}

TEST(OpenBag, FilesOfOtherKindsAreRefused) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.db3.zstd", "a.mcap.zst", "a.db3.lz4"}) {
    const std::string path = folder.write(name, "\x28\xb5\x2f\xfd");
    EXPECT_TRUE(is_bag(path));
    EXPECT_THAT([&] { return open_bag(path)->topics().size(); },
                refused_at({.file = path, .value = testing::StartsWith(".")}));
    std::filesystem::remove(path);
  }
  EXPECT_THAT([&] { return open_bag(folder.path())->topics().size(); }, refused_at({.file = folder.path()}));
  for (const char* text : {"", "#ROSBAG V2.0\n", "time,q0\n"}) {
    const std::string path = folder.write("a.db3", text);
    EXPECT_THAT([&] { return open_bag(path)->topics().size(); }, refused_at({.file = path}));
  }
  EXPECT_THAT([&] { return open_bag(folder / "none.mcap")->topics().size(); },
              refused_at({.file = folder / "none.mcap"}));
}

}  // namespace sqlite_bag_test
}  // namespace armtune::internal
