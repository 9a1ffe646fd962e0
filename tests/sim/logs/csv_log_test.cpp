// Text logs in the shapes that recorders write, and how far they are repaired.

#include "sim/logs/csv_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/logs/log_reader.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace csv_log_test {

using test::refused_at;
using testing::ElementsAre;

struct ReadRows {
  std::vector<double> time;
  std::vector<std::vector<double>> value;
  std::vector<std::string> channels, units, skipped;
  LogRepairs repairs;
  double start = 0.0;
};

class CsvLogFiles : public testing::Test {
 protected:
  ReadRows read(const std::string& text, const TimeOptions& options = {}) const {
    return read_paths({files_.write("log.csv", text)}, options);
  }
  static ReadRows read_paths(const std::vector<std::string>& paths, const TimeOptions& options = {}) {
    CsvLog log(paths, options);
    ReadRows rows;
    for (LogRow row; log.next(row);) {
      rows.time.push_back(row.time);
      rows.value.push_back(row.value);
    }
    rows.channels = log.channels();
    rows.units = log.units();
    rows.skipped = log.skipped();
    rows.repairs = log.repairs();
    rows.start = log.start();
    return rows;
  }
  /// The lines "time,value" of n rows at 100 Hz; `at` may change the index that stands in a row.
  template <typename At>
  static std::string lines(int n, At&& at) {
    std::string text = "time,q1\n";
    for (int k = 0; k < n; ++k) text += std::to_string(0.01 * at(k)) + "," + std::to_string(at(k)) + "\n";
    return text;
  }

  test::TemporaryFolder files_;
};

TEST_F(CsvLogFiles, OfEveryShapeHoldTheSameNumbers) {
  for (const char* text : {
           "time,q1,q2\n0,1.5,-2\n0.01,1.25,-3\n0.02,1,-4\n",
           "time;q1;q2\r\n0;1,5;-2\r\n0,01;1,25;-3\r\n0,02;1;-4\r\n",
           "\xEF\xBB\xBFtime\tq1\tq2\n0\t1.5\t-2\n0.01\t1.25\t-3\n0.02\t1\t-4",
           "# recorded by x\n# time q1 q2\n0 1.5  -2\n0.01 1.25 -3\n\n0.02 1 -4\n",
           "time,q1,q2,\n0,1.5,-2,\n0.01,1.25,-3,\n0.02,1,-4,\n",
           "\"time\", \"q1\", \"q2\"\ns, rad, rad\n+0, 1.5, -2\n1e-2, 1.25, -3\n0.02, 1, -4\n",
           "q2,timestamp_ms,q1\n-2,5000,1.5\n-3,5010,1.25\n-4,5020,1\n",
       }) {
    SCOPED_TRACE(text);
    ReadRows rows = read(text);
    ASSERT_EQ(rows.time.size(), 3U);
    const std::size_t q1 = rows.channels.front() == "q1" ? 0 : 1;
    EXPECT_THAT(rows.channels, testing::UnorderedElementsAre("q1", "q2"));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(rows.time[k], 0.01 * static_cast<double>(k), 1e-9);
      EXPECT_EQ(rows.value[k][q1], 1.5 - 0.25 * static_cast<double>(k));
      EXPECT_EQ(rows.value[k][1 - q1], -2.0 - static_cast<double>(k));
    }
  }
}

TEST_F(CsvLogFiles, WithoutNamesNumberTheirColumns) {
  EXPECT_THAT(read("0,1,2\n0.01,3,4\n0.02,5,6\n0.03,7,8\n").channels, ElementsAre("2", "3"));
  EXPECT_THAT(read("0,5;1,5\n0,51;2,5\n0,52;3,5\n0,53;4,5\n").value.back(), ElementsAre(4.5));
}

TEST_F(CsvLogFiles, NumberColumnsOfTheSameName) {
  EXPECT_THAT(read("t,q,q,tau\n0,1,2,3\n0.1,1,2,3\n").channels, ElementsAre("q[0]", "q[1]", "tau"));
}

