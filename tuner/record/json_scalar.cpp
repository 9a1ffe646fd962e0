#include "tuner/record/json_scalar.hpp"

#include <nlohmann/json.hpp>

namespace armtune::internal::record {

std::string json_scalar(std::string_view text) {
  std::string escaped;
  for (const char c : nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)) {
    if (c == '<' || c == '\x7f') {
      escaped += c == '<' ? "\\u003c" : "\\u007f";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string json_scalar(double number) {
  return nlohmann::json(number).dump();
}

}  // namespace armtune::internal::record
