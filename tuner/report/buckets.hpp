#pragma once
// Thins the rows of a recorded rollout for a plot. The rows are divided into buckets, that is, groups of
// equally many consecutive rows. The plot keeps only the smallest and the largest value of each bucket. With
// one bucket per pixel, this plot looks the same as a plot of all rows.

#include <span>
#include <vector>

namespace armtune::internal::report {

class Buckets {
 public:
  /// Divides the rows into `most` (>= 1) buckets. If a bucket would hold two rows or fewer, there are no
  /// buckets, and every row is kept.
  Buckets(std::size_t rows, std::size_t most);

  /// True if every row is kept.
  bool whole() const { return count_ == 0; }
  /// Returns the number of points of a plot: one per row if every row is kept, otherwise two per bucket.
  std::size_t points() const { return whole() ? rows_ : 2 * count_; }

  /// Returns the time of every point: the time of a bucket's first row, then that of its middle row. time:
  /// the time of every row; must not decrease.
  std::vector<double> times(std::span<const double> time) const;

  /// Returns the value of every point: the smallest and the largest finite value of a bucket, in the order of
  /// their rows. Both are NaN if the bucket has no finite value. column: one value per row.
  std::vector<double> extremes(std::span<const double> column) const;

  /// Returns the index of the first row of bucket b. For b equal to the number of buckets, returns the number
  /// of rows. Requires !whole().
  std::size_t first_row(std::size_t b) const;

 private:
  std::size_t rows_;
  std::size_t count_;  ///< number of buckets; 0: every row is kept
};

}  // namespace armtune::internal::report