TEST_F(CsvLogFiles, FindTheUnitOfTheTime) {
  struct Case {
    const char* text;
    double start, step;
  };
  for (const Case& c : {
           Case{"t,q\n1700000000.5,1\n1700000000.502,1\n1700000000.504,1\n", 1700000000.5, 0.002},
           Case{"t,q\n1700000000500,1\n1700000000502,1\n1700000000504,1\n", 1700000000.5, 0.002},
           Case{"t,q\n1700000000500000,1\n1700000000502000,1\n1700000000504000,1\n", 1700000000.5, 0.002},
           Case{"t,q\n1700000000500000001,1\n1700000000500000003,1\n1700000000500000005,1\n", 1700000000.5,
                2e-9},
           Case{"header.stamp.secs,header.stamp.nsecs,q\n7,999000000,1\n8,1000000,1\n8,3000000,1\n", 7.999,
                0.002},
           Case{"time,q\n2,1\n4,1\n6,1\n", 0.002, 0.002},
           Case{"time_us,q\n2,1\n4,1\n6,1\n", 2e-6, 2e-6},
           Case{"time [ns],q\n2,1\n4,1\n6,1\n", 2e-9, 2e-9},
           Case{"time,q\nus,rad\n2,1\n4,1\n6,1\n", 2e-6, 2e-6},
           Case{"date,q\n2024-05-01T12:00:00.5Z,1\n2024-05-01T12:00:00.75Z,1\n2024-05-01 12:00:01,1\n",
                1714564800.5, 0.25},
       }) {
    SCOPED_TRACE(c.text);
    const ReadRows rows = read(c.text);
    ASSERT_EQ(rows.time.size(), 3U);
    EXPECT_EQ(rows.channels.size(), 1U);
    EXPECT_NEAR(rows.start, c.start, 1e-6);
    EXPECT_EQ(rows.time[0], 0.0);
    EXPECT_NEAR(rows.time[1], c.step, 1e-6 * c.step);
    EXPECT_NEAR(rows.time[2], 2.0 * c.step, 1e-6 * c.step);
  }
}

TEST_F(CsvLogFiles, WithoutTimeNeedARate) {
  const std::string path = files_.write("log.csv", "q1,q2\n1,2\n1.5,2\n1.2,2\n");
  EXPECT_THAT([&] { return CsvLog({path}, {}); }, refused_at({.file = path, .key = "--rate"}));
  const ReadRows rows = read("q1,q2\n1,2\n1.5,2\n1.2,2\n", {.unit = {}, .rate = 50.0, .column = {}});
  EXPECT_THAT(rows.time, ElementsAre(0.0, 0.02, 0.04));
  EXPECT_THAT([&] { return CsvLog({path}, {.unit = {}, .rate = {}, .column = "q3"}); },
              refused_at({.key = "--time", .value = "q3"}));
}

TEST_F(CsvLogFiles, KeepMissingNumbersAndSkipText) {
  const ReadRows rows =
      read("t,q,mode,on\n0,1,idle,true\n0.1,,run,false\n0.2,NaN,run,true\n0.3,inf,run,true\n");
  EXPECT_THAT(rows.skipped, ElementsAre("mode"));
  EXPECT_EQ(rows.value[0][0], 1.0);
  for (const std::size_t k : {1U, 2U, 3U}) EXPECT_TRUE(std::isnan(rows.value[k][0])) << k;
  EXPECT_EQ(rows.value[1][1], 0.0);
}

TEST_F(CsvLogFiles, AreSortedWithinTheWindow) {
  // Row 30 stands 40 rows too late.
  const ReadRows rows = read(lines(200, [](int k) { return k < 30 || k > 70 ? k : k == 70 ? 30 : k + 1; }));
  ASSERT_EQ(rows.time.size(), 200U);
  for (std::size_t k = 0; k < 200; ++k) EXPECT_EQ(rows.value[k][0], static_cast<double>(k));
  EXPECT_EQ(rows.repairs.moved, 1);
}

TEST_F(CsvLogFiles, ThatRunBackFurtherAreRefused) {
  // The clock starts anew at row 150, which is on line 152.
  const std::string path = files_.write("log.csv", lines(300, [](int k) { return k < 150 ? k : k - 150; }));
  EXPECT_THAT([&] { return read_paths({path}); }, refused_at({.file = path, .line = 152, .key = "time"}));
}

TEST_F(CsvLogFiles, WithFewRepeatedStampsLoseThem) {
  const ReadRows rows = read(lines(200, [](int k) { return k % 20 == 19 ? k - 1 : k; }));
  EXPECT_EQ(rows.repairs.repeated, 10);
  EXPECT_EQ(rows.time.size(), 190U);
  for (std::size_t k = 1; k < rows.time.size(); ++k) EXPECT_GT(rows.time[k], rows.time[k - 1]);
}

