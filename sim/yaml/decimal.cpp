#include "sim/yaml/decimal.hpp"

#include <fmt/format.h>

namespace armtune::internal::yaml {

std::string decimal(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find('.') != std::string::npos) return text;
  const auto exponent = text.find('e');
  return exponent == std::string::npos ? text + ".0" : text.insert(exponent, ".0");
}

}  // namespace armtune::internal::yaml
