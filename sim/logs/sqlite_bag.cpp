#include "sim/logs/sqlite_bag.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/common/message_text.hpp"
#include "core/common/utf8.hpp"
#include "sim/logs/message_definition.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostTopics = 10'000;
constexpr int kLargestMessage = 256 << 20;  // [byte]
constexpr int kLongestSql = 1 << 20;        // [byte]
constexpr int kDeepestExpression = 100;
constexpr int kOperations = 100'000;  // of SQLite's virtual machine between two calls of count_operations
constexpr int kMostCalls = 100;       // of count_operations for one row: more than any real file needs
/// A row of a table takes at least this many bytes in the file: its cell in a page, and the pointer to it.
constexpr std::uint64_t kLeastRow = 6;

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
struct Finalize {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;
using Statement = std::unique_ptr<sqlite3_stmt, Finalize>;

/// Returns the path as a URI that makes SQLite take no lock and look for no journal (sqlite.org/uri.html).
std::string uri_of(const fs::path& path) {
  std::string uri = "file:";
  for (const char c : absolute_path(path.string())) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          c == '/' || c == '.' || c == '_' || c == '-';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri + "?mode=ro&immutable=1";
}

/// A database that may come from a stranger. Every error becomes an InputError with the path.
class UntrustedDatabase {
 public:
  explicit UntrustedDatabase(const fs::path& path) : file_(path.string()) {
    check_file(path);
    sqlite3* opened = nullptr;
    const int status = sqlite3_open_v2(uri_of(path).c_str(), &opened,
                                       SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
    database_.reset(opened);
    if (status != SQLITE_OK) refuse("cannot be opened as an SQLite database");
    restrict();
  }

  /// Returns the statement; null if `sql` names a table or column that is not there.
  Statement prepare(const char* sql) {
    calls_ = 0;
    sqlite3_stmt* statement = nullptr;
    const int status = sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr);
    Statement prepared(statement);
    if (status != SQLITE_OK && status != SQLITE_ERROR) refuse_damage();
    return prepared;
  }

  /// Moves to the next row; false at the end.
  bool step(sqlite3_stmt* statement) {
    calls_ = 0;
    const int status = sqlite3_step(statement);
    if (status != SQLITE_ROW && status != SQLITE_DONE) refuse_damage();
    return status == SQLITE_ROW;
  }

  /// True if `name` is a table with rows of its own: a view could compute rows without end.
  bool has_table(const char* name) {
    const Statement found =
        prepare("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?1 AND rootpage > 0");
    if (!found) return false;
    sqlite3_bind_text(found.get(), 1, name, -1, SQLITE_STATIC);
    return step(found.get());
  }

  [[noreturn]] void refuse(const std::string& problem) const {
    throw InputError(InputPlace{file_},
                     InputFault{.problem = problem, .limit = "a rosbag2 recording (.db3)"});
  }

 private:
  void check_file(const fs::path& path) const {
    std::error_code error;
    if (!fs::exists(path, error)) throw InputError(InputPlace{file_}, "no such file");
    if (!fs::is_regular_file(path, error)) refuse("is not a regular file");
    const auto log = fs::file_size(file_ + "-wal", error);
    if (!error && log > 0) {
      throw InputError(InputPlace{file_},
                       InputFault{.problem = fmt::format(
                                      "has a write-ahead log beside it, because its recorder was "
                                      "killed; merge it with: sqlite3 {} 'PRAGMA wal_checkpoint(TRUNCATE)'",
                                      shown(file_))});
    }
  }

  void restrict() {
    sqlite3* database = database_.get();
    sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_limit(database, SQLITE_LIMIT_LENGTH, kLargestMessage);
    sqlite3_limit(database, SQLITE_LIMIT_SQL_LENGTH, kLongestSql);
    sqlite3_limit(database, SQLITE_LIMIT_EXPR_DEPTH, kDeepestExpression);
    sqlite3_limit(database, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_progress_handler(database, kOperations, &count_operations, this);
    for (const char* pragma : {"PRAGMA cell_size_check = 1", "PRAGMA mmap_size = 0", "PRAGMA temp_store = 1",
                               "PRAGMA cache_size = -16384"})
      sqlite3_exec(database, pragma, nullptr, nullptr, nullptr);
  }

  [[noreturn]] void refuse_damage() const {
    throw InputError(
        InputPlace{file_},
        InputFault{
            .problem = fmt::format("is not an intact SQLite database: {}", sqlite3_errmsg(database_.get())),
            .limit = "a rosbag2 recording (.db3); 'sqlite3 FILE .recover' can save parts"});
  }

  static int count_operations(void* self) {
    return ++static_cast<UntrustedDatabase*>(self)->calls_ > kMostCalls ? 1 : 0;
  }

  std::string file_;
  Database database_;
  int calls_ = 0;
};

std::string text_of(sqlite3_stmt* statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));  // UTF-8
  return text == nullptr
             ? std::string()
             : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement, column)));
}

