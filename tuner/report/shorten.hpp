#pragma once
// Shortens the data of a report page so that the page of a very large run keeps a limited size.

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Shortens the sections whose length depends on the run, except the recordings. They then take at most about
/// half of the page's 6 MB. `data.thinned` lists what is left out. Counts still include everything.
void shorten(ReportData& data);

/// Draws links as capsules instead of meshes, until the data take at most `bytes`. It replaces all meshes of
/// one arm at a time, beginning with the last arm, and adds the arm to `data.thinned`.
void drop_meshes(std::size_t bytes, ReportData& data);

/// Thins the evaluations if there are more than 20,000. It keeps the evaluation of the start gains and the
/// chosen evaluation. It divides all evaluations into groups of equally many consecutive ones. From each
/// group it keeps three: the best feasible one, the best infeasible one and the worst.
void thin(Evaluations& evaluations);

}  // namespace armtune::internal::report
