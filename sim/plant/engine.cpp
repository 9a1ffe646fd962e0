#include "sim/plant/engine.hpp"

#include "armtune/error.hpp"

namespace armtune::internal {

Engine engine_from_name(const std::string& text) {
  for (const Engine engine : kEngines) {
    if (text == name(engine)) return engine;
  }
  throw InputError(InputPlace{.key = "engine"}, "'" + text + "' is not known; use simbody or native")
      .with_value(text, "simbody or native");
}

}  // namespace armtune::internal
