#include "tuner/sensitivity/sensitivity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/read_back.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/search/tune.hpp"
#include "tuner/sensitivity/merits.hpp"

namespace armtune::internal {
namespace sensitivity_test {

using testing::Contains;
using testing::HasSubstr;

const std::atomic<bool> kNever{false};

TEST(RankCorrelation, IsOneForWhatRisesTogetherHoweverCurved) {
  std::vector<double> x;
  std::vector<double> up;
  std::vector<double> down;
  for (int i = 0; i < 20; ++i) {
    x.push_back(i * 0.3);
    up.push_back(std::exp(x.back()));
    down.push_back(-std::pow(x.back(), 3));
  }
  EXPECT_DOUBLE_EQ(rank_correlation(x, up), 1.0);
  EXPECT_DOUBLE_EQ(rank_correlation(x, down), -1.0);
  EXPECT_TRUE(std::isnan(rank_correlation(x, std::vector<double>(20, 4.0)))) << "never moved";
  EXPECT_TRUE(std::isnan(rank_correlation({1, 2}, {1, 2})));
}

TEST(RankCorrelation, WithoutTiesIsSpearmansFormula) {
  const std::vector<double> a = {1, 2, 3, 4, 5};
  const std::vector<double> b = {2, 1, 4, 3, 5};
  EXPECT_DOUBLE_EQ(rank_correlation(a, b), 1.0 - 6.0 * 4.0 / (5.0 * 24.0));
  EXPECT_DOUBLE_EQ(rank_correlation({1, 1, 2}, {1, 1, 2}), 1.0) << "ties at their mean rank";
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  std::vector<double> x(4000);
  std::vector<double> y(4000);
  for (double& v : x) v = normal(generator);
  for (double& v : y) v = normal(generator);
  EXPECT_NEAR(rank_correlation(x, y), 0.0, 4.0 / std::sqrt(4000.0));
}

/// Two gains that matter and one that acts only where there are obstacles.
class Sensitive : public ::testing::Test {
 protected:
  void SetUp() override {
    files_.emplace(
        "parameters:\n"
        "  - {name: task_space_gains_p/rx, lower: 10, upper: 60}\n"
        "  - {name: task_space_gains_p/x, lower: 20, upper: 120, scale: linear}\n"
        "  - {name: obstacleInfluenceRadius, lower: 0.1, upper: 1}\n",
        test::kShortObjective, "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 2}\n");
    study_.emplace(load_study(files_->path()));
    workers_.emplace(study_->scenarios, study_->stepper, 2);
    best_ = study_->space.start;
    best_.task_space_gains_p[0] = 110.0;
    best_.task_space_gains_p[3] = 60.0;  // its upper bound
    const std::vector<Gains> starts = {study_->space.start};
    const auto results = workers_->run(starts, kNever);
    objective_.emplace(study_->terms, study_->constraints, study_->scenarios, (*results)[0], "test");
  }
  Sensitivity of(const std::vector<EvaluationRow>& journal = {}) {
    return *sensitivity(*study_, *objective_, best_, journal, *workers_, kNever);
  }
  double merit(const Gains& gains) {
    const std::vector<Gains> candidates = {gains};
    Evaluation e;
    e.results = (*workers_->run(candidates, kNever))[0];
    objective_->judge(e);
    return e.objective + study_->solver.penalty * e.violation;
  }
  static const ParameterSensitivity& find(const Sensitivity& s, std::size_t parameter) {
    return *std::find_if(s.parameters.begin(), s.parameters.end(),
                         [&](const ParameterSensitivity& p) { return p.parameter == parameter; });
  }

