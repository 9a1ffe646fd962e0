#pragma once
// A validator for options that name a file to be read.

namespace CLI {
class Validator;
}

namespace armtune::internal::cli {

/// Returns a validator that refuses a path that cannot be read, with the system's own reason. CLI11's
/// ExistingFile would report a file as missing if the user lacks the permission for its folder.
CLI::Validator readable_file();

}  // namespace armtune::internal::cli
