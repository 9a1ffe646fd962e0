#include "tuner/report/page.hpp"

#include <stdexcept>

#include "armtune/error.hpp"

namespace armtune::internal::report {

std::string filled_page(std::string_view page, std::string_view json) {
  constexpr std::string_view kMark = "<!--report-data-->";
  const std::size_t at = page.find(kMark);
  if (at == std::string_view::npos || page.find(kMark, at + 1) != std::string_view::npos) {
    throw FailedError(
        "the report page built into armtune has no place for its data, or several; build armtune again");
  }
  std::string filled;
  filled.reserve(page.size() + json.size() + 100);
  filled += page.substr(0, at);
  filled += "<script id=\"report-data\" type=\"application/json\">";
  filled += json;
  filled += "</script>";
  filled += page.substr(at + kMark.size());
  return filled;
}

}  // namespace armtune::internal::report
