#include "tuner/journal/journal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <csignal>
#include <random>

#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace journal_test {

using test::refused_at;
using testing::AllOf;
using testing::HasSubstr;

long lines_in(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

RunHeader header_of_run() {
  return {{"tune", "a study.yaml", "--seed", "7"},
          "/some where",
          {{"seed", "7"}, {"study", "a: 1\nb: 2\nc: 3\n"}}};
}

JournalRecord record_of(std::uint64_t number) {
  JournalRecord record;
  record.number = number;
  record.phase = "search";
  record.seconds = 0.5 * static_cast<double>(number);
  record.x = {0.1 + 1e-17, 1.0 / 3.0, -0.0, 5e-324, 1.0 - 1e-16};
  record.results.resize(2);
  record.results[0].metrics.value.fill(std::nextafter(0.1, static_cast<double>(number)));
  record.results[0].metrics[Metric::kGazeRms] = NAN;
  record.results[0].metrics[Metric::kGazeMax] = HUGE_VAL;
  record.results[0].metrics.max_ratio_joint = "tab\tand \\ and\nline";
  record.results[1].status = RolloutStatus::kDiverged;
  record.results[1].reason = "diverged at 3 s: \"a\", b";
  record.results[1].end_time = 3.002;
  return record;
}

/// While it lives, files of this process take so many bytes: a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small = {bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

void expect_same(const JournalRecord& a, const JournalRecord& b) {
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.phase, b.phase);
  EXPECT_EQ(a.seconds, b.seconds);
  ASSERT_EQ(a.x.size(), b.x.size());
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a.x[i]), std::bit_cast<std::uint64_t>(b.x[i]));
  }
  ASSERT_EQ(a.results.size(), b.results.size());
  for (std::size_t s = 0; s < a.results.size(); ++s) {
    EXPECT_EQ(a.results[s].status, b.results[s].status);
    EXPECT_EQ(a.results[s].reason, b.results[s].reason);
    EXPECT_EQ(a.results[s].end_time, b.results[s].end_time);
    EXPECT_EQ(a.results[s].metrics.max_ratio_joint, b.results[s].metrics.max_ratio_joint);
    EXPECT_EQ(test::bits(a.results[s].metrics), test::bits(b.results[s].metrics));
  }
}

class JournalFile : public testing::Test {
 protected:
  /// A journal of six records, out of order as several workers finish them.
  std::string written() {
    const std::string path = folder_ / "journal.txt";
    const auto journal = Journal::begin(path, header_of_run());
    for (const auto number : std::initializer_list<std::uint64_t>{0, 2, 1, 3, 5, 4})
      journal->append(record_of(number));
    return path;
  }

  std::unique_ptr<Journal> resumed(const std::string& path) {
    return Journal::resume(path, header_of_run(), warning_);
  }

  test::TemporaryFolder folder_;
  std::string warning_;
};

TEST_F(JournalFile, GivesBackWhatWasWrittenToTheBit) {
  const std::string path = written();
  const auto journal = resumed(path);
  EXPECT_EQ(warning_, "");
  EXPECT_EQ(journal->records(), 6U);
  EXPECT_EQ(journal->seconds(), 2.5);
  for (std::uint64_t number = 0; number < 6; ++number) expect_same(*journal->find(number), record_of(number));
  EXPECT_FALSE(journal->find(6).has_value());
  journal->append(record_of(6));
  expect_same(*journal->find(6), record_of(6));

  const RunHeader header = read_run_header(path);
  EXPECT_EQ(header.arguments, header_of_run().arguments);
  EXPECT_EQ(header.working_folder, header_of_run().working_folder);
  EXPECT_EQ(header.identity, header_of_run().identity);
}

