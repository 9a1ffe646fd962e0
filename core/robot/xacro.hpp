#pragma once
// Expands xacro files to URDF by the program `xacro`. This program evaluates Python expressions that are in
// the file. Therefore it is run only if the user has asked for it, that is, only while an object of the class
// XacroExpansion exists.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace armtune::internal {

struct XacroOptions {
  std::vector<std::string> arguments;  ///< arguments of the file, as NAME:=VALUE
  double time_limit = 60.0;            ///< wall-clock time after which xacro is killed [s]
  /// Called with the command before it is run. The command can be copied into a shell.
  std::function<void(const std::string& command)> starting;
};

/// While an object of this class exists, this process may expand xacro files. Only one object may exist at a
/// time, and all threads share it. Each file is expanded once; later readers get the same text.
class XacroExpansion {
 public:
  /// Throws InputError if an argument is not of the form NAME:=VALUE, where NAME has letters, digits and
  /// underscores.
  explicit XacroExpansion(XacroOptions options);
  ~XacroExpansion();
  XacroExpansion(const XacroExpansion&) = delete;
  XacroExpansion& operator=(const XacroExpansion&) = delete;
};

/// Returns the URDF to which xacro expands the file, or nothing if there is no XacroExpansion. Throws
/// InputError if xacro is not installed, fails, takes longer than the time limit, or writes nothing or more
/// than `most` bytes. The message has what xacro wrote on standard error, as one line.
std::optional<std::string> expanded_xacro(const std::string& path, std::size_t most);

}  // namespace armtune::internal
