#pragma once
// Finds the gains that are one and the same number of the user's file. A study links such gains, so that the
// one place in the file gets one value.

#include <string>
#include <vector>

#include "tuner/controller_study/controller_in_file.hpp"

namespace armtune::internal {

/// A gain that shares its number.
struct SharedGain {
  const GainField* field;
  std::size_t component;  ///< index in the field
  std::string entry;      ///< name in the study: "jtc_p/elbow"
  std::string name;       ///< for messages: "p of elbow"
  double factor;          ///< the gain is this factor times the number in the file
};
using SharedNumber = std::vector<SharedGain>;

/// Returns the numbers of the file that stand for two or more of searched_fields(), through YAML aliases or
/// through lists of gains in a map.
std::vector<SharedNumber> shared_numbers(const ControllerInFile& from);

/// Returns the number that a gain shares, or null if it shares none.
const SharedNumber* number_of(const std::vector<SharedNumber>& shared, const GainField& field, std::size_t k);

/// Returns the lines of a study's `parameters` that link all gains of a number to `tuned`, one of them.
std::string link_lines(const SharedNumber& number, const SharedGain& tuned);

/// Returns a sentence that says which gains share numbers of the file, and how to separate them.
std::string sharing_note(const ControllerInFile& from, const std::vector<const SharedNumber*>& shared);

}  // namespace armtune::internal