  std::optional<test::ShortStudy> files_;
  std::optional<Study> study_;
  std::optional<CandidateRunner> workers_;
  std::optional<Objective> objective_;
  Gains best_;
};

TEST_F(Sensitive, IsWhatRolloutsOfChangedGainsSay) {
  const Sensitivity s = of();
  EXPECT_DOUBLE_EQ(s.merit, merit(best_));
  // Linear scale, 20 .. 120: a fiftieth of the range is 2.
  Gains low = best_;
  Gains high = best_;
  low.task_space_gains_p[0] -= 2.0;
  high.task_space_gains_p[0] += 2.0;
  const double m_low = merit(low);
  const double m_high = merit(high);
  const ParameterSensitivity& px = find(s, 1);
  EXPECT_NEAR(px.elasticity, (m_high - m_low) / s.merit / (4.0 / 110.0),
              1e-6 * std::abs(px.elasticity) + 1e-9);
  EXPECT_NEAR(px.local, std::max(std::abs(m_high - s.merit), std::abs(m_low - s.merit)) / s.merit, 1e-9);
  Gains reset = best_;
  reset.task_space_gains_p[0] = study_->space.start.task_space_gains_p[0];
  EXPECT_NEAR(px.importance, merit(reset) - s.merit, 1e-12);
  for (std::size_t i = 1; i < s.parameters.size(); ++i) {
    EXPECT_GE(s.parameters[i - 1].importance, s.parameters[i].importance);
  }
}

void expect_same(const Sensitivity& a, const Sensitivity& b, double tolerance) {
  const auto near = [tolerance](double x, double y) { EXPECT_NEAR(x, y, tolerance * (1.0 + std::abs(y))); };
  near(a.merit, b.merit);
  ASSERT_EQ(a.parameters.size(), b.parameters.size());
  for (std::size_t i = 0; i < a.parameters.size(); ++i) {
    EXPECT_EQ(a.parameters[i].parameter, b.parameters[i].parameter);
    near(a.parameters[i].local, b.parameters[i].local);
    near(a.parameters[i].importance, b.parameters[i].importance);
    near(a.parameters[i].elasticity, b.parameters[i].elasticity);
  }
}

TEST_F(Sensitive, AnotherEngineFindsTheSameAndSimbodyConfirmsIt) {
  const Sensitivity judged = of();
  const long done = workers_->rollouts_done();
  study_->engine = Engine::kNative;
  const Sensitivity found = of();
  // 10 points, and of these the best and the most important way back once more, in both scenarios.
  EXPECT_EQ(workers_->rollouts_done() - done, 2 * (10 + 2));
  expect_same(found, judged, 1e-6);
  EXPECT_EQ(found.merit, judged.merit) << "Simbody's own";
  EXPECT_EQ(found.parameters[0].importance, judged.parameters[0].importance) << "Simbody's own";
}

TEST_F(Sensitive, SimbodyLooksAtTheMostImportantFirst) {
  const Merits::Progress nobody;
  Merits merits(*study_, *objective_, *workers_, kNever, nobody);
  const std::vector<double> best = study_->space.point_of(best_);
  std::vector<std::vector<double>> points(10, best);
  for (std::size_t i = 0; i < 3; ++i) points[points_of(i).reset][0] -= i == 1 ? 0.8 : 0.3;
  const std::vector<double> judged = *merits.of(points, Engine::kSimbody);
  const std::size_t most = points_of(1).reset;
  ASSERT_GT(judged[most], judged[points_of(0).reset]);
  ASSERT_GT(judged[most], judged[points_of(2).reset]);
  std::vector<double> found = judged;
  for (double& merit : found) merit *= 1.0 + 1e-9;  // as another engine might, but to be told apart
  const auto confirmed = merits.confirmed(points, found, 1);
  ASSERT_TRUE(confirmed);
  for (std::size_t p = 0; p < points.size(); ++p) {
    EXPECT_EQ((*confirmed)[p], p == 0 || p == most ? judged[p] : found[p]) << p;
  }
}

TEST_F(Sensitive, WhereSimbodyDoesNotConfirmThemAllAreItsOwn) {
  // Chattering between the torque limits, what differs in the last bit soon differs in the first.
  best_.task_space_gains_p[0] = 120.0;
  best_.task_space_gains_d *= 40.0;
  study_->space.start.task_space_gains_d = best_.task_space_gains_d;
  const Sensitivity judged = of();
  study_->engine = Engine::kNative;
  const long done = workers_->rollouts_done();
  expect_same(of(), judged, 0.0);
  EXPECT_EQ(workers_->rollouts_done() - done, 2 * (10 + 2 + 10)) << "the engines agree here: no test of this";
}

TEST_F(Sensitive, NamesGainsWithoutEffectAndBoundsThatWereHit) {
  const auto lines = advice(*study_, of());
  EXPECT_THAT(lines, Contains(testing::AllOf(HasSubstr("obstacleInfluenceRadius has no effect"),
                                             HasSubstr("fixed: "))));
  EXPECT_THAT(lines, Contains(HasSubstr("task_space_gains_p/rx ended at its upper bound 60")));
  EXPECT_EQ(lines.size(), 2U) << testing::PrintToString(lines);
}

TEST_F(Sensitive, TheReducedStudyTunesTheMoreImportantHalf) {
  const Sensitivity s = of();
  const Study reduced = without_less_important_half(*study_, s);
  ASSERT_EQ(reduced.space.free.size(), 2U);
  for (const Parameter& p : reduced.space.free) EXPECT_NE(p.entry.name, "obstacleInfluenceRadius");
  files_->write("reduced.yaml", study_yaml(reduced, "gains.yaml"));
  const Study again = load_study(*files_ / "reduced.yaml");
  EXPECT_EQ(again.space.free.size(), 2U);
  EXPECT_EQ(again.space.start.task_space_gains_p, study_->space.start.task_space_gains_p);
}

TEST_F(Sensitive, TheGlobalPartIsTheJournalsRankCorrelation) {
  std::vector<EvaluationRow> journal;
  for (int i = 0; i < 10; ++i) journal.push_back({{0.1 * i, 0.5, 1.0 - 0.1 * i}, 0.1 * i, 0.0});
  const Sensitivity s = of(journal);
  EXPECT_DOUBLE_EQ(find(s, 0).rank_correlation, 1.0);
  EXPECT_TRUE(std::isnan(find(s, 1).rank_correlation));
  EXPECT_DOUBLE_EQ(find(s, 2).rank_correlation, -1.0);
  const test::Csv csv(sensitivity_csv(*study_, s));
  EXPECT_EQ(csv.rows.size(), 3U);
  EXPECT_EQ(std::stod(csv.at(0, "importance")), s.parameters[0].importance);
}

TEST(SensitivityCsv, ReadsBackToTheBitAndIsEmptyWithAStatusThatSaysWhy) {
  const test::ShortStudy files;
  Study study = load_study(files.path());
  ASSERT_EQ(study.space.free.size(), 2U);
  study.space.free[0].start = 1.0 / 3.0;
  study.space.free[1].lower = 5e-324;
  study.space.free[1].upper = 1e300;
  Sensitivity s;
  s.parameters.push_back({1, 0.1 + 0.2, 1.0 / 3.0, -0.0, -1e-300, 5e-324});
  s.parameters.push_back({0, 0.0, INFINITY, NAN, -INFINITY, NAN});
  s.parameters.push_back({0, 1.0, 1e300, NAN, 0.5, 2.0});
  test::ReadBack read(sensitivity_csv(study, s));
  for (std::size_t row = 0; row < s.parameters.size(); ++row) {
    const ParameterSensitivity& found = s.parameters[row];
    const Parameter& p = study.space.free[found.parameter];
    read.text(row, "gain", p.entry.name);
    read.text(row, "unit", p.entry.field->unit);
    read.number(row, "start", p.start);
    read.number(row, "best", found.best);
    read.number(row, "lower", p.lower);
    read.number(row, "upper", p.upper);
    read.number(row, "importance", found.importance);
    read.number(row, "local", found.local);
    read.number(row, "elasticity", found.elasticity);
    read.number(row, "rank_correlation", found.rank_correlation);
  }
  read.text(0, "status", "complete");
  read.text(1, "status",
            "no importance: a merit is not finite; no local: the best merit is zero or a merit is not "
            "finite; no elasticity: the gain or the best merit is zero; no rank_correlation: fewer than "
            "three evaluations or the gain never changed");
  read.text(2, "status", "no elasticity: the gain or the best merit is zero");
  read.expect_all_seen(s.parameters.size());
}

TEST(ReducedStudy, KeepsLinksAndSweepsOfWhatIsStillTuned) {
  const test::ShortStudy files(
      "parameters:\n"
      "  - {name: task_space_gains_p/x}\n"
      "  - {name: task_space_gains_p/y}\n"
      "  - {name: task_space_gains_p/z, link: task_space_gains_p/y, factor: 2}\n"
      "  - {name: task_space_gains_p/rx, link: task_space_gains_p/x, factor: 3}\n",
      test::kShortObjective,
      "sweep:\n"
      "  - {parameters: [task_space_gains_p/x, task_space_gains_p/y], factors: [1, 2]}\n"
      "  - {parameters: [task_space_gains_p/x], factors: [1, 2]}\n");
  const Study study = load_study(files.path());
  Sensitivity s;
  s.parameters.resize(2);
  s.parameters[0].parameter = 1;
  s.parameters[1].parameter = 0;
  const Study reduced = without_less_important_half(study, s);
  ASSERT_EQ(reduced.space.free.size(), 1U);
  EXPECT_EQ(reduced.space.free[0].entry.name, "task_space_gains_p/y");
  ASSERT_EQ(reduced.space.links.size(), 1U);
  EXPECT_EQ(reduced.space.links[0].parameter, 0U);
  ASSERT_EQ(reduced.sweep.size(), 1U);
  EXPECT_EQ(reduced.sweep[0].parameters, std::vector<std::size_t>{0});
  EXPECT_EQ(reduced.space.gains_at({1.0}).task_space_gains_p[3], study.space.start.task_space_gains_p[3]);
}

}  // namespace sensitivity_test
}  // namespace armtune::internal
