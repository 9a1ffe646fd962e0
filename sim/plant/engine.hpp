#pragma once
// What computes the accelerations of the simulated arm.

#include <array>
#include <string>

namespace armtune::internal {

enum class Engine {
  kSimbody,  ///< the judge: every figure that is reported comes from it
  kNative    ///< core's articulated-body dynamics: the same arm several times faster, to search with
};

inline constexpr std::array kEngines = {Engine::kSimbody, Engine::kNative};

constexpr const char* name(Engine engine) {
  return engine == Engine::kSimbody ? "simbody" : "native";
}

/// Throws InputError that lists the names there are.
Engine engine_from_name(const std::string& text);

}  // namespace armtune::internal
