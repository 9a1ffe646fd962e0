#include "tuner/quadratic/block_rows.hpp"

namespace armtune::internal {
namespace {

using Row = Eigen::Map<const Eigen::VectorXd>;

}  // namespace

int BlockRows::add(int rows, const std::vector<int>& columns) {
  RowBlock block;
  block.first_row = rows_;
  block.rows = rows;
  block.first_column = static_cast<int>(columns_.size());
  block.columns = static_cast<int>(columns.size());
  block.first_value = static_cast<int>(values_.size());
  columns_.insert(columns_.end(), columns.begin(), columns.end());
  if (gathered_.size() < block.columns) gathered_.resize(block.columns);
  values_.resize(values_.size() + static_cast<std::size_t>(rows) * columns.size(), 0.0);
  rows_ += rows;
  blocks_.push_back(block);
  return static_cast<int>(blocks_.size()) - 1;
}

int BlockRows::add_diagonal(const std::vector<int>& columns) {
  RowBlock block;
  block.first_row = rows_;
  block.rows = static_cast<int>(columns.size());
  block.first_column = static_cast<int>(columns_.size());
  block.columns = block.rows;
  block.first_value = static_cast<int>(values_.size());
  block.diagonal = true;
  columns_.insert(columns_.end(), columns.begin(), columns.end());
  values_.resize(values_.size() + columns.size(), 0.0);
  rows_ += block.rows;
  blocks_.push_back(block);
  return static_cast<int>(blocks_.size()) - 1;
}

void BlockRows::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& result) const {
  result.resize(rows_);
  for (const RowBlock& block : blocks_) {
    const int* column = columns(block);
    const double* value = values(block);
    double* out = result.data() + block.first_row;
    if (block.diagonal) {
      for (int i = 0; i < block.rows; ++i) out[i] = value[i] * x[column[i]];
      continue;
    }
    if (block.rows == 1) {
      double sum = 0.0;
      for (int j = 0; j < block.columns; ++j) sum += value[j] * x[column[j]];
      *out = sum;
      continue;
    }
    for (int j = 0; j < block.columns; ++j) gathered_[j] = x[column[j]];
    for (int i = 0; i < block.rows; ++i, value += block.columns)
      out[i] = Row(value, block.columns).dot(gathered_.head(block.columns));
  }
}

void BlockRows::add_transposed(const Eigen::VectorXd& y, Eigen::VectorXd& result) const {
  for (const RowBlock& block : blocks_) {
    const int* column = columns(block);
    const double* value = values(block);
    const double* weight = y.data() + block.first_row;
    if (block.diagonal) {
      for (int i = 0; i < block.rows; ++i) result[column[i]] += value[i] * weight[i];
      continue;
    }
    if (block.rows == 1) {
      for (int j = 0; j < block.columns; ++j) result[column[j]] += value[j] * *weight;
      continue;
    }
    auto sum = gathered_.head(block.columns);
    sum = weight[0] * Row(value, block.columns);
    for (int i = 1; i < block.rows; ++i) sum += weight[i] * Row(value += block.columns, block.columns);
    for (int j = 0; j < block.columns; ++j) result[column[j]] += sum[j];
  }
}

}  // namespace armtune::internal
