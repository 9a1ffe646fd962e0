// What a page takes from the record of a run.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tuner/report/support/written_run.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {
namespace recorded_facts_test {

using test::kTwoSets;
using test::TemporaryFolder;
using test::write_run;
using testing::HasSubstr;

RunRecord record_of_kind(RunKind kind) {
  RunRecord run;
  run.kind = kind;
  run.command = "armtune " + std::string(name(kind));
  return run;
}

/// A folder with two gain sets and this record.
void write_folder(const TemporaryFolder& folder, const RunRecord& run) {
  write_run(folder, {"only"}, kTwoSets, 1, 20);
  folder.write(kRunRecord, run_record_json(run));
}

TEST(RecordedFacts, OfASearchAreInTheVerdictAndInTheTitle) {
  const TemporaryFolder folder;
  RunRecord run = record_of_kind(RunKind::kTune);
  SearchFacts& search = run.search.emplace();
  search.study = "studies/of_mine.yaml";
  search.ended = SearchEnd::kInterrupted;
  search.reason = "a signal came";
  run.tuned = {true, 0.25, ""};
  write_folder(folder, run);
  folder.write("evaluations.csv", "phase,objective,feasible,violation\nstart,1,1,0\nsearch,0.25,1,0\n");
  const ReportData data = report_of(folder.path());
  EXPECT_EQ(data.kind, RunKind::kTune);
  EXPECT_THAT(data.title, testing::StartsWith("tune of_mine"));
  EXPECT_THAT(data.verdict.sentence,
              testing::AllOf(testing::StartsWith("Interrupted"), HasSubstr("falls by 75 %")));
  EXPECT_THAT(data.verdict.details, testing::Contains("2 evaluations; a signal came"));
  EXPECT_EQ(data.provenance.command, "armtune tune");
  EXPECT_THAT(data.provenance.entries, testing::Contains(testing::Pair("search/ended", "interrupted")));
}

TEST(RecordedFacts, OfAFrontAreItsCriteriaItsHypervolumeAndItsStart) {
  const TemporaryFolder folder;
  RunRecord run = record_of_kind(RunKind::kPareto);
  run.search.emplace().start = "published";
  run.front = {{"objective", "gaze/rms"}, 2, true, 0.5};
  write_folder(folder, run);
  folder.write("pareto.csv",
               "point,kind,evaluation,dominates_start,objective,gaze/rms,g\n1,front,7,1,0.3,0.02,5\n"
               "2,front,9,0,0.4,0.01,6\n,start,0,0,1,0.05,5\n");
  const ReportData data = report_of(folder.path());
  ASSERT_TRUE(data.front);
  ASSERT_EQ(data.front->criteria.size(), 2U);
  EXPECT_EQ(data.front->criteria[1].name, "gaze/rms");
  EXPECT_EQ(data.front->hypervolume, 0.5);
  EXPECT_EQ(data.front->points.back().label, "start (published)");
  run.front.reset();
  folder.write(kRunRecord, run_record_json(run));
  EXPECT_FALSE(report_of(folder.path()).front) << "which columns are criteria is unknown";
}

TEST(RecordedFacts, OfManyArmsAreTheLimitsThatTheyKeep) {
  const TemporaryFolder folder;
  RunRecord run = record_of_kind(RunKind::kRobustness);
  run.robustness.emplace().limits = {{"of_another_version", true, 1.0}, {"gaze/rms", true, 0.125}};
  write_folder(folder, run);
  folder.write("samples.csv",
               "sample,scenario,status,broken_limit,joint_velocity/max_ratio_joint,joint_velocity/max_ratio,"
               "gaze/rms\n0,only,completed,,elbow,0.5,0.1\n1,only,completed,,elbow,0.6,0.2\n");
  const auto limit_of = [&](Metric metric) {
    const ReportData data = report_of(folder.path());
    for (const Histogram& h : data.robustness.value().histograms) {
      if (h.metric == metric) return h.limit;
    }
    ADD_FAILURE() << "no histogram of " << name(metric);
    return std::optional<double>();
  };
  EXPECT_EQ(limit_of(Metric::kGazeRms), 0.125);
  EXPECT_EQ(limit_of(Metric::kJointVelocityMaxRatio), std::nullopt);
  folder.write(kRunRecord, run_record_json(record_of_kind(RunKind::kRobustness)));
  EXPECT_EQ(limit_of(Metric::kJointVelocityMaxRatio), 1.0) << "the arm's own limits, if none are recorded";
}

}  // namespace recorded_facts_test
}  // namespace armtune::internal::report