TEST_F(JournalFile, RemembersWhenTheTimeWasUpAndThatTheRunIsComplete) {
  const std::string path = written();
  {
    const auto journal = resumed(path);
    EXPECT_FALSE(journal->time_was_up().has_value());
    EXPECT_FALSE(journal->exit_code().has_value());
    journal->time_is_up(4, Minutes::kSearch);
    EXPECT_FALSE(journal->time_was_up().has_value()) << "a search's minutes are not the run's";
    journal->time_is_up(6);
    journal->time_is_up(2, Minutes::kLocal);
    journal->time_is_up(5, Minutes::kFinal);
    journal->complete(3);
  }
  {
    const auto journal = resumed(path);
    EXPECT_EQ(journal->time_was_up(Minutes::kSearch), 4U);
    EXPECT_EQ(journal->time_was_up(), 6U);
    EXPECT_EQ(journal->time_was_up(Minutes::kLocal), 2U);
    EXPECT_EQ(journal->time_was_up(Minutes::kFinal), 5U);
    EXPECT_FALSE(journal->time_was_up(Minutes::kGlobal).has_value());
    EXPECT_EQ(journal->exit_code(), 3);
    journal->complete(256);
  }
  const InputError error = test::input_error([&] { resumed(path); });
  EXPECT_THAT(error, refused_at({.file = path, .line = lines_in(test::read_text(path))})) << "the last one";
  EXPECT_THAT(error.what(), HasSubstr("256 is not an exit code"));
}

TEST_F(JournalFile, IsWrittenByOneProcessAtATime) {
  const std::string path = written();
  const auto first = resumed(path);
  const InputError error = test::input_error([&] { resumed(path); });
  EXPECT_THAT(error, refused_at({.file = path}));
  EXPECT_THAT(error.what(), HasSubstr("another process is writing"));
}

TEST_F(JournalFile, IsBegunOnlyWhereThereIsNone) {
  const std::string path = written();
  const std::string before = test::read_text(path);
  EXPECT_THAT([&] { Journal::begin(path, header_of_run()); }, refused_at({.file = path}));
  EXPECT_EQ(test::read_text(path), before);
  const auto first = Journal::begin(folder_ / "new.txt", header_of_run());
  EXPECT_THAT([&] { resumed(folder_ / "new.txt"); }, refused_at({.file = folder_ / "new.txt", .line = 0}));
}

TEST(RunHeader, AnotherBuildIsCalledThatAndNotByItsHash) {
  RunHeader was;
  was.identity = {{RunHeader::kProgram, "fnv1a-1"}, {"seed", "7"}};
  RunHeader is = was;
  EXPECT_EQ(differences(was, is), "");
  is.identity[0].second = "fnv1a-2";
  EXPECT_EQ(differences(was, is), "this program is another build than the one that started the run");
  is.identity[1].second = "8";
  EXPECT_EQ(differences(was, is),
            "this program is another build than the one that started the run; seed was '7', is '8'");
}

TEST(RunHeader, ARunIsItselfHoweverOftenANameStandsInIt) {
  RunHeader was;
  was.identity = {{"input", "a"}, {"input", "b"}};
  EXPECT_EQ(differences(was, was), "");
  RunHeader is = was;
  is.identity[1].second = "c";
  EXPECT_EQ(differences(was, is), "input was 'b', is 'c'");
}

TEST(RunHeader, WhatDiffersIsToldInOneShortLine) {
  RunHeader was;
  for (int i = 0; i < 1000; ++i)
    was.identity.emplace_back(std::string(10000, 'n') + "\n" + std::to_string(i), std::string(100000, 'v'));
  const std::string told = differences(was, {});
  EXPECT_LT(told.size(), 2000U);
  EXPECT_EQ(told.find('\n'), std::string::npos);
  EXPECT_THAT(told, HasSubstr("and 997 more"));
}

TEST_F(JournalFile, RefusesAnotherRunAndSaysWhatDiffers) {
  const std::string path = written();
  RunHeader other = header_of_run();
  other.identity[0].second = "8";
  other.identity[1].second = "a: 1\nb: 20\nc: 3\n";
  other.identity.emplace_back("ur10.urdf", "fnv1a-1");
  const InputError error = test::input_error([&] { Journal::resume(path, other, warning_); });
  EXPECT_THAT(error, refused_at({.file = path, .line = 0}));
  EXPECT_THAT(error.what(),
              AllOf(HasSubstr("seed was '7', is '8'"), HasSubstr("study was 'b: 2', is 'b: 20'"),
                    HasSubstr("ur10.urdf was '(nothing)', is 'fnv1a-1'"), HasSubstr("--out")));
  EXPECT_THAT([&] { resumed(folder_ / "none.txt"); }, refused_at({.file = folder_ / "none.txt", .line = 0}));
  const std::string csv = folder_.write("other.txt", "evaluation,phase\n");
  EXPECT_THAT([&] { resumed(csv); }, refused_at({.file = csv, .line = 0, .limit = "armtune journal 1"}));
}

