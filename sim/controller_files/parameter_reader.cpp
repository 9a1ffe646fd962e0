#include "sim/controller_files/parameter_reader.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <system_error>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

/// Returns true if all YAML readers read the digits as the same number. YAML 1.1 reads 010 as octal. In
/// ROS 1, 3e2 is a text.
bool is_same_to_all(std::string_view digits, bool ros2) {
  if (digits.size() > 1 && digits[0] == '0' && digits[1] >= '0' && digits[1] <= '9') return false;
  return ros2 || digits.find_first_of("eE") == std::string_view::npos ||
         digits.find('.') != std::string_view::npos;
}

}  // namespace

void ParameterReader::fail(int line, const std::string& what, const std::string& value,
                           const std::string& limit) const {
  throw InputError(at_line(file_, line, controller_.name), fmt::format("{}: {}", controller_.name, what))
      .with_value(value, limit);
}

InputError ParameterReader::error(const yaml::PlacedValue& value, const std::string& problem,
                                  const std::string& limit) const {
  return {at_line(file_, value.line, controller_.name),
          InputFault{fmt::format("{}: {}", controller_.name, problem), value.text, limit}};
}

double ParameterReader::number(const yaml::PlacedValue& value, const std::string& what) const {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  std::string_view text = value.text;
  if (value.kind == yaml::PlacedValue::Kind::kScalar) {
    const bool minus = text.starts_with('-');
    const std::string_view size = text.substr(minus || text.starts_with('+') ? 1 : 0);
    if (size == ".inf" || size == ".Inf" || size == ".INF") return minus ? -kUnbounded : kUnbounded;
    double number = 0.0;
    const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), number);
    if (error == std::errc() && end == size.data() + size.size() && std::isfinite(number) &&
        !size.starts_with('-') && value.has_place() && is_same_to_all(size, controller_.ros2))
      return minus ? -number : number;
  }
  throw error(value, fmt::format("{} is {}", what, shown(value.text)),
              fmt::format("a plain number without quotes, tags or leading zeros{}",
                          controller_.ros2 ? "" : ", with a decimal point before an exponent"));
}

double ParameterReader::finite(const yaml::PlacedValue& value, const std::string& what) const {
  const double found = number(value, what);
  if (!std::isfinite(found)) throw error(value, fmt::format("{} is {}", what, value.text), "a finite number");
  return found;
}

}  // namespace armtune::internal
