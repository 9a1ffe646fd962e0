#include "tuner/report/json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "tests/tuner/report/support/decode.hpp"

namespace armtune::report {
namespace {

using test::at;
using test::parsed;

TEST(Json, TextReadsBackAsItWas) {
  std::string all;
  for (int c = 1; c < 128; ++c) all += static_cast<char>(c);
  for (const std::string& text :
       {all, std::string("\"quoted\" \\ back"), std::string("</script><script>alert(1)</script>"),
        std::string("<!-- <img src=x onerror=alert(1)>"), std::string("Gelenk \xc3\xa4"), std::string()}) {
    Json json;
    json.begin_object();
    json.text("a", text);
    json.end_object();
    EXPECT_EQ(at(parsed(json.str()), "a").as_string(), text);
    EXPECT_EQ(json.str().find('<'), std::string::npos) << json.str();
  }
}

TEST(Json, KeysAreGuardedAsTextIs) {
  Json json;
  json.begin_object();
  json.number("</script> \"x\"", 1.0);
  json.end_object();
  EXPECT_EQ(json.str().find('<'), std::string::npos);
  EXPECT_EQ(parsed(json.str()).entries().front().first, "</script> \"x\"");
}

TEST(Json, NumbersReadBackToTheSameBits) {
  for (const double value : {0.0, 0.1, -1.0 / 3.0, 1e-300, 6.02214076e23, 12.0, -5e-324}) {
    Json json;
    json.begin_array();
    json.number(value);
    json.end_array();
    EXPECT_EQ(std::strtod(json.str().c_str() + 1, nullptr), value) << json.str();
  }
}

TEST(Json, WhatIsNoNumberIsNull) {
  Json values;
  values.begin_array();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double value : std::vector<double>{NAN, -NAN, kInfinity, -kInfinity, 1.5}) {
    values.number(value);
  }
  values.end_array();
  EXPECT_EQ(values.str(), "[null,null,null,null,1.5]");
}

TEST(Json, NestsWithCommasBetweenAndNoneElse) {
  Json json;
  json.begin_object();
  json.key("empty");
  json.begin_array();
  json.end_array();
  json.key("list");
  json.begin_array();
  json.begin_object();
  json.integer("i", -3);
  json.boolean("b", true);
  json.end_object();
  json.null();
  json.begin_array();
  json.boolean(false);
  json.text("x");
  json.end_array();
  json.end_array();
  json.texts("t", {"p", "q"});
  json.end_object();
  const auto root = parsed(json.str());
  EXPECT_TRUE(at(root, "empty").items().empty());
  EXPECT_EQ(at(root, "list/0/i").as_integer(), -3);
  EXPECT_TRUE(at(root, "list/0/b").as_boolean());
  EXPECT_EQ(at(root, "list/1").kind(), yaml::Node::Kind::kNull);
  EXPECT_FALSE(at(root, "list/2/0").as_boolean());
  EXPECT_EQ(at(root, "list/2/1").as_string(), "x");
  EXPECT_THAT(at(root, "t").as_strings(), testing::ElementsAre("p", "q"));
}

}  // namespace
}  // namespace armtune::report
