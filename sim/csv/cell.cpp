#include "sim/csv/cell.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/common/message_text.hpp"

namespace armtune::internal {

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

std::string cell(const std::string& text) {
  if (is_formula(text)) return cell("'" + text);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace armtune::internal
