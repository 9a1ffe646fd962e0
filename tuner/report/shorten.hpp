#pragma once
// Shortens the data of a report page so that the page of a very large run keeps a limited size.

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Shortens the sections of a page that grow with the run, except the recordings, so that they take at most
/// about half of its 6 MB. `data.thinned` says what is left out. Counts still include everything.
void shorten(ReportData& data);

/// Draws links as capsules instead of meshes, beginning with the last arm, until the data take at most
/// `bytes`. Adds the arms to `data.thinned`.
void drop_meshes(std::size_t bytes, ReportData& data);

/// Keeps at most 20,000 evaluations. If there are more, it keeps the start, the chosen one, and, from groups
/// of equally many consecutive ones, the best feasible one, the best infeasible one and the worst.
void thin(Evaluations& evaluations);

}  // namespace armtune::internal::report
