#include "tuner/quadratic/curvature_blocks.hpp"

namespace armtune::internal {

int CurvatureBlocks::add(const std::vector<int>& columns) {
  Block block;
  block.columns = static_cast<int>(columns.size());
  block.first_column = static_cast<int>(columns_.size());
  block.first_value = static_cast<int>(values_.size());
  columns_.insert(columns_.end(), columns.begin(), columns.end());
  if (gathered_.size() < block.columns) gathered_.resize(block.columns);
  values_.resize(values_.size() + columns.size() * columns.size(), 0.0);
  blocks_.push_back(block);
  return static_cast<int>(blocks_.size()) - 1;
}

CurvatureBlocks::Values CurvatureBlocks::values(int index) {
  const Block& block = blocks_[static_cast<std::size_t>(index)];
  return {values_.data() + block.first_value, block.columns, block.columns};
}

void CurvatureBlocks::add_product(const Eigen::VectorXd& x, Eigen::VectorXd& result) const {
  for (const Block& block : blocks_) {
    const int* column = columns(block);
    const double* value = values_.data() + block.first_value;
    auto sum = gathered_.head(block.columns);
    sum.setZero();
    for (int j = 0; j < block.columns; ++j, value += block.columns)
      sum += x[column[j]] * Eigen::Map<const Eigen::VectorXd>(value, block.columns);
    for (int i = 0; i < block.columns; ++i) result[column[i]] += sum[i];
  }
}

}  // namespace armtune::internal
