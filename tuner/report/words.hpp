#pragma once
// Findings as a reader is told of them.

#include <string>
#include <vector>

#include "tuner/report/findings.hpp"

namespace armtune::internal::report {

/// Whether a ratio is worth a word.
bool noticeable(double ratio);
/// Whether a change is for the better, by more than that.
bool improvement(const Change& change);

/// "the largest orientation error falls by 62 %", with the number of scenarios where it is not of all.
std::string words(const Change& change, std::size_t all_scenarios);

/// "the largest orientation error (error/orientation/max) falls by 62 %, mean of a and b"
std::string exact_words(const Change& change, std::size_t all_scenarios);

/// The best one or two improvements; empty if there is none.
std::string improvements(const std::vector<Change>& all, std::size_t scenarios);

/// Which headline got worse the most, and where; empty if none did.
std::string price(const std::vector<Table>& tables, std::size_t set);

/// With a capital letter, unless it begins with the name of a joint, a metric or a scenario.
std::string capital(std::string text);

/// The parts that are not empty as one sentence.
std::string joined(const std::vector<std::string>& parts);

/// The first of the lines, and how many others there are; empty without one.
std::string first_of(const std::vector<std::string>& lines);

/// Appends the lines, at most so many, and says how many are left out.
void add(std::vector<std::string>& details, const std::vector<std::string>& lines, std::size_t most);

}  // namespace armtune::internal::report
