#pragma once
// The engines that compute the accelerations of the simulated arm.

#include <array>
#include <string>

namespace armtune::internal {

enum class Engine {
  kSimbody,  ///< the library Simbody; the default for all results that are reported
  kNative    ///< armtune's own articulated-body dynamics in core; several times faster, for searches
};

inline constexpr std::array kEngines = {Engine::kSimbody, Engine::kNative};

constexpr const char* name(Engine engine) {
  switch (engine) {
    case Engine::kSimbody:
      return "simbody";
    case Engine::kNative:
      return "native";
  }
  return "";
}

/// Returns the engine of that name. Throws InputError that lists the valid names.
Engine engine_from_name(const std::string& text);

}  // namespace armtune::internal
