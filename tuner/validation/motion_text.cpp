#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tuner/validation/motion_validation.hpp"

namespace armtune::internal {
namespace {

std::string motion_text(const MotionValidation& found, const RobotModel& model, std::size_t joint) {
  const HorizonCurve& curve = found.joint[joint];
  const std::size_t at = found.index_of(found.judged);
  const char* unit = model.chain.motion[joint] == JointMotion::kRevolute ? "rad" : "m";
  const std::string& name = model.joints[joint].name;
  if (!std::isfinite(curve.rms[at]))
    return fmt::format("{}: every simulation diverged within {:.2g} s", name, found.judged);
  const std::string interval = std::isfinite(curve.low[at]) ? fmt::format(" (95 % interval {:.2g} to {:.2g})",
                                                                          curve.low[at], curve.high[at])
                                                            : "";
  return fmt::format("{}: {:.2g} {} RMS error after {:.2g} s{}, {:.2g} {} if it just kept its state; {}",
                     name, curve.rms[at], unit, found.judged, interval, curve.yardstick(at), unit,
                     found.excess[joint] <= 1.0 ? "the motion matches" : "the motion does not match");
}

}  // namespace

std::vector<std::string> sentences(const MotionValidation& found, const RobotModel& model) {
  std::vector<std::size_t> order(found.joint.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return found.excess[a] > found.excess[b]; });
  std::vector<std::string> all;
  for (const std::size_t j : order) all.push_back(motion_text(found, model, j));
  if (found.failed > 0) {
    all.push_back(fmt::format("{} of {} simulated windows diverged", found.failed, found.windows.size()));
  }
  if (found.at_limit > 0) {
    all.push_back(
        fmt::format("in {} of {} simulated windows a joint leaves its position limits, where the "
                    "model has no stops",
                    found.at_limit, found.windows.size()));
  }
  return all;
}

}  // namespace armtune::internal
