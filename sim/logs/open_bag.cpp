#include "sim/logs/open_bag.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "sim/logs/bag_folder.hpp"
#include "sim/logs/mcap_reader.hpp"
#include "sim/logs/sqlite_bag.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

/// Returns the first bytes of a file, or fewer if it is shorter.
std::string first_bytes(const fs::path& path) {
  constexpr std::streamsize kMost = 16;
  std::array<char, kMost> bytes = {};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), kMost);
  return {bytes.data(), static_cast<std::size_t>(file.gcount())};
}

std::unique_ptr<BagReader> open_file(const fs::path& path) {
  using namespace std::string_view_literals;
  std::error_code error;
  const auto refuse = [&path](const std::string& problem) {
    throw InputError(InputPlace{path.string()},
                     InputFault{.problem = problem, .limit = "a .db3 or .mcap file of rosbag2"});
  };
  if (!fs::exists(path, error)) throw InputError(InputPlace{path.string()}, "no such file");
  if (!fs::is_regular_file(path, error)) refuse("is not a regular file");
  refuse_compressed_file(path);
  const std::string begin = first_bytes(path);
  if (begin.starts_with("SQLite format 3\0"sv)) return open_sqlite_bag(path);
  if (begin.starts_with("\x89MCAP"sv)) return open_mcap(path);
  if (begin.starts_with("#ROSBAG"sv))
    refuse("is a bag of ROS 1; convert it with: rosbags-convert --src " + shown(path.string()) +
           " --dst FOLDER");
  refuse(begin.empty() ? "is empty or cannot be read" : "is not a bag");
  return nullptr;
}

/// Reads the files of one recording, one after another. Only one is open at a time.
class BagSequence : public BagReader {
 public:
  explicit BagSequence(std::vector<fs::path> files) : files_(std::move(files)) { open_next(); }

  const std::vector<BagTopic>& topics() const override { return topics_; }

  std::optional<BagMessage> next() override {
    while (current_) {
      std::optional<BagMessage> message = current_->next();
      add_topics();
      if (message) {
        message->topic = indices_[message->topic];
        return message;
      }
      open_next();
    }
    return std::nullopt;
  }

  bool unfinished() const override { return unfinished_ || (current_ && current_->unfinished()); }

 private:
  void open_next() {
    unfinished_ = unfinished();
    current_.reset();
    indices_.clear();
    if (next_file_ == files_.size()) return;
    current_ = open_file(files_[next_file_++]);
    add_topics();
  }

  /// Numbers the topics of the current file that have no number yet. One topic can be in several files.
  void add_topics() {
    const std::vector<BagTopic>& own = current_->topics();
    for (std::size_t i = indices_.size(); i < own.size(); ++i) {
      const auto key = std::tuple(own[i].name, own[i].type, own[i].encoding, own[i].schema);
      const auto [known, is_new] = known_.try_emplace(key, topics_.size());
      if (is_new) topics_.push_back(own[i]);
      indices_.push_back(known->second);
    }
  }

  std::vector<fs::path> files_;
  std::size_t next_file_ = 0;
  bool unfinished_ = false;  // true if a file before the current one was
  std::unique_ptr<BagReader> current_;
  std::vector<std::size_t> indices_;  // in topics_, of the topics of the current file
  std::vector<BagTopic> topics_;
  std::map<std::tuple<std::string, std::string, std::string, std::string>, std::size_t> known_;
};

}  // namespace

bool is_bag(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return fs::exists(path / kBagMetadata, ignored);
  return is_bag_file_name(path);
}

std::unique_ptr<BagReader> open_bag(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return std::make_unique<BagSequence>(bag_files(path));
  return open_file(path);
}

}  // namespace armtune::internal
