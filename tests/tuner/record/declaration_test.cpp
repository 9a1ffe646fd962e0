// What one declaration makes of a type: its JSON, the same value read back, and its TypeScript interface
// agree.

#include "tuner/record/declaration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <regex>

#include "core/common/types.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/record/json_reader.hpp"
#include "tuner/record/json_writer.hpp"
#include "tuner/record/type_printer.hpp"

namespace armtune::internal::record {
namespace declaration_test {

using test::refused_at;
using testing::HasSubstr;

enum class Fruit { kApple, kPear };

constexpr const char* name(Fruit fruit) {
  switch (fruit) {
    case Fruit::kApple:
      return "apple";
    case Fruit::kPear:
      return "pear";
  }
  return "";
}

struct Inner {
  long number = 0;
  std::optional<double> limit;
  bool operator==(const Inner&) const = default;

  static void declare(auto& f, auto& inner) {
    f.type("Inner", "Stands inside.");
    f("number", inner.number, "Counted from 1.");
    f("limit", inner.limit);
  }
};

struct Outer {
  std::string text;
  std::string side = "left";
  bool slides = false;
  bool plain = false;
  Fruit fruit = Fruit::kApple;
  std::size_t count = 0;
  double unknown = 0.0;
  std::vector<double> values;
  std::vector<Inner> inner;
  std::optional<Inner> absent;
  Vec3 point = Vec3::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  int later = 7;
  bool operator==(const Outer&) const = default;

