#include "tuner/cli/set_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "armtune/error.hpp"
#include "core/common/file_name.hpp"
#include "core/common/file_path.hpp"
#include "sim/scenario/data_files.hpp"

namespace armtune::internal::cli {
namespace {

/// The columns of comparison.csv other than those of the gain sets.
constexpr std::array<std::string_view, 3> kOtherColumns = {"scenario", "metric", "unit"};

std::string name_of(const std::string& set) {
  std::error_code none;
  std::filesystem::path path = without_dots(std::filesystem::absolute(set, none).string());  // resolves "."
  if (none) path = set;
  if (path.filename() == "..") {  // after a symbolic link
    path = std::filesystem::canonical(path, none);
    if (none) path = set;
  }
  if (!path.has_filename()) path = path.parent_path();  // such as "folder//"
  std::string name = path.has_extension() ? stem(path.string()) : path.filename().string();
  std::replace(name.begin(), name.end(), ',', '_');
  return name;
}

}  // namespace

std::vector<std::string> set_labels(const std::vector<std::string>& sets) {
  std::vector<std::string> labels;
  for (const std::string& set : sets) {
    const std::string name = name_of(set);
    std::string label = name;
    const auto is_taken = [&] {
      return std::find(labels.begin(), labels.end(), label) != labels.end() ||
             std::find(kOtherColumns.begin(), kOtherColumns.end(), label) != kOtherColumns.end();
    };
    for (int number = 2; is_taken(); ++number) label = name + "_" + std::to_string(number);
    labels.push_back(std::move(label));
  }
  return labels;
}

void check_labels(const std::vector<std::string>& labels, const std::vector<std::string>& sets) {
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::string name = name_of(sets[i]);
    check_result_name(name, sets[i]);
    if (labels[i].size() <= kLongestName) continue;
    throw InputError(fmt::format(
        "{}: another gain set has the same name, so '{}' is added to tell them apart. The name is "
        "then too long for a file; rename the gain set to a name of at most {} bytes",
        sets[i], labels[i].substr(name.size()), kLongestName - (labels[i].size() - name.size())));
  }
}

}  // namespace armtune::internal::cli
