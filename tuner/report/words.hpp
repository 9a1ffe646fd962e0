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

/// Returns, for example, "the largest orientation error falls by 62 %". If the change does not cover all
/// scenarios, the text also names its scenario or gives their number. all_scenarios: number of all scenarios.
std::string words(const Change& change, std::size_t all_scenarios);

/// Returns, for example,
/// "the largest orientation error (error/orientation/max) falls by 62 %, mean of a and b".
std::string exact_words(const Change& change, std::size_t all_scenarios);

/// Returns the one or two best improvements as a text; empty if there is none. all: best improvement first.
std::string improvements(const std::vector<Change>& all, std::size_t scenarios);

/// Returns a clause about the headline metric that got worse by the largest ratio, with its scenario. The
/// text is empty if no headline metric got noticeably worse.
std::string price(const std::vector<Table>& tables, std::size_t set);

/// Capitalises the first letter, unless the text begins with the name of a joint, a metric or a scenario.
std::string capital(std::string text);

/// Joins the parts that are not empty into one sentence.
std::string joined(const std::vector<std::string>& parts);

/// Returns the first line, followed by the number of further lines; empty if there are no lines.
std::string first_of(const std::vector<std::string>& lines);

/// Appends the first `most` lines to `details`, and then the number of lines that are left out.
void add(std::vector<std::string>& details, const std::vector<std::string>& lines, std::size_t most);

}  // namespace armtune::internal::report