  static void declare(auto& f, auto& outer) {
    f.type("Outer");
    f("text", outer.text);
    f("side", outer.side, {"left", "right"});
    f("slides", outer.slides, {"turns", "slides"});
    f("plain", outer.plain);
    f("fruit", outer.fruit);
    f("count", outer.count);
    f("unknown", outer.unknown, "", Presence::kOrNull);
    f("values", outer.values, "", Presence::kIfAny);
    f("inner", outer.inner, "", Presence::kIfAny);
    f("absent", outer.absent, "Only where there is one.", Presence::kIfAny);
    f("point", outer.point);
    f("turn", outer.turn);
    f("later", outer.later, "", Presence::kLater);
  }
};

Outer whole() {
  Outer outer;
  outer.text = "a \"b\" </c>";
  outer.side = "right";
  outer.slides = true;
  outer.plain = true;
  outer.fruit = Fruit::kPear;
  outer.count = 12;
  outer.unknown = 0.1;
  outer.values = {1.0, -1.0 / 3.0};
  outer.inner = {{1, 2.5}, {-2, std::nullopt}};
  outer.absent = {3, std::nullopt};
  outer.point = {1, 2, 3};
  outer.turn = Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5);
  outer.later = -1;
  return outer;
}

Outer read_back(const std::string& json) {
  Outer outer;
  read(yaml::parse_text(json, "file.json"), outer);
  return outer;
}

/// The text with one part of it replaced, which is there.
std::string with(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part << " in " << text;
  return text.replace(at, part.size(), by);
}

InputError refusal(const std::string& json) {
  return test::input_error([&json] { read_back(json); });
}

/// Names of an interface's members, those that may be absent with their question mark.
std::vector<std::string> members(const std::string& types, const std::string& interface) {
  const std::size_t from = types.find("interface " + interface + " {");
  const std::string body = types.substr(from, types.find("\n}", from) - from);
  const std::regex member("\n  (\\w+[?]?): ");
  std::vector<std::string> names;
  for (std::sregex_iterator at(body.begin(), body.end(), member), end; at != end; ++at)
    names.push_back((*at)[1]);
  return names;
}

std::vector<std::string> keys(const std::string& json) {
  std::vector<std::string> names;
  const yaml::Node root = yaml::parse_text(json, "json");
  for (const auto& entry : root.entries()) names.push_back(entry.first);
  return names;
}

TEST(Declaration, AValueReadsBackAsItWas) {
  for (const Outer& outer : {whole(), Outer()}) {
    const std::string json = json_of(outer);
    EXPECT_EQ(read_back(json), outer) << json;
    EXPECT_EQ(json_of(read_back(json)), json);
  }
}

TEST(Declaration, ANumberThatThereIsNotIsNull) {
  Outer outer = whole();
  for (const double value : std::vector<double>{NAN, INFINITY}) {
    outer.unknown = value;
    EXPECT_THAT(json_of(outer), HasSubstr("\"unknown\":null"));
  }
}

TEST(Declaration, InterfaceAndJsonHaveTheSameMembersInTheSameOrder) {
  TypePrinter printer;
  EXPECT_EQ(printer.type_of<Outer>(), "Outer");
  std::vector<std::string> always;
  std::vector<std::string> all;
  for (std::string member : members(printer.text(), "Outer")) {
    const bool optional = member.ends_with('?');
    if (optional) member.pop_back();
    all.push_back(member);
    if (!optional) always.push_back(member);
  }
  EXPECT_EQ(all.size(), 13U);
  EXPECT_EQ(keys(json_of(whole())), all);
  EXPECT_EQ(keys(json_of(Outer())), always);
}

TEST(Declaration, TypesAreThoseOfTheJson) {
  TypePrinter printer;
  printer.type_of<Outer>();
  for (const char* line :
       {"  text: string;", "  side: \"left\" | \"right\";", "  slides: \"turns\" | \"slides\";",
        "  plain: boolean;", "  fruit: \"apple\" | \"pear\";", "  count: number;",
        "  unknown: number | null;", "  values?: number[];", "  inner?: Inner[];", "  absent?: Inner;",
        "  point: Vec3;", "  turn: Quaternion;", "  limit: number | null;",
        "/** Stands inside. */\nexport interface Inner {", "  /** Counted from 1. */\n  number: number;"}) {
    EXPECT_THAT(printer.text(), HasSubstr(line));
  }
  const std::string& text = printer.text();
  EXPECT_EQ(text.find("interface Inner"), text.rfind("interface Inner")) << "printed once";
  EXPECT_EQ(printer.type_of<std::vector<Fruit>>(), "(\"apple\" | \"pear\")[]");
  EXPECT_EQ((printer.type_of<std::pair<std::string, bool>>()), "[string, boolean]");
  EXPECT_EQ(printer.type_of<std::vector<double>>(true), "(number | null)[]");
}

TEST(Declaration, AFileOfAnOlderVersionLacksALaterMember) {
  EXPECT_EQ(read_back(with(json_of(whole()), ",\"later\":-1", "")).later, Outer().later);
}

TEST(Declaration, WhatIsWrongIsNamedWithItsFileAndKey) {
  const std::string json = json_of(whole());
  EXPECT_THAT(refusal(with(json, "\"plain\":true,", "")),
              refused_at({.file = "file.json", .line = 1, .limit = "the key 'plain'"}));
  EXPECT_THAT(refusal(with(json, "\"plain\"", "\"plane\":1,\"plain\"")),
              refused_at({.key = "plane", .suggestion = "plain"}));
  EXPECT_THAT(refusal(with(json, "\"count\":12", "\"count\":-12")),
              refused_at({.key = "count", .value = "-12"}));
  EXPECT_THAT(refusal(with(json, "\"number\":1", "\"number\":true")),
              refused_at({.key = "inner/0/number", .value = "true"}));
  EXPECT_THAT(refusal(with(json, "\"pear\"", "\"plum\"")),
              refused_at({.key = "fruit", .value = "plum", .limit = "one of: apple, pear"}));
  EXPECT_THAT(refusal(with(json, "\"slides\":\"slides\"", "\"slides\":\"rolls\"")),
              refused_at({.key = "slides", .value = "rolls", .limit = "one of: turns, slides"}));
  EXPECT_THAT(refusal(with(json, "\"side\":\"right\"", "\"side\":\"up\"")),
              refused_at({.key = "side", .value = "up", .limit = "one of: left, right"}));
}

}  // namespace declaration_test
}  // namespace armtune::internal::record
