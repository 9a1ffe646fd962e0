#pragma once
// Short stretches of a log, over which its channels are compared, to find out whether one is the derivative
// or a multiple of another. Sums over stretches are used instead of differences of neighbouring rows, because
// these would mostly show the noise and the resolution of the recording.

#include <cstddef>
#include <vector>

namespace armtune::internal {

/// How two channels are related.
struct Relation {
  double factor = 0.0;       ///< the second channel's values are this many times those of the first
  double correlation = 0.0;  ///< between -1 and 1; 0: not enough data, or one of them does not change
};

/// Collects stretches of at least 10 steps and 50 ms. For each stretch and channel it keeps the change from
/// the first to the last row, and the integral over time (trapezoidal rule). To bound the memory, it keeps
/// every 2^k-th stretch, at most 500, and fewer if there are many channels.
class MotionBlocks {
 public:
  /// Adds a row. A row whose time is not larger than that of the row before is left out. Missing values (NaN)
  /// exclude their channel from the stretch. `value` may have more channels than before.
  void add(double time, const std::vector<double>& value);

  std::size_t size() const { return kept_.size(); }
  /// Compares the derivative of channel `a` with channel `b`: factor 1 means b = da/dt. The integral of b
  /// over a stretch is compared with the change of a.
  Relation derivative(std::size_t a, std::size_t b) const;
  /// Compares the means over stretches without their overall mean: factor k means b = k * a + constant.
  Relation multiple(std::size_t a, std::size_t b) const;
  /// Returns the RMS change of a channel over a stretch.
  double rms_change(std::size_t channel) const;

 private:
  struct Block {
    double duration = 0.0;
    std::vector<double> change, integral;  ///< one per channel
  };
  void finish(const std::vector<double>& value);

  std::vector<Block> kept_;
  std::size_t seen_ = 0;
  std::size_t step_ = 1;  ///< every step_-th stretch is kept
  Block open_;
  std::vector<double> first_, last_;  ///< values in the first and last row of the open stretch
  double last_time_ = 0.0;
  int steps_ = -1;  ///< of the open stretch; -1: it has no row
};

}  // namespace armtune::internal
