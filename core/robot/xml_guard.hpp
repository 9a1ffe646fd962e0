#pragma once
// Checks the text of a URDF before the XML parser reads it, because some texts would crash the program. The
// parser tinyxml calls itself once per nesting level, so deep nesting overflows the stack. Where urdfdom
// expects a number and finds other text, it gives this text to printf as the format string.

#include <string>

namespace armtune::internal {

/// Returns the text of an expanded URDF that is safe to pass to urdfdom. A xacro file is expanded first if
/// the user has allowed it (see XacroExpansion); lines in messages are then those of the expanded text.
/// Velocity and effort limits that a moving joint does not give are added as 0. Throws InputError, naming
/// file and (if known) line, for:
///   - a file that cannot be read, is a directory, empty, larger than 32 MB, UTF-16 or binary,
///   - SDF, MJCF, or xacro that is not expanded, or that xacro cannot expand,
///   - a tag or comment without its end,
///   - a second `<inertial>`, `<axis>`, ... in one link or joint,
///   - elements nested deeper than 1,000,
///   - more than 10,000 links, 200,000 elements, or 100 attributes in one tag,
///   - a `%` or a character reference in any attribute except `filename`.
/// All other errors are left to urdfdom.
std::string read_guarded_urdf(const std::string& path);

}  // namespace armtune::internal
