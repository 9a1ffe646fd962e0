#include "core/common/file_name.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/common/utf8.hpp"

namespace armtune::internal {

void check_file_name(const std::string& name, const std::string& path, std::size_t longest) {
  if (name.size() > longest) {
    throw InputError(fmt::format(
        "{}: the name has {} bytes, and files of results are called after it; rename it to one of "
        "at most {}",
        path, name.size(), longest));
  }
  if (is_printable(name)) return;
  throw InputError(
      fmt::format("{}: the name holds a control character, a line separator or a byte that is not UTF-8, and "
                  "files of results are called after it; rename it",
                  path));
}

void check_result_name(const std::string& name, const std::string& path, std::size_t longest) {
  if (name.find_first_of(",\"") != std::string::npos) {
    throw InputError(path + ": the name holds a comma or a quote, and would break the CSV files; rename it");
  }
  if (is_formula(name)) {
    throw InputError(fmt::format(
        "{}: the name begins like a spreadsheet's formula; rename the file (CSV files use it)", path));
  }
  check_file_name(name, path, longest);
}

}  // namespace armtune::internal