TEST_F(CsvLogFiles, BeyondTheBoundsOfRepairAreRefused) {
  const auto refuses = [&](const std::string& text) {
    const std::string path = files_.write("log.csv", text);
    EXPECT_THAT([&] { return read_paths({path}); },
                refused_at({.file = path, .key = "time", .limit = testing::HasSubstr("%")}));
  };
  refuses(lines(200, [](int k) { return k % 5 == 4 ? k - 1 : k; }));                       // 20 % repeated
  refuses(lines(200, [](int k) { return k % 4 == 1 ? k + 1 : k % 4 == 2 ? k - 1 : k; }));  // 25 % moved
  std::string text = "time,q\n";
  for (int k = 0; k < 200; ++k) text += (k % 20 == 7 ? "" : std::to_string(0.01 * k)) + ",1\n";
  refuses(text);  // 5 % without a stamp
}

TEST_F(CsvLogFiles, CutOffInTheLastRowLoseOnlyThat) {
  const ReadRows rows = read("t,q1,q2\n0,1,2\n0.1,3,4\n0.2,5");
  EXPECT_EQ(rows.time.size(), 2U);
  EXPECT_EQ(rows.repairs.cut, 1);
}

TEST_F(CsvLogFiles, ThatAreMalformedAreRefusedWithTheirPlace) {
  const auto refuse = [&](const std::string& text) {
    const std::string path = files_.write("log.csv", text);
    return test::input_error([&] { return read_paths({path}); });
  };
  EXPECT_THAT(refuse("t,q\n0,1\n0.1,2,3\n0.2,3\n"),
              refused_at({.line = 3, .value = "3", .limit = "2 cells"}));
  EXPECT_THAT(refuse("t,q\n0,1\n0.1,x7\n0.2,3\n"), refused_at({.line = 3, .key = "q", .value = "x7"}));
  EXPECT_THAT(refuse("t,q\n0,1\nt,q\n0,1\n"), refused_at({.line = 3, .key = "t", .value = "t"}));
  EXPECT_THAT(refuse(""), refused_at({.file = testing::EndsWith("log.csv")}));
  EXPECT_THAT(refuse("t,q\n"), refused_at({.file = testing::EndsWith("log.csv")}));
  EXPECT_THAT(refuse(std::string("\xFF\xFEt\0", 4)), refused_at({.line = 1}));
  EXPECT_THAT(refuse(std::string("t\0q\n", 4)), refused_at({.line = 1}));
  EXPECT_THAT(refuse("t,name\n0,a\n0.1,b\n0.2,c\n"), refused_at({.limit = "a column of numbers"}));
  EXPECT_THAT(refuse(std::string(2'000'000, '1')),
              refused_at({.line = 1, .limit = testing::HasSubstr("1 MB")}));
  EXPECT_THAT(refuse(std::string(40'000, ',') + "\n"),
              refused_at({.line = 1, .limit = testing::HasSubstr("columns")}));
}

TEST_F(CsvLogFiles, SideBySideAreOneLog) {
  const std::string time = files_.write("time.txt", "0\n0.01\n0.02\n0.03\n");
  const std::string q = files_.write("arm_q.txt", "1\n10\n2\n20\n3\n30\n4\n40\n");
  const std::string tau = files_.write("tau.csv", "tau1,tau2\n5,6\n7,8\n9,10\n11,12\n");
  for (const auto& paths : {std::vector{time, q, tau}, std::vector{tau, q, time}}) {
    const Log log = read_log(paths, {});
    ASSERT_EQ(log.topics.size(), 1U);
    EXPECT_THAT(log.topics[0].time, ElementsAre(0.0, 0.01, 0.02, 0.03));
    std::map<std::string, std::vector<double>> value;
    for (const LogChannel& channel : log.topics[0].channels) value[channel.name] = channel.value;
    EXPECT_THAT(value["arm_q[0]"], ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(value["arm_q[1]"], ElementsAre(10, 20, 30, 40));
    EXPECT_THAT(value["tau2"], ElementsAre(6, 8, 10, 12));
  }
  const std::string uneven = files_.write("uneven.txt", "1\n2\n3\n4\n5\n");
  EXPECT_THAT(
      [&] {
        return read_log(std::vector{time, uneven}, {});
      },
      refused_at({.file = uneven, .value = "5", .limit = "4 rows"}));
}

}  // namespace csv_log_test
}  // namespace armtune::internal
