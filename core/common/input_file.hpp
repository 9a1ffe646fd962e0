#pragma once
// A file that the user named, as a text.

#include <cstddef>
#include <string>

namespace armtune {

/// The whole file; pipes and devices are read like files. Throws InputError with the path for one that is
/// missing, a directory, cannot be opened or read, or holds more than `max_bytes`: that much is read and no
/// more. `kind` is what messages call it: "a URDF file".
std::string read_input_file(const std::string& path, std::size_t max_bytes, const std::string& kind);

}  // namespace armtune
