#pragma once
// What a page of a run with very much in it shows of each section.

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Shortens the sections of a page that grow with the run, all but the recordings, so that they take no more
/// than about half of its 6 MB. What is left out is said in `data.thinned`, and counts are of everything
/// still.
void shorten(ReportData& data);

/// Draws links in place of their meshes, on the last arms first, until the data take no more than `bytes`.
/// Says in `data.thinned` on which arms.
void drop_meshes(std::size_t bytes, ReportData& data);

/// Keeps at most 20,000 evaluations: the start, the chosen one, and of equally many that follow each other
/// the best feasible one, the best of the others and the worst.
void thin(Evaluations& evaluations);

}  // namespace armtune::internal::report