TEST_F(JournalFile, CutAnywhereItKeepsEveryWholeRecord) {
  const std::string whole = test::read_text(written());
  const std::size_t header = whole.find(" records\n") + 9;
  ASSERT_GT(header, 100U);
  std::mt19937 draw(1);
  for (int i = 0; i < 200; ++i) {
    const std::size_t place = std::uniform_int_distribution<std::size_t>(0, whole.size() - 1)(draw);
    const std::string text = whole.substr(0, place);
    const std::string path = folder_.write("cut.txt", text);
    if (place < header) {
      EXPECT_THAT([&] { resumed(path); }, refused_at({.file = path})) << "cut at " << place;
      continue;
    }
    const auto lines = static_cast<std::size_t>(
        std::count(text.begin() + static_cast<std::ptrdiff_t>(header), text.end(), '\n'));
    {
      const auto journal = resumed(path);
      EXPECT_EQ(journal->records(), lines) << "cut at " << place;
      EXPECT_EQ(warning_.empty(), text.back() == '\n') << warning_;
      journal->append(record_of(9));  // goes on where the last whole record ends
    }
    EXPECT_EQ(resumed(path)->records(), lines + 1);
    EXPECT_EQ(warning_, "");
  }
}

TEST_F(JournalFile, ABitFlippedAnywhereIsFoundNeverTaken) {
  const std::string whole = test::read_text(written());
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  std::mt19937 draw(2);
  int refused = 0;
  int recovered = 0;
  for (int i = 0; i < 200; ++i) {
    const std::size_t place = std::uniform_int_distribution<std::size_t>(0, whole.size() - 1)(draw);
    std::string text = whole;
    text[place] = static_cast<char>(text[place] ^ (1 << std::uniform_int_distribution<int>(0, 7)(draw)));
    const std::string path = folder_.write("flipped.txt", text);
    const std::string refusal = test::refusal([&] {
      const auto journal = resumed(path);
      ++recovered;
      EXPECT_GE(place, last - 1) << "only what can be the end of a torn file is cut off";
      EXPECT_NE(warning_, "");
      for (std::uint64_t number = 0; number < 6; ++number) {
        if (const auto record = journal->find(number)) expect_same(*record, record_of(number));
      }
      EXPECT_GE(journal->records(), 4U);
    });
    if (refusal.find("flipped.txt") != std::string::npos) ++refused;
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(recovered, 0);
  EXPECT_EQ(refused + recovered, 200);
}

TEST(RunHeader, ALineWithoutEndIsNotReadIntoTheMemory) {
  EXPECT_THAT([] { read_run_header("/dev/zero"); },
              refused_at({.file = "/dev/zero", .line = 1, .limit = "lines of at most 64 MB"}));
}

TEST_F(JournalFile, DamageInTheMiddleNamesTheRecord) {
  std::string text = test::read_text(written());
  const std::size_t third = text.find("finished\t1\t");
  ASSERT_NE(third, std::string::npos);
  text[third + 9] = '7';
  const std::string path = folder_.write("damaged.txt", text);
  const InputError error = test::input_error([&] { resumed(path); });
  EXPECT_THAT(error, refused_at({.file = path,
                                 .line = lines_in(text.substr(0, third)) + 1,
                                 .limit = "a line with the right checksum"}));
  EXPECT_THAT(error.what(), HasSubstr("record 2 "));
}

TEST(Journal, AHeaderThatTheDiskRefusesLeavesNoFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "journal.txt";
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{10}, rlim_t{60}}) {
    const FullDisk disk(bytes);
    EXPECT_THROW(Journal::begin(path, header_of_run()), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  Journal::begin(path, header_of_run());
  EXPECT_EQ(read_run_header(path).arguments, header_of_run().arguments);
}

}  // namespace journal_test
}  // namespace armtune::internal
