// The keys of a study that switch its final phase.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace final_phase_keys_test {

using test::refused_at;
using test::ShortStudy;

/// The first key of the search is in line 11 of the study.
ShortStudy with_search(const std::string& keys) {
  return ShortStudy(test::kShortParameters, test::kShortObjective, "", "search:\n  " + keys + "\n");
}

InputError final_refusal(const std::string& keys) {
  const ShortStudy files = with_search(keys);
  return test::input_error([&] { load_study(files.path()); });
}

TEST(FinalPhaseKeys, AreReadBackFromTheResolvedStudyAndLeaveOthersAsTheyWere) {
  const ShortStudy files = with_search("final_phase: minimax\n  final_share: 0.25");
  const Study study = load_study(files.path());
  EXPECT_TRUE(study.final_phase);
  EXPECT_EQ(study.final_share, 0.25);
  const Study again = load_study(files.write("resolved.yaml", study_yaml(study, "gains.yaml")));
  EXPECT_TRUE(again.final_phase);
  EXPECT_EQ(again.final_share, 0.25);

  for (const char* keys : {"seed: 1", "final_phase: none"}) {
    const ShortStudy plain = with_search(keys);
    EXPECT_FALSE(load_study(plain.path()).final_phase) << keys;
    EXPECT_THAT(study_yaml(load_study(plain.path()), "gains.yaml"),
                testing::Not(testing::HasSubstr("final_")));
  }
}

TEST(FinalPhaseKeys, ThatDoNotFitAreRefused) {
  EXPECT_THAT(
      final_refusal("final_phase: epigraph"),
      refused_at(
          {.line = 11, .key = "search/final_phase", .value = "epigraph", .limit = "one of: none, minimax"}));
  EXPECT_THAT(final_refusal("final_phase: minimax\n  final_share: 1.5"),
              refused_at({.line = 12, .key = "search/final_share", .value = "1.5", .limit = "0 to 1"}));
  EXPECT_THAT(final_refusal("final_share: 0.5"),
              refused_at({.line = 11, .key = "search/final_share", .value = "0.5"}));
  EXPECT_THAT(final_refusal("final_phase: minimax\n  stepper: reference"),
              refused_at({.line = 11, .key = "search/final_phase", .value = "minimax", .limit = "none"}));
}

TEST(FinalPhaseKeys, AnObjectiveOfOnesOwnHasNoMetricsToModel) {
  const ShortStudy files = with_search("final_phase: minimax");
  StudyParts parts;
  parts.objective = [](const std::vector<RolloutResult>&) { return 1.0; };
  EXPECT_THAT(test::input_error([&] { load_study(files.path(), {}, parts); }),
              refused_at({.key = "search/final_phase", .value = "minimax"}));
}

}  // namespace final_phase_keys_test
}  // namespace armtune::internal
