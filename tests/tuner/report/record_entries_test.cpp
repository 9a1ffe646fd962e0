#include "tuner/report/record_entries.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/run/support/records.hpp"

namespace armtune::internal::report {
namespace record_entries_test {

using testing::Contains;
using testing::Pair;

TEST(RecordEntries, ShowTheFactsOfTheRecordByTheirPaths) {
  const Provenance shown = provenance_of(test::whole_record());
  EXPECT_EQ(shown.command, test::whole_record().command);
  const std::pair<const char*, const char*> facts[] = {
      {"kind", "pareto"},
      {"seed", "9007199254740993"},
      {"wall_seconds", "564.201"},
      {"search/engine", "native"},
      {"search/ended", "time_used_up"},
      {"tuned/feasible", "true"},
      {"front/criteria/1", "objective"},
      {"front/criteria/2", "gaze/rms"},
      {"robustness/limits/gaze/rms/relation", "at_most"},
      {"plan/phases/hold/duration", "0.04"},
      {"identification/torque/elbow/rms", "3"},
      {"identification/accepted_although/1", "the sign is wrong"},
      {"validation/joints/elbow/explained", "0.97"},
      {"validation/thresholds/explained/value", "0.9"},
      {"calibration/error_ratio", "0.2"},
      {"calibration/not_told/delay/needs", "changing_commands"},
      {"versions/eigen/version", "3.4.0"},
      {"machine/hardware_threads", "2"},
      {"inputs/b/c.yaml/hash", "fnv1a-5"},
      {"inputs/b/c.yaml/copy", "inputs/01_c.yaml"}};
  for (const auto& [path, value] : facts) EXPECT_THAT(shown.entries, Contains(Pair(path, value)));
}

TEST(RecordEntries, LeaveOutWhatIsMissing) {
  std::set<std::string> parts;
  for (const auto& [path, value] : provenance_of(RunRecord()).entries) {
    EXPECT_FALSE(value.empty()) << path;
    parts.insert(path.substr(0, path.find('/')));
  }
  EXPECT_THAT(parts,
              testing::UnorderedElementsAre("format", "kind", "wall_seconds", "seed", "workers", "machine"));
}

TEST(RecordEntries, OfAnOlderArmtuneAreRefused) {
  const test::TemporaryFolder folder;
  const auto refuse = [&] { refuse_old_record(folder.path()); };
  EXPECT_NO_THROW(refuse()) << "a run that has not ended";
  folder.write(kOldRunRecord, "command: \"armtune tune\"\n");
  EXPECT_THAT(refuse, test::refused_at({.file = folder / kOldRunRecord}));
  folder.write(kRunRecord, run_record_json({}));
  EXPECT_NO_THROW(refuse());
}

}  // namespace record_entries_test
}  // namespace armtune::internal::report
