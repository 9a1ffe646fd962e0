#pragma once
// Stores a sparse Jacobian as small dense blocks of rows. A trajectory optimisation adds one block for each
// knot (point of the time grid), or for each interval between two knots. The sparsity pattern is set up once.
// Afterwards only the values change.

#include <Eigen/Core>
#include <vector>

namespace armtune::internal {

/// A group of neighbouring rows that depend on the same columns.
struct RowBlock {
  int first_row = 0;
  int rows = 0;
  int first_column = 0;  ///< index into BlockRows::columns
  int columns = 0;
  int first_value = 0;    ///< index of the block's values: rows x columns, row by row; diagonal: one per row
  bool diagonal = false;  ///< true if row i depends on column i only
};

class BlockRows {
 public:
  /// Adds rows that depend on `columns` (strictly ascending). Returns the block's index.
  int add(int rows, const std::vector<int>& columns);
  /// Adds one row for each of `columns`; each row depends on its column only. Returns the block's index.
  int add_diagonal(const std::vector<int>& columns);

  int rows() const { return rows_; }
  const std::vector<RowBlock>& blocks() const { return blocks_; }
  const RowBlock& block(int index) const { return blocks_[static_cast<std::size_t>(index)]; }
  const int* columns(const RowBlock& block) const { return columns_.data() + block.first_column; }
  double* values(const RowBlock& block) { return values_.data() + block.first_value; }
  const double* values(const RowBlock& block) const { return values_.data() + block.first_value; }

  /// Computes result = J x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& result) const;
  /// Computes result += J^T y.
  void add_transposed(const Eigen::VectorXd& y, Eigen::VectorXd& result) const;

 private:
  int rows_ = 0;
  std::vector<RowBlock> blocks_;
  std::vector<int> columns_;
  std::vector<double> values_;
  mutable Eigen::VectorXd gathered_;  ///< work space of one block
};

}  // namespace armtune::internal
