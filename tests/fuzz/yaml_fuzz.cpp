// Whatever the bytes: a tree within the limits, of which every value says what it is, or a line that refuses
// it.

#include "sim/yaml/document.hpp"
#include "tests/fuzz/support/input.hpp"

namespace armtune::internal::fuzz {
namespace {

void walk(const yaml::Node& node, std::size_t depth) {
  require(depth <= yaml::kMaxDepth && node.line() >= 1 && node.key_path().size() <= yaml::kMaxPathBytes);
  read_or_refuse([&] { node.as_number(); });
  read_or_refuse([&] { node.as_integer(); });
  read_or_refuse([&] { node.as_boolean(); });
  read_or_refuse([&] { node.as_string(); });
  read_or_refuse([&] { node.as_numbers(); });
  if (node.kind() == yaml::Node::Kind::kSequence) {
    for (const yaml::Node& item : node.items()) walk(item, depth + 1);
  } else if (node.kind() == yaml::Node::Kind::kMap) {
    for (const auto& [key, value] : node.entries()) {
      require(node.find(key) == &value);  // no key twice
      walk(value, depth + 1);
    }
  }
}

void check(std::string_view bytes) {
  read_or_refuse([&] { walk(yaml::parse_text(std::string(bytes), "input.yaml"), 0); });
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}
