#include "tuner/evaluation/evaluations_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/evaluation/evaluations_file.hpp"

namespace armtune::internal {
namespace evaluations_reader_test {

using testing::HasSubstr;

class EvaluationsReader : public ::testing::Test {
 protected:
  /// A journal of three points; results do not matter here.
  std::string written() {
    EvaluationsFile journal(files_ / "evaluations.csv", study_);
    for (const double x : {0.0, 0.3, 1.0}) {
      Evaluation e;
      e.x = {x, 1.0 - x};
      e.gains = study_.space.gains_at(e.x);
      e.objective = 1.0 + x;
      e.violation = 2.0 * x;
      e.status = "diverged at 3 s in followTrajectory: a, \"b\"";
      e.results.resize(study_.scenarios.size());
      journal.append("search", e);
    }
    return files_ / "evaluations.csv";
  }
  test::ShortStudy files_;
  Study study_ = load_study(files_.path());
};

TEST_F(EvaluationsReader, GivesBackWhatWasWritten) {
  const auto rows = read_evaluations(CsvTable::read(written()), study_);
  ASSERT_EQ(rows.size(), 3U);
  const double expected[] = {0.0, 0.3, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(rows[i].x[0], expected[i], 1e-12);
    EXPECT_NEAR(rows[i].x[1], 1.0 - expected[i], 1e-12);
    EXPECT_EQ(rows[i].objective, 1.0 + expected[i]);
    EXPECT_EQ(rows[i].violation, 2.0 * expected[i]);
  }
}

TEST_F(EvaluationsReader, RefusesWhatIsNoneOfItsStudy) {
  EXPECT_THAT(test::refusal([&] { read_evaluations(CsvTable::read(files_ / "none.csv"), study_); }),
              HasSubstr("none.csv: no such file"));
  const std::string other = files_.write("other.csv", "evaluation,objective,violation\n0,1,0\n");
  EXPECT_THAT(test::refusal([&] { read_evaluations(CsvTable::read(other), study_); }),
              testing::AllOf(HasSubstr("no column 'task_space_gains_p/rx'")));
  std::string text = test::read_text(written());
  const std::string torn = files_.write("torn.csv", text.substr(0, text.rfind(',')));
  EXPECT_EQ(read_evaluations(CsvTable::read(torn), study_).size(), 2U)
      << "killed while it wrote the third row";
  const std::string cut = files_.write("cut.csv", text.substr(0, text.rfind(',')) + "\n");
  EXPECT_THAT(test::refusal([&] { read_evaluations(CsvTable::read(cut), study_); }),
              HasSubstr("cut.csv:4: "));
  text.replace(text.find("\n0,search,simbody,1,") + 18, 1, "x");
  const std::string wrong = files_.write("wrong.csv", text);
  EXPECT_THAT(test::refusal([&] { read_evaluations(CsvTable::read(wrong), study_); }),
              HasSubstr("wrong.csv:2: 'x' in column objective is not a number"));
}

}  // namespace evaluations_reader_test
}  // namespace armtune::internal
