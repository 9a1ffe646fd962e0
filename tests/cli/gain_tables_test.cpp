#include "tuner/cli/gain_tables.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace gain_tables_test {

const std::string kLongName = "task_space_gains_d/" + std::string(24, 'j');

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Returns the width of the lines, which have to be equally wide, each with a blank behind its name.
std::size_t width_of(const std::vector<std::string>& lines, const std::vector<std::string>& names) {
  EXPECT_EQ(lines.size(), names.size() + 1);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(lines.at(i + 1).size(), lines[0].size()) << lines[i + 1];
    EXPECT_TRUE(lines.at(i + 1).starts_with(names[i] + " ")) << lines[i + 1];
  }
  return lines[0].size();
}

TEST(GainTables, TheColumnOfNamesIsAsWideAsTheLongestName) {
  const test::ShortStudy files;
  Study study = load_study(files.path());
  ASSERT_EQ(study.space.free.size(), 2U);
  TuneResult result;
  result.best.gains = study.space.start;
  Sensitivity sensitivity;
  sensitivity.parameters.resize(2);
  sensitivity.parameters[0].parameter = 1;
  const auto name = [&study](std::size_t i) -> std::string& { return study.space.free[i].entry.name; };
  const auto gains = [&] { return width_of(lines_of(cli::gains_table(study, result)), {name(0), name(1)}); };
  const auto effects = [&] {
    return width_of(lines_of(cli::sensitivity_table(study, sensitivity, 2)), {name(1), name(0)});
  };
  const std::size_t narrow_gains = gains();
  const std::size_t narrow_effects = effects();
  const std::size_t more = kLongName.size() - 38;
  name(0) = kLongName;
  EXPECT_EQ(gains(), narrow_gains + more);
  EXPECT_EQ(effects(), narrow_effects + more);
  // A name that is not shown takes no room.
  EXPECT_EQ(width_of(lines_of(cli::sensitivity_table(study, sensitivity, 1)), {name(1)}), narrow_effects);
}

}  // namespace gain_tables_test
}  // namespace armtune::internal
