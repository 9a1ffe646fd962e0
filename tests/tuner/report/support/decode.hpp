#pragma once
// What a page does with the data it is given, written anew.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "sim/yaml/document.hpp"

namespace armtune::internal::test {

/// Bytes of base64 text, bit by bit.
inline std::vector<unsigned char> base64_bytes(const std::string& text) {
  std::vector<unsigned char> bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char c : text) {
    unsigned six = 0;
    if (c >= 'A' && c <= 'Z') {
      six = static_cast<unsigned>(c - 'A');
    } else if (c >= 'a' && c <= 'z') {
      six = static_cast<unsigned>(c - 'a') + 26;
    } else if (c >= '0' && c <= '9') {
      six = static_cast<unsigned>(c - '0') + 52;
    } else if (c == '+') {
      six = 62;
    } else if (c == '/') {
      six = 63;
    } else {
      break;  // the padding
    }
    bits = (bits << 6U | six) & 0xffffU;
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<unsigned char>(bits >> static_cast<unsigned>(held) & 0xffU));
    }
  }
  return bytes;
}

/// JSON, which is YAML too, through the reader of armtune's input files.
inline yaml::Node parsed(const std::string& json) {
  return yaml::parse_text(json, "json");
}

/// The node at a path of keys and indices, "scenarios/0/name".
inline const yaml::Node& at(const yaml::Node& node, const std::string& path) {
  const std::size_t slash = path.find('/');
  const std::string key = path.substr(0, slash);
  const yaml::Node& next =
      node.kind() == yaml::Node::Kind::kSequence ? node.items().at(std::stoul(key)) : *node.find(key);
  return slash == std::string::npos ? next : at(next, path.substr(slash + 1));
}

/// The text between the tags of a page's data.
inline std::string data_of(const std::string& page) {
  const std::string begin = "<script id=\"report-data\" type=\"application/json\">";
  const std::size_t from = page.find(begin);
  EXPECT_NE(from, std::string::npos);
  if (from == std::string::npos) return {};
  const std::size_t first = from + begin.size();
  return page.substr(first, page.find("</script>", first) - first);
}

}  // namespace armtune::internal::test
