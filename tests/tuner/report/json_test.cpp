// What must hold of every text and number that report_json writes into a page.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/tuner/report/support/decode.hpp"
#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {
namespace json_test {

using test::at;
using test::parsed;

std::string json_of(const std::string& title) {
  ReportData data;
  data.title = title;
  return report_json(data);
}

std::string json_of(const std::vector<double>& values) {
  ReportData data;
  data.gains.emplace_back().values = values;
  return report_json(data);
}

TEST(Json, TextReadsBackAsItWas) {
  std::string all;
  for (int c = 1; c < 128; ++c) all += static_cast<char>(c);
  for (const std::string& text :
       {all, std::string("\"quoted\" \\ back"), std::string("</script><script>alert(1)</script>"),
        std::string("<!-- <img src=x onerror=alert(1)>"), std::string("Gelenk \xc3\xa4"), std::string()}) {
    const std::string json = json_of(text);
    EXPECT_EQ(at(parsed(json), "title").as_string(), text);
    EXPECT_EQ(json.find('<'), std::string::npos) << json;
  }
}

TEST(Json, BytesThatAreNotUtf8AreReplaced) {
  EXPECT_EQ(at(parsed(json_of("a\xff<b\xc3")), "title").as_string(), "a\xef\xbf\xbd<b\xef\xbf\xbd");
}

TEST(Json, NumbersReadBackToTheSameBits) {
  std::vector<double> values = {0.0,
                                -0.0,
                                0.1,
                                -1.0 / 3.0,
                                1e-300,
                                6.02214076e23,
                                12.0,
                                -5e-324,
                                1e21,
                                5e-324,
                                std::numeric_limits<double>::max()};
  // And whatever else a double may be.
  std::uint64_t bits = 1;
  for (int i = 0; i < 5000; ++i) {
    bits = bits * 6364136223846793005U + 1442695040888963407U;
    if (const auto value = std::bit_cast<double>(bits); std::isfinite(value)) values.push_back(value);
  }
  const auto json = parsed(json_of(values));
  const auto& written = at(json, "gains/0/values").items();
  ASSERT_EQ(written.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(written[i].as_number()), std::bit_cast<std::uint64_t>(values[i]))
        << values[i];
  }
}

TEST(Json, ValuesThatAreNotFiniteAreNull) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto json = parsed(json_of(std::vector<double>{NAN, -NAN, kInfinity, -kInfinity, 1.5}));
  const auto& written = at(json, "gains/0/values").items();
  ASSERT_EQ(written.size(), 5U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(written[i].kind(), yaml::Node::Kind::kNull);
  EXPECT_EQ(written[4].as_number(), 1.5);
}

}  // namespace json_test
}  // namespace armtune::internal::report
