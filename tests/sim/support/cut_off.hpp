#pragma once
// A text cut off anywhere: each of its beginnings is refused, or loads as something whole.

#include <gtest/gtest.h>

#include <cstddef>
#include <exception>
#include <string>

#include "armtune/error.hpp"

namespace armtune::internal::test {

/// What became of the beginnings of a text.
struct Cuts {
  std::size_t refused_before = 0;  ///< of those that lack something required
  std::size_t refused_after = 0;   ///< of the others, most of them in the middle of a line
  std::size_t loaded = 0;
};

/// Length up to which a beginning has no value yet for a key at the text's top.
inline std::size_t up_to_key(const std::string& text, const std::string& key) {
  const std::size_t at = ("\n" + text).find("\n" + key + ":");
  EXPECT_NE(at, std::string::npos) << key;
  return at == std::string::npos ? 0 : at + key.size() + 1;
}

/// Gives `load` the beginnings of the text: those that end with a line, before and behind its end, and every
/// `stride`th of the others. Up to `required`, a length, each must be refused. load: throws, or looks at what
/// it has loaded.
template <typename Load>
Cuts cut_off(const std::string& text, std::size_t required, std::size_t stride, Load&& load) {
  Cuts cuts;
  for (std::size_t length = 0; length < text.size(); ++length) {
    const bool line_ends = text[length] == '\n' || (length > 0 && text[length - 1] == '\n');
    if (!line_ends && length != required && length % stride != 0) continue;
    SCOPED_TRACE("the first " + std::to_string(length) + " bytes");
    try {
      load(text.substr(0, length));
      EXPECT_GT(length, required) << "loaded without what it cannot do without";
      ++cuts.loaded;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      ++(length <= required ? cuts.refused_before : cuts.refused_after);
    } catch (const std::exception& error) {
      ADD_FAILURE() << "not refused as input: " << error.what();
    }
  }
  return cuts;
}

}  // namespace armtune::internal::test
