#pragma once
// A run's rows in buckets of equal length. A plot keeps the smallest and the largest value of each bucket:
// what it shows at a bucket a pixel is what it would show with every row.

#include <span>
#include <vector>

namespace armtune::internal::report {

class Buckets {
 public:
  /// At most `most` buckets (>= 1) over `rows` rows; where each would hold two rows or fewer, every row is
  /// kept.
  Buckets(std::size_t rows, std::size_t most);

  bool whole() const { return count_ == 0; }
  std::size_t points() const { return whole() ? rows_ : 2 * count_; }

  /// Two times a bucket: its first row's and its middle one's. `time`: one per row, not decreasing.
  std::vector<double> times(std::span<const double> time) const;

  /// Two values a bucket: its smallest and its largest finite one, in the order in which they come; NaN where
  /// it holds none.
  std::vector<double> extremes(std::span<const double> column) const;

  /// First row of bucket b; of b = points() / 2 the end.
  std::size_t first_row(std::size_t b) const;

 private:
  std::size_t rows_;
  std::size_t count_;  ///< 0: every row is kept
};

}  // namespace armtune::internal::report
