#include "tests/core/support/source_dir.hpp"

namespace armtune::internal::test {

std::string source_dir() {
  return ARMTUNE_SOURCE_DIR;
}

}  // namespace armtune::internal::test