class SqliteBag : public BagReader {
 public:
  explicit SqliteBag(const fs::path& path) : database_(path), bytes_left_(fs::file_size(path)) {
    for (const char* table : {"topics", "messages"}) {
      if (!database_.has_table(table)) database_.refuse(fmt::format("has no table '{}'", table));
    }
    read_topics();
    read_schemas();
    messages_ = database_.prepare("SELECT topic_id, timestamp, data FROM messages NOT INDEXED");
    if (!messages_) database_.refuse("has no columns topic_id, timestamp and data in its table 'messages'");
  }

  const std::vector<BagTopic>& topics() const override { return topics_; }

  std::optional<BagMessage> next() override {
    sqlite3_stmt* row = messages_.get();
    if (row == nullptr || !database_.step(row)) {
      messages_.reset();
      return std::nullopt;
    }
    const auto* data = static_cast<const std::byte*>(sqlite3_column_blob(row, 2));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row, 2));
    // Pages that refer to each other in a circle would make messages without end.
    if (size + kLeastRow > bytes_left_)
      database_.refuse("gives more bytes of messages than it has, so it is damaged");
    bytes_left_ -= size + kLeastRow;
    const auto topic = indices_.find(sqlite3_column_int64(row, 0));
    if (topic == indices_.end())
      database_.refuse(fmt::format("has a message of the unknown topic {}", sqlite3_column_int64(row, 0)));
    return BagMessage{topic->second, sqlite3_column_int64(row, 1), {data, size}};
  }

 private:
  void read_topics() {
    const Statement rows = database_.prepare("SELECT id, name, type, serialization_format FROM topics");
    if (!rows)
      database_.refuse("has no columns id, name, type and serialization_format in its table 'topics'");
    while (database_.step(rows.get())) {
      BagTopic topic{text_of(rows.get(), 1), text_of(rows.get(), 2), text_of(rows.get(), 3), {}, {}};
      if (topics_.size() >= kMostTopics)
        database_.refuse(fmt::format("has more than {} topics", kMostTopics));
      if (topic.name.empty() || topic.name.size() > kLongestName || !is_printable(topic.name) ||
          topic.type.size() > kLongestName)
        database_.refuse(fmt::format("has a topic with the name {}, which is not valid", shown(topic.name)));
      if (!indices_.emplace(sqlite3_column_int64(rows.get(), 0), topics_.size()).second)
        database_.refuse("has two topics with the same id");
      topics_.push_back(std::move(topic));
    }
  }

  /// Files of Iron and later have the definitions of their types.
  void read_schemas() {
    if (!database_.has_table("message_definitions")) return;
    const Statement rows =
        database_.prepare("SELECT topic_type, encoding, encoded_message_definition FROM message_definitions");
    while (rows && database_.step(rows.get())) {
      const std::string type = text_of(rows.get(), 0);
      const std::string encoding = text_of(rows.get(), 1);
      if (static_cast<std::size_t>(sqlite3_column_bytes(rows.get(), 2)) > kMostDefinitionBytes)
        database_.refuse("has a message definition that is too long");
      for (BagTopic& topic : topics_) {
        if (topic.type != type || !topic.schema.empty()) continue;
        topic.schema = text_of(rows.get(), 2);
        topic.schema_encoding = topic.schema.empty() ? std::string() : encoding;
        schema_bytes_ += topic.schema.size();
        if (schema_bytes_ > kMostSchemaBytes) database_.refuse("has message definitions that are too long");
      }
    }
  }

  static constexpr std::size_t kLongestName = 1024;            // of a topic or type [byte]
  static constexpr std::size_t kMostSchemaBytes = 64U << 20U;  // of all topics

  UntrustedDatabase database_;
  std::uint64_t bytes_left_;
  std::size_t schema_bytes_ = 0;
  std::vector<BagTopic> topics_;
  std::map<std::int64_t, std::size_t> indices_;  // in topics_, by the id in the database
  Statement messages_;
};

}  // namespace

std::unique_ptr<BagReader> open_sqlite_bag(const fs::path& path) {
  return std::make_unique<SqliteBag>(path);
}

}  // namespace armtune::internal
