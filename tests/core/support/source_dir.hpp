#pragma once
// The folder of armtune's sources, for tests that read files of it. One file knows the path, so that a
// compiler cache takes the tests of one clone for those of another.

#include <string>

namespace armtune::internal::test {

/// Returns the absolute path of the repository, without a slash at its end.
std::string source_dir();

}  // namespace armtune::internal::test
