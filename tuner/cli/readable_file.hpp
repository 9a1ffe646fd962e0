#pragma once
// A check for options that name a file to be read.

namespace CLI {
class Validator;
}

namespace armtune::internal::cli {

/// Returns a validator that refuses a path with the system's own reason why it cannot be read. CLI11's
/// ExistingFile calls a file in a folder that may not be searched missing.
CLI::Validator readable_file();

}  // namespace armtune::internal::cli
