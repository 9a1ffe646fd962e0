#include "tuner/study/shared_gains.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <unordered_map>

#include "armtune/error.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/controller_files/parameter_file.hpp"

namespace armtune::internal {
namespace {

/// Returns gains of the search at which no two parameters have the same coordinate. Multiples of the golden
/// ratio, modulo 1, are all different.
Gains gains_inside(const ParameterSpace& space) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  std::vector<double> x(space.free.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::fmod(static_cast<double>(i + 1) * kGoldenRatio, 1.0);
  return space.gains_at(x);
}

bool differ(const PlacedGain& a, const PlacedGain& b) {
  // The factors of a map round the last digit.
  return std::abs(a.value - b.value) > 4.0 * std::numeric_limits<double>::epsilon() * std::abs(a.value);
}

}  // namespace

void refuse_split_numbers(const Study& study) {
  if (study.gains.empty()) return;
  const std::vector<std::string> joints = joint_names(*study.scenarios.front().robot);
  const auto file = read_parameter_file(study.gains, study.node, study.distro, joints);
  if (!file) return;
  const Gains now = controller_gains(file->controller, file->path, joints);
  if (now.controller != study.space.start.controller) return;
  const auto in_file = placed_gains(file->controller, file->path, now, joints);
  const auto tuned = placed_gains(file->controller, file->path, gains_inside(study.space), joints);
  std::unordered_map<const yaml::PlacedValue*, std::size_t> firsts;
  for (std::size_t k = 0; k < tuned.size(); ++k) {
    if (tuned[k].at == nullptr) continue;
    const std::size_t first = firsts.emplace(tuned[k].at, k).first->second;
    if (differ(in_file[first], in_file[k]) || !differ(tuned[first], tuned[k])) continue;
    const double factor = tuned[k].factor / tuned[first].factor;
    const std::string link = fmt::format("{{name: {}, link: {}{}}}", tuned[k].entry, tuned[first].entry,
                                         factor == 1.0 ? "" : fmt::format(", factor: {}", factor));
    throw InputError(
        InputPlace{where(study), 0, tuned[k].entry},
        fmt::format("{} and {} share one number, at line {} of {}, but the study can give them "
                    "different values; link them under 'parameters' with '{}', or write a number "
                    "for each in that file",
                    tuned[first].entry, tuned[k].entry, tuned[k].at->line, file->path, link))
        .with_value({}, link);
  }
}

}  // namespace armtune::internal
