#include "core/common/file_name.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/common/utf8.hpp"

namespace armtune::internal {

void check_file_name(const std::string& name, const std::string& path, std::size_t longest) {
  if (name.size() > longest) {
    throw InputError(
        InputPlace{path},
        fmt::format(
            "the name has {} bytes, which is too long for the names of result files; rename the file to at "
            "most {} bytes",
            name.size(), longest))
        .with_value(std::to_string(name.size()), fmt::format("at most {} bytes", longest));
  }
  if (is_printable(name)) return;
  throw InputError(InputPlace{path},
                   "the file name contains a control character, a line separator or a byte that is not "
                   "UTF-8; rename the file, because result files take their names from it");
}

void check_result_name(const std::string& name, const std::string& path, std::size_t longest) {
  if (name.find_first_of(",\"") != std::string::npos) {
    throw InputError(InputPlace{path},
                     "the file name contains a comma or a quote, which would break CSV files; rename it");
  }
  if (is_formula(name)) {
    throw InputError(
        InputPlace{path},
        "the file name begins like a spreadsheet formula; rename the file, because CSV files contain its "
        "name");
  }
  check_file_name(name, path, longest);
}

}  // namespace armtune::internal
