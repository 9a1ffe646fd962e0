// In place of the page where it is not built in.

#include "tuner/report/page.hpp"

namespace armtune::report {

std::string_view page_text() {
  return {};
}

}  // namespace armtune::report
