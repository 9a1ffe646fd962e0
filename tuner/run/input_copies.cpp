#include "tuner/run/input_copies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/common/file_path.hpp"
#include "core/common/input_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

/// Returns a file's name with '_' for characters that some file systems refuse. A long name keeps only its
/// end.
std::string plain_name(const std::string& path) {
  constexpr std::size_t kLongest = 100;
  std::string name = fs::path(path).filename().string();
  if (name.size() > kLongest) name.erase(0, name.size() - kLongest);
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
  };
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return !is_plain(c); }, '_');
  return name;
}

/// Returns the names of the complete copies, sorted.
std::set<std::string> copies_in(const std::string& folder) {
  std::set<std::string> names;
  std::error_code none;
  const fs::path copies = fs::path(folder) / kInputCopies;
  if (fs::symlink_status(copies, none).type() != fs::file_type::directory) return names;
  const std::string partial = partial_path("");
  for (fs::directory_iterator file(copies, none), end; !none && file != end; file.increment(none)) {
    const std::string name = file->path().filename().string();
    std::error_code gone;
    if (file->symlink_status(gone).type() == fs::file_type::regular && !name.ends_with(partial))
      names.insert(name);
  }
  return names;
}

bool lies_in(const std::string& path, const std::string& folder) {
  const fs::path inner = absolute_path(path);
  const fs::path outer = absolute_path(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

std::string copy_path(const std::string& folder, const std::string& name) {
  return fmt::format("{}/{}/{}", folder, kInputCopies, name);
}

/// Returns true if `keep_inputs` gives names of this form to copies of a file with this plain name.
bool is_numbered(const std::string& name, const std::string& plain) {
  const std::size_t digits = name.find_first_not_of("0123456789");
  return digits != 0 && digits != std::string::npos && name.substr(digits) == "_" + plain;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> keep_inputs(const std::string& folder,
                                                             const std::vector<std::string>& inputs) {
  std::vector<std::pair<std::string, std::string>> copies;
  const std::set<std::string> there = copies_in(folder);
  std::set<std::string> taken;  // each copy is of one input
  for (const std::string& file : std::set<std::string>(inputs.begin(), inputs.end())) {
    const auto bytes = recorded_input(file);
    if (!bytes || lies_in(file, folder)) continue;
    const std::string plain = plain_name(file);
    const auto found = std::find_if(there.begin(), there.end(), [&](const std::string& name) {
      return is_numbered(name, plain) && taken.count(name) == 0 &&
             hash_of_file(copy_path(folder, name)) == hash_of_input(file);
    });
    std::string name = found == there.end() ? std::string() : *found;
    for (std::size_t number = copies.size() + 1; name.empty(); ++number) {
      const std::string free = fmt::format("{:02}_{}", number, plain);
      if (there.count(free) == 0 && taken.count(free) == 0) name = free;
    }
    if (found == there.end()) {
      make_folder(folder + "/" + kInputCopies);
      write_text_file(copy_path(folder, name), *bytes);
    }
    taken.insert(name);
    copies.emplace_back(shown_path(file), fmt::format("{}/{}", kInputCopies, name));
  }
  return copies;
}

std::optional<std::string> copy_of_hash(const std::string& folder, const std::string& hash) {
  for (const std::string& name : copies_in(folder)) {
    if (hash_of_file(copy_path(folder, name)) == hash) return copy_path(folder, name);
  }
  return std::nullopt;
}

std::string where_copies_are(const std::string& folder) {
  if (copies_in(folder).empty()) return {};
  return fmt::format(" (copies of the files that the run read are in {}/{})", folder, kInputCopies);
}

}  // namespace armtune::internal
