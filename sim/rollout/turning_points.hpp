#pragma once
// Finds the turning points of a series, such as the torque of a joint: the points at which it stops rising
// and begins to fall, or the other way round. Small movements to and fro, such as noise, do not count.

#include <algorithm>
#include <cmath>

namespace armtune::internal {

class TurningPoints {
 public:
  /// Adds the next value of the series. Returns true if the series has turned: it has moved back by at least
  /// `smallest` from its extreme. Values that are not numbers are left out.
  bool look(double time, double value, double smallest) {
    if (std::isnan(value)) return false;
    bool turns = false;
    if (direction_ == 0) {
      // While the direction is not known: the lowest and the highest value so far.
      turned_ = looked_ ? std::min(turned_, value) : value;
      extreme_ = looked_ ? std::max(extreme_, value) : value;
      looked_ = true;
      if (extreme_ - turned_ < smallest) return false;
      direction_ = value > turned_ ? 1 : -1;
      if (direction_ < 0) turned_ = extreme_;
    } else if (direction_ * (value - extreme_) <= 0.0) {
      if (std::abs(value - extreme_) < smallest) return false;
      turns = true;
      swing_ = std::abs(extreme_ - turned_);
      turn_time_ = time_;
      turned_ = extreme_;
      direction_ = -direction_;
    }
    extreme_ = value;
    time_ = time;
    return turns;
  }

  /// Returns the time of the last turning point.
  double at() const { return turn_time_; }
  /// Returns the distance of the last turning point from the one before it, or from the first value.
  double swing() const { return swing_; }

 private:
  int direction_ = 0;     ///< 1: the series rises, -1: it falls, 0: not known yet
  bool looked_ = false;   ///< true after the first value
  double extreme_ = 0.0;  ///< farthest value since the last turning point
  double time_ = 0.0;     ///< time of the extreme
  double turned_ = 0.0;   ///< value at the last turning point
  double turn_time_ = 0.0;
  double swing_ = 0.0;
};

}  // namespace armtune::internal
