// Replaces the page if armtune is built without it.

#include "tuner/report/page.hpp"

namespace armtune::internal::report {

std::string_view page_text() {
  return {};
}

}  // namespace armtune::internal::report
