#include "tuner/validation/horizon_curve.hpp"

#include <algorithm>

#include "tuner/validation/rms_interval.hpp"

namespace armtune::internal {

double HorizonCurve::yardstick(std::size_t horizon) const {
  return std::min(stays[horizon], keeps_velocity[horizon]);
}

HorizonCurve horizon_curve(const std::vector<WindowRun>& runs, int joint, std::size_t horizons) {
  HorizonCurve curve;
  std::vector<double> errors, stays, keeps_velocity;  // squares
  for (std::size_t h = 0; h < horizons; ++h) {
    for (std::vector<double>* squares : {&errors, &stays, &keeps_velocity}) squares->clear();
    double moved = 0.0, product = 0.0;
    for (const WindowRun& run : runs) {
      if (h >= run.time.size()) continue;
      const auto row = static_cast<Eigen::Index>(h);
      const double displacement = run.measured(row, joint) - run.measured(0, joint);
      const double error = run.simulated(row, joint) - run.measured(row, joint);
      const double unforeseen = displacement - run.start_velocity[joint] * run.time[h];
      errors.push_back(error * error);
      stays.push_back(displacement * displacement);
      keeps_velocity.push_back(unforeseen * unforeseen);
      moved += displacement * displacement;
      product += error * displacement;
    }
    const RmsInterval found = rms_interval(errors);
    curve.rms.push_back(found.rms);
    curve.low.push_back(found.low);
    curve.high.push_back(found.high);
    curve.stays.push_back(rms_interval(stays).rms);
    curve.keeps_velocity.push_back(rms_interval(keeps_velocity).rms);
    curve.slope.push_back(moved > 0.0 ? product / moved : 0.0);
  }
  return curve;
}

}  // namespace armtune::internal
