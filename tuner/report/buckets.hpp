#pragma once
// Thins the rows of a recorded rollout for a plot. The rows are divided into buckets of equal length, and the
// plot keeps the smallest and the largest value of each. With one bucket per pixel it looks the same as with
// every row.

#include <span>
#include <vector>

namespace armtune::internal::report {

class Buckets {
 public:
  /// Makes at most `most` buckets (>= 1) over `rows` rows. If each would hold two rows or fewer, every row is
  /// kept.
  Buckets(std::size_t rows, std::size_t most);

  bool whole() const { return count_ == 0; }
  std::size_t points() const { return whole() ? rows_ : 2 * count_; }

  /// Returns two times per bucket: of its first and of its middle row. time: one per row, not decreasing.
  std::vector<double> times(std::span<const double> time) const;

  /// Returns two values per bucket, its smallest and its largest finite one, in the order of their rows. They
  /// are NaN if the bucket holds no finite value.
  std::vector<double> extremes(std::span<const double> column) const;

  /// Returns the first row of bucket b, or the number of rows for b = points() / 2.
  std::size_t first_row(std::size_t b) const;

 private:
  std::size_t rows_;
  std::size_t count_;  ///< number of buckets; 0: every row is kept
};

}  // namespace armtune::internal::report
