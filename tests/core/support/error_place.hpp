#pragma once
// The place of an error, which its message names for people and its fields for programs.

#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "armtune/error.hpp"

namespace armtune::internal::test {

/// Expects the fields to hold the file, the line and the key of YAML that the message begins with.
inline void expect_place(const InputError& error) {
  static const std::regex kPlace("^([^:]*):([0-9]+): (key '([^']*)': )?");
  std::cmatch found;
  if (!std::regex_search(error.what(), found, kPlace)) return;
  EXPECT_EQ(error.place().file, found[1].str()) << error.what();
  EXPECT_EQ(std::to_string(error.place().line), found[2].str()) << error.what();
  if (found[3].matched) {
    EXPECT_EQ(error.place().key, found[4].str()) << error.what();
  }
}

}  // namespace armtune::internal::test
