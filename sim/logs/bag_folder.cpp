#include "sim/logs/bag_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "sim/yaml/placed_value.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMetadata = 4U << 20U;  // [byte]
constexpr std::size_t kMostFiles = 10'000;

bool is_compressed(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".zstd" || ending == ".zst" || ending == ".lz4" || ending == ".gz";
}

/// Returns the number at the end of a file's name, such as 12 for x_12.db3; 0 without one.
std::uint64_t number_of(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t last = stem.find_last_not_of("0123456789");
  const std::string_view digits = std::string_view(stem).substr(last == std::string::npos ? 0 : last + 1);
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

std::vector<fs::path> found_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end && files.size() < kMostFiles;
       at.increment(error)) {
    if (is_bag_file_name(at->path())) files.push_back(at->path());
  }
  if (error) throw InputError(InputPlace{folder.string()}, "cannot be read: " + error.message());
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return std::pair(number_of(a), a) < std::pair(number_of(b), b);
  });
  return files;
}

/// Returns the list of names in metadata.yaml.
const std::vector<yaml::PlacedEntry>& listed_names(const yaml::PlacedValue& document,
                                                   const std::string& file) {
  const yaml::PlacedValue* information = document.find("rosbag2_bagfile_information");
  const yaml::PlacedValue* paths =
      information == nullptr ? nullptr : information->find("relative_file_paths");
  if (paths == nullptr || paths->kind != yaml::PlacedValue::Kind::kSequence) {
    throw InputError(InputPlace{file, 0, "relative_file_paths"},
                     "has no list rosbag2_bagfile_information/relative_file_paths; give a .db3 or .mcap file "
                     "instead of the folder");
  }
  return paths->items;
}

/// Returns the files that metadata.yaml lists. Only their names count: they lie beside it, although old
/// versions of rosbag2 wrote the folder in front. If the files were renamed, but all of them are there, the
/// files that are found take their places.
std::vector<fs::path> listed_files(const fs::path& folder) {
  const std::string file = (folder / kBagMetadata).string();
  const yaml::Placed document = yaml::read_placed(read_input_file(file, kMostMetadata, "a YAML file"), file);
  const std::vector<yaml::PlacedEntry>& names = listed_names(*document, file);
  std::vector<fs::path> files;
  for (const yaml::PlacedEntry& entry : names) {
    const fs::path listed = folder / fs::path(entry.value->text).filename();
    const auto refuse = [&](const std::string& problem) {
      throw InputError(at_line(file, entry.value->line, "relative_file_paths"),
                       InputFault{.problem = problem, .value = entry.value->text});
    };
    std::error_code ignored;
    if (!fs::is_regular_file(listed, ignored)) {
      std::vector<fs::path> found = found_files(folder);
      if (found.size() == names.size()) return found;
      refuse(fmt::format("the folder has no file {}; give the files that are there one by one",
                         shown(listed.filename().string())));
    }
    if (std::find(files.begin(), files.end(), listed) != files.end()) refuse("the file is listed twice");
    if (files.size() >= kMostFiles) refuse("there are too many files");
    files.push_back(listed);
  }
  return files;
}

}  // namespace

bool is_bag_file_name(const fs::path& file) {
  const fs::path name = is_compressed(file) ? file.stem() : file;
  return name.extension() == ".db3" || name.extension() == ".mcap";
}

void refuse_compressed_file(const fs::path& file) {
  if (!is_compressed(file)) return;
  const std::string ending = file.extension().string();
  const std::string_view command = ending == ".lz4" ? "lz4 -d" : ending == ".gz" ? "gunzip -k" : "zstd -d";
  fs::path plain = file;
  plain.replace_extension();
  const std::string target = ending == ".gz" ? "" : (ending == ".lz4" ? " " : " -o ") + shown(plain.string());
  throw InputError(InputPlace{file.string()},
                   InputFault{.problem = fmt::format("is compressed as a whole; decompress it with: {} {}{}",
                                                     command, shown(file.string()), target),
                              .value = ending,
                              .limit = ".db3 or .mcap"});
}

std::vector<fs::path> bag_files(const fs::path& folder) {
  std::error_code ignored;
  const bool is_listed = fs::exists(folder / kBagMetadata, ignored);
  std::vector<fs::path> files = is_listed ? listed_files(folder) : found_files(folder);
  if (files.empty())
    throw InputError(InputPlace{folder.string()},
                     InputFault{.problem = "the folder has no recording", .limit = ".db3 or .mcap files"});
  for (const fs::path& file : files) refuse_compressed_file(file);
  return files;
}

}  // namespace armtune::internal
