#pragma once
// Turns changes of metrics and other findings (findings.hpp) into sentences for the verdict of a report page.

#include <string>
#include <vector>

#include "tuner/report/findings.hpp"

namespace armtune::internal::report {

/// True if a ratio differs from 1 enough to be mentioned.
bool noticeable(double ratio);
/// True if a change is an improvement that is large enough to be mentioned.
bool improvement(const Change& change);

/// Returns, for example, "the largest orientation error falls by 62 %". Adds the scenario, or the number of
/// scenarios, if the change does not cover all.
std::string words(const Change& change, std::size_t all_scenarios);

/// Returns, for example,
/// "the largest orientation error (error/orientation/max) falls by 62 %, mean of a and b".
std::string exact_words(const Change& change, std::size_t all_scenarios);

/// Returns the best one or two improvements, or an empty text if there is none.
std::string improvements(const std::vector<Change>& all, std::size_t scenarios);

/// Returns which headline metric got worse the most, and where, or an empty text if none did.
std::string price(const std::vector<Table>& tables, std::size_t set);

/// Capitalises the first letter, unless the text begins with the name of a joint, a metric or a scenario.
std::string capital(std::string text);

/// Joins the parts that are not empty into one sentence.
std::string joined(const std::vector<std::string>& parts);

/// Returns the first line and the number of others, or an empty text without lines.
std::string first_of(const std::vector<std::string>& lines);

/// Appends at most `most` of the lines, and a line with the number of those left out.
void add(std::vector<std::string>& details, const std::vector<std::string>& lines, std::size_t most);

}  // namespace armtune::internal::report
