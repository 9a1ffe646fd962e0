#include "tuner/quadratic/normal_matrix.hpp"

#include <algorithm>

namespace armtune::internal {
namespace {

/// Returns the index of the entry (row, column), row <= column, in the values of the matrix.
int place_of(const SymmetricMatrix& matrix, int row, int column) {
  const auto c = static_cast<std::size_t>(column);
  const auto begin = matrix.rows.begin() + matrix.column_starts[c];
  const auto end = matrix.rows.begin() + matrix.column_starts[c + 1];
  return static_cast<int>(std::lower_bound(begin, end, row) - matrix.rows.begin());
}

}  // namespace

template <typename Visit>
void NormalMatrix::for_dense_blocks(const Visit& visit) const {
  for (const CurvatureBlocks::Block& block : curvature_.blocks())
    visit(curvature_.columns(block), block.columns);
  for (const BlockRows* part : parts_) {
    for (const RowBlock& block : part->blocks()) {
      if (!block.diagonal) visit(part->columns(block), block.columns);
    }
  }
}

NormalMatrix::NormalMatrix(int size, const CurvatureBlocks& curvature,
                           const std::vector<const BlockRows*>& parts)
    : curvature_(curvature), parts_(parts) {
  std::vector<std::vector<int>> rows_of(static_cast<std::size_t>(size));
  for (int c = 0; c < size; ++c) rows_of[static_cast<std::size_t>(c)].push_back(c);
  for_dense_blocks([&](const int* column, int columns) {
    for (int j = 0; j < columns; ++j) {
      auto& rows = rows_of[static_cast<std::size_t>(column[j])];
      rows.insert(rows.end(), column, column + j);
      // Remove duplicates now and then, because thousands of blocks may share a column.
      if (rows.size() > 256 && rows.size() == rows.capacity()) {
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      }
    }
  });
  matrix_.size = size;
  matrix_.column_starts.reserve(static_cast<std::size_t>(size) + 1);
  matrix_.column_starts.push_back(0);
  for (auto& rows : rows_of) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    matrix_.rows.insert(matrix_.rows.end(), rows.begin(), rows.end());
    matrix_.column_starts.push_back(static_cast<int>(matrix_.rows.size()));
    rows = {};
  }
  matrix_.values.assign(matrix_.rows.size(), 0.0);
  // The diagonal entry is the last one in its column.
  for (auto end = matrix_.column_starts.begin() + 1; end != matrix_.column_starts.end(); ++end)
    diagonal_places_.push_back(*end - 1);
  int widest = 0;
  for_dense_blocks([&](const int* column, int columns) {
    widest = std::max(widest, columns);
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j <= i; ++j) places_.push_back(place_of(matrix_, column[j], column[i]));
    }
  });
  product_.resize(static_cast<std::size_t>(widest));
}

void NormalMatrix::assemble(const Eigen::VectorXd& diagonal,
                            const std::vector<const Eigen::VectorXd*>& weights) {
  std::fill(matrix_.values.begin(), matrix_.values.end(), 0.0);
  double* K = matrix_.values.data();
  for (Eigen::Index c = 0; c < diagonal.size(); ++c)
    K[diagonal_places_[static_cast<std::size_t>(c)]] = diagonal[c];
  const int* place = places_.data();
  for (const CurvatureBlocks::Block& block : curvature_.blocks()) {
    const auto values = curvature_.values(block);
    for (int i = 0; i < block.columns; ++i) {
      for (int j = 0; j <= i; ++j) K[*place++] += values(j, i);
    }
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const BlockRows& part = *parts_[p];
    const double* weight = weights[p]->size() == 0 ? nullptr : weights[p]->data();
    for (const RowBlock& block : part.blocks()) {
      const double* value = part.values(block);
      const auto weight_of = [&](int row) { return weight == nullptr ? 1.0 : weight[block.first_row + row]; };
      if (block.diagonal) {
        const int* column = part.columns(block);
        for (int i = 0; i < block.rows; ++i)
          K[diagonal_places_[static_cast<std::size_t>(column[i])]] += value[i] * value[i] * weight_of(i);
        continue;
      }
      for (int i = 0; i < block.columns; ++i) {
        double* product = product_.data();
        const double first = weight_of(0) * value[i];
        for (int j = 0; j <= i; ++j) product[j] = first * value[j];
        const double* row = value;
        for (int r = 1; r < block.rows; ++r) {
          row += block.columns;
          const double weighted = weight_of(r) * row[i];
          for (int j = 0; j <= i; ++j) product[j] += weighted * row[j];
        }
        for (int j = 0; j <= i; ++j) K[*place++] += product[j];
      }
    }
  }
}

}  // namespace armtune::internal
