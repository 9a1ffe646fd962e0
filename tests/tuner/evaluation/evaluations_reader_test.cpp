#include "tuner/evaluation/evaluations_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/evaluation/evaluations_file.hpp"

namespace armtune::internal {
namespace evaluations_reader_test {

using test::refused_at;

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
      e.reason = "diverged at 3 s in followTrajectory: a, \"b\"";
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
  const auto read = [this](const std::string& path) {
    return test::input_error([&] { read_evaluations(CsvTable::read(path), study_); });
  };
  EXPECT_THAT(read(files_ / "none.csv"), refused_at({.file = files_ / "none.csv", .line = 0}));
  const std::string other = files_.write("other.csv", "evaluation,objective,violation\n0,1,0\n");
  EXPECT_THAT(read(other), refused_at({.file = other,
                                       .line = 1,
                                       .key = "task_space_gains_p/rx",
                                       .limit = "a column 'task_space_gains_p/rx'"}));
  std::string text = test::read_text(written());
  const std::string torn = files_.write("torn.csv", text.substr(0, text.rfind(',')));
  EXPECT_EQ(read_evaluations(CsvTable::read(torn), study_).size(), 2U)
      << "killed while it wrote the third row";
  const std::string cut = files_.write("cut.csv", text.substr(0, text.rfind(',')) + "\n");
  EXPECT_THAT(read(cut), refused_at({.file = cut, .line = 4}));
  text.replace(text.find("\n0,search,simbody,1,") + 18, 1, "x");
  const std::string wrong = files_.write("wrong.csv", text);
  EXPECT_THAT(read(wrong), refused_at({.file = wrong, .line = 2, .key = "objective", .value = "x"}));
}

}  // namespace evaluations_reader_test
}  // namespace armtune::internal
