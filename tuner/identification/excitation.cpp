#include "tuner/identification/excitation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/trajectory/quintic.hpp"
#include "sim/csv/cell.hpp"
#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

MotionPoint<JointVector> series(const Excitation& e, double t) {
  const auto n = e.center.size();
  MotionPoint<JointVector> point{JointVector::Zero(n), JointVector::Zero(n), JointVector::Zero(n)};
  for (Eigen::Index l = 0; l < e.sine.cols(); ++l) {
    const double w = 2.0 * M_PI * e.frequency * static_cast<double>(l + 1);
    const double s = std::sin(w * t);
    const double c = std::cos(w * t);
    point.position += s * e.sine.col(l) + c * e.cosine.col(l);
    point.velocity += w * (c * e.sine.col(l) - s * e.cosine.col(l));
    point.acceleration -= w * w * (s * e.sine.col(l) + c * e.cosine.col(l));
  }
  return point;
}

Eigen::MatrixXd read_coefficients(const yaml::Node& node, const std::vector<std::string>& joints) {
  yaml::MapReader map(node);
  Eigen::MatrixXd coefficients;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const yaml::Node& entry = map.required(joints[j]);
    const auto values = entry.as_numbers();
    if (j == 0)
      coefficients.resize(static_cast<Eigen::Index>(joints.size()), static_cast<Eigen::Index>(values.size()));
    if (values.empty() || static_cast<Eigen::Index>(values.size()) != coefficients.cols()) {
      const std::string limit = "the same number of harmonics for every joint, at least one";
      entry.fail(InputFault{.problem = fmt::format("has {} numbers", values.size()),
                            .value = std::to_string(values.size()),
                            .limit = limit});
    }
    coefficients.row(static_cast<Eigen::Index>(j)) =
        Eigen::Map<const Eigen::RowVectorXd>(values.data(), coefficients.cols());
  }
  map.finish();
  return coefficients;
}

}  // namespace

MotionPoint<JointVector> Excitation::at(double t) const {
  const bool rising = t < 0.5 * duration;
  const Quintic<double> ramp = rest_to_rest(0.0, 1.0, fade);
  MotionPoint<double> f = ramp.at(rising ? t : duration - t);
  if (!rising) f.velocity = -f.velocity;
  const MotionPoint<JointVector> s = series(*this, t);
  return {center + f.position * s.position, f.velocity * s.position + f.position * s.velocity,
          f.acceleration * s.position + 2.0 * f.velocity * s.velocity + f.position * s.acceleration};
}

std::string excitation_yaml(const Excitation& e, const std::vector<std::string>& joints) {
  std::string text = fmt::format(
      "# q(t) = center + ramp(t) * sum over k of (sine_k sin(2 pi k frequency t) + cosine_k cos(2 pi k "
      "frequency t))   [rad, m]\n"
      "frequency: {}   # Hz\nduration: {}    # s\n"
      "fade: {}        # s; ramp(t) is a quintic from 0 to 1 at the start, and from 1 to 0 at the end\n"
      "center: [{}]\n",
      e.frequency, e.duration, e.fade, fmt::join(e.center.data(), e.center.data() + e.center.size(), ", "));
  for (const auto& [key, matrix] : {std::pair{"sine", &e.sine}, std::pair{"cosine", &e.cosine}}) {
    text += fmt::format("{}:\n", key);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const Eigen::RowVectorXd row = matrix->row(static_cast<Eigen::Index>(j));
      text += yaml::entry("  ", joints[j],
                          fmt::format("[{}]", fmt::join(row.data(), row.data() + row.size(), ", ")));
    }
  }
  return text;
}

Excitation load_excitation(const std::string& path, const std::vector<std::string>& joints) {
  const yaml::Node root = yaml::parse_file(path);
  yaml::MapReader map(root);
  Excitation e;
  e.frequency = map.number_in("frequency", e.frequency, 1e-3, kFastestHarmonic);
  e.duration = map.number_in("duration", e.duration, 1e-2, kLongestExcitation);
  e.fade = map.number_in("fade", std::min(e.fade, 0.25 * e.duration), 1e-3, 0.5 * e.duration);
  e.center = yaml::joint_values(map.required("center"), joints);
  e.sine = read_coefficients(map.required("sine"), joints);
  const yaml::Node& cosine = map.required("cosine");
  e.cosine = read_coefficients(cosine, joints);
  if (e.cosine.cols() != e.sine.cols())
    cosine.fail(InputFault{
        .problem = fmt::format("has {} harmonics, but 'sine' has {}", e.cosine.cols(), e.sine.cols()),
        .value = fmt::to_string(e.cosine.cols()),
        .limit = "as many as 'sine'"});
  if (e.frequency * static_cast<double>(e.sine.cols()) > kFastestHarmonic) {
    cosine.fail(InputFault{.problem = fmt::format("{} harmonics of the base frequency {} Hz are too fast",
                                                  e.sine.cols(), e.frequency),
                           .value = fmt::to_string(e.sine.cols()),
                           .limit = fmt::format("a highest frequency of at most {} Hz", kFastestHarmonic)});
  }
  map.finish();
  return e;
}

std::string excitation_csv(const Excitation& e, const std::vector<std::string>& joints, double period) {
  std::string text = "time";
  for (const std::string& joint : joints) {
    text += fmt::format(",joint/{0}/position,joint/{0}/velocity,joint/{0}/acceleration", joint);
  }
  text += '\n';
  const long samples = std::lround(e.duration / period);
  for (long k = 0; k <= samples; ++k) {
    const double t = static_cast<double>(k) * period;
    const MotionPoint<JointVector> point = e.at(t);
    text += cell(t);
    for (Eigen::Index i = 0; i < e.center.size(); ++i) {
      text +=
          "," + cell(point.position[i]) + "," + cell(point.velocity[i]) + "," + cell(point.acceleration[i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace armtune::internal
