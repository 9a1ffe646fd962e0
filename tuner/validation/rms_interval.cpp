#include "tuner/validation/rms_interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace armtune::internal {
namespace {

constexpr std::size_t kFewestBatches = 3;
constexpr std::size_t kMostBatches = 8;
constexpr std::size_t kBatch = 4;  ///< squares in a batch, if there are few
/// Two-sided 95 % quantiles of Student's distribution with 2, 3, ... 7 degrees of freedom.
constexpr std::array kStudent = {4.303, 3.182, 2.776, 2.571, 2.447, 2.365};

}  // namespace

RmsInterval rms_interval(const std::vector<double>& squares) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (squares.empty()) return {kNone, kNone, kNone};
  const std::size_t count = squares.size();
  const double mean = std::accumulate(squares.begin(), squares.end(), 0.0) / static_cast<double>(count);
  const double rms = std::sqrt(mean);
  if (count < kFewestSquares) return {rms, kNone, kNone};
  if (!(mean > 0.0)) return {rms, rms, rms};
  const std::size_t batches = std::clamp(count / kBatch, kFewestBatches, kMostBatches);
  double variance = 0.0;
  for (std::size_t b = 0; b < batches; ++b) {
    const std::size_t begin = b * count / batches;
    const std::size_t end = (b + 1) * count / batches;
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) sum += squares[i];
    const double apart = sum / static_cast<double>(end - begin) - mean;
    variance += apart * apart;
  }
  variance /= static_cast<double>(batches - 1);
  const double relative = std::sqrt(variance / static_cast<double>(batches)) / mean;
  const double factor = std::exp(0.5 * kStudent[batches - kFewestBatches] * relative);
  return {rms, rms / factor, rms * factor};
}

}  // namespace armtune::internal
