// In place of the page where it is not built in.

#include "tuner/report/page.hpp"

namespace armtune::internal::report {

std::string_view page_text() {
  return {};
}

}  // namespace armtune::internal::report
