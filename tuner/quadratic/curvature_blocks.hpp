#pragma once
// Stores a sparse symmetric matrix as a sum of small dense symmetric blocks. The matrix contains the second
// derivatives of the costs and constraints of a trajectory. Each block belongs to one knot (point of the time
// grid), or to one interval between two knots.

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace armtune::internal {

class CurvatureBlocks {
 public:
  struct Block {
    int columns = 0;
    int first_column = 0;
    int first_value = 0;  ///< columns x columns, symmetric
  };
  using Values = Eigen::Map<Eigen::MatrixXd>;
  using ConstValues = Eigen::Map<const Eigen::MatrixXd>;

  /// Adds a block with these rows and columns (strictly ascending). Returns its index.
  int add(const std::vector<int>& columns);

  const std::vector<Block>& blocks() const { return blocks_; }
  const int* columns(const Block& block) const { return columns_.data() + block.first_column; }
  Values values(int index);
  ConstValues values(const Block& block) const {
    return {values_.data() + block.first_value, block.columns, block.columns};
  }
  void set_zero() { std::fill(values_.begin(), values_.end(), 0.0); }

  /// Computes result += H x.
  void add_product(const Eigen::VectorXd& x, Eigen::VectorXd& result) const;

 private:
  std::vector<Block> blocks_;
  std::vector<int> columns_;
  std::vector<double> values_;
  mutable Eigen::VectorXd gathered_;  ///< work space of one block
};

}  // namespace armtune::internal
