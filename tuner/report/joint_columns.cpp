#include "tuner/report/joint_columns.hpp"

namespace armtune::internal::report {

std::vector<std::string> joints_with(const NumberTable& table, std::string_view ending) {
  constexpr std::size_t kMostJoints = 64;
  constexpr std::string_view kBegin = "joint/";
  std::vector<std::string> joints;
  for (const std::string& column : table.header()) {
    if (joints.size() == kMostJoints) break;
    if (column.size() > kBegin.size() + ending.size() && column.starts_with(kBegin) &&
        column.ends_with(ending))
      joints.push_back(column.substr(kBegin.size(), column.size() - kBegin.size() - ending.size()));
  }
  return joints;
}

}  // namespace armtune::internal::report
