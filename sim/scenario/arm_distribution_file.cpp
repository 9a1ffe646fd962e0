// Reads files like uncertainty.yaml, for load_arm_distribution of arm_distribution.hpp.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armtune/error.hpp"
#include "sim/scenario/arm_distribution.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

struct KindName {
  const char* name;  ///< of the whole arm; or behind JOINT/
  ArmParameterKind kind;
  bool of_joint;
  bool positive;
};

constexpr std::array<KindName, 15> kKinds = {{
    {"viscous_friction", ArmParameterKind::kViscousFriction, true, true},
    {"coulomb_friction", ArmParameterKind::kCoulombFriction, true, true},
    {"rotor_inertia", ArmParameterKind::kRotorInertia, true, true},
    {"drive_velocity_gain", ArmParameterKind::kVelocityGain, true, true},
    {"drive_velocity_integral", ArmParameterKind::kIntegralGain, true, true},
    {"drive_position_gain", ArmParameterKind::kPositionGain, true, true},
    {"torque_factor", ArmParameterKind::kTorqueFactor, true, true},
    {"encoder_offset", ArmParameterKind::kEncoderOffset, true, false},
    {"delay", ArmParameterKind::kDelay, false, false},
    {"payload/mass", ArmParameterKind::kPayloadMass, false, false},
    {"payload/center_x", ArmParameterKind::kPayloadCenterX, false, false},
    {"payload/center_y", ArmParameterKind::kPayloadCenterY, false, false},
    {"payload/center_z", ArmParameterKind::kPayloadCenterZ, false, false},
    {"base/tilt_x", ArmParameterKind::kTiltX, false, false},
    {"base/tilt_y", ArmParameterKind::kTiltY, false, false},
}};

/// Largest relative difference between a value of the robot file as it was written and as it is read.
constexpr double kSameValue = 1e-6;
/// A variance that is left after elimination counts as zero below this share of the parameter's own variance.
/// It is far above the rounding error of a sum of a hundred products, and its root is 1e-5 of a deviation.
constexpr double kZeroVariance = 1e-10;

[[noreturn]] void refuse_name(const yaml::Node& node, const std::vector<std::string>& joints) {
  std::vector<std::string> known;
  for (const KindName& k : kKinds) known.push_back(k.of_joint ? fmt::format("JOINT/{}", k.name) : k.name);
  node.fail(InputFault{.problem = fmt::format("'{}' is not a parameter of this arm", node.as_string()),
                       .limit = fmt::format("one of: {}, where JOINT is one of: {}", fmt::join(known, ", "),
                                            fmt::join(joints, ", "))});
}

/// Finds the kind and the joint of the parameter that the node names.
KindName kind_of(const yaml::Node& node, const std::vector<std::string>& joints, ArmParameter& p) {
  p.name = node.as_string();
  for (const KindName& k : kKinds) {
    const std::string end = k.of_joint ? std::string("/") + k.name : k.name;
    if (!p.name.ends_with(end)) continue;
    const std::string before = p.name.substr(0, p.name.size() - end.size());
    const auto joint = std::find(joints.begin(), joints.end(), before);
    if (k.of_joint ? joint == joints.end() : !before.empty()) continue;
    p.kind = k.kind;
    if (k.of_joint) p.joint = static_cast<int>(joint - joints.begin());
    return k;
  }
  refuse_name(node, joints);
}

ArmParameter read_parameter(const yaml::Node& node, const std::vector<std::string>& joints) {
  yaml::MapReader map(node);
  ArmParameter p;
  const KindName kind = kind_of(map.required("name"), joints, p);
  p.logarithmic = map.boolean("logarithm", kind.positive);
  if (kind.positive && !p.logarithmic)
    map.required("logarithm")
        .fail(
            InputFault{.problem = fmt::format("{} must be positive, so its logarithm must be normal", p.name),
                       .limit = "true"});
  p.mean = map.number("mean");
  p.told = map.boolean("told", true);
  if (const yaml::Node* value = map.optional("robot_file")) p.robot_file = value->as_number();
  for (const char* for_readers : {"unit", "value", "interval", "needs"}) map.ignore(for_readers);
  map.finish();
  return p;
}

std::vector<ArmParameter> read_parameters(const yaml::Node& node, const std::vector<std::string>& joints) {
  std::vector<ArmParameter> parameters;
  for (const yaml::Node& item : node.items()) {
    ArmParameter p = read_parameter(item, joints);
    const bool twice = std::any_of(parameters.begin(), parameters.end(),
                                   [&p](const ArmParameter& other) { return other.name == p.name; });
    if (twice)
      item.find("name")->fail(InputFault{.problem = p.name + " is listed twice", .limit = "one entry"});
    parameters.push_back(std::move(p));
  }
  if (parameters.empty())
    node.fail(InputFault{.problem = "the list is empty", .limit = "at least 1 parameter"});
  return parameters;
}

/// Reads n rows, which are those of the whole matrix or of its lower triangle.
Eigen::MatrixXd read_covariance(const yaml::Node& node, std::size_t n) {
  const std::vector<yaml::Node>& rows = node.items();
  if (rows.size() != n)
    node.fail(InputFault{.problem = "the covariance does not have one row for each parameter",
                         .value = fmt::to_string(rows.size()),
                         .limit = fmt::format("{} rows", n)});
  const bool whole = rows.front().items().size() == n;
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd covariance(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto length = static_cast<std::size_t>(whole ? size : i + 1);
    const std::vector<double> row = rows[static_cast<std::size_t>(i)].as_numbers(length);
    for (std::size_t c = 0; c < length; ++c) {
      const auto k = static_cast<Eigen::Index>(c);
      covariance(i, k) = row[c];
      if (!whole) covariance(k, i) = row[c];
    }
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index k = 0; k < i; ++k) {
      const double size_of_both = std::sqrt(std::abs(covariance(i, i) * covariance(k, k)));
      if (std::abs(covariance(i, k) - covariance(k, i)) <= kZeroVariance * size_of_both) continue;
      rows[static_cast<std::size_t>(i)].items()[static_cast<std::size_t>(k)].fail(
          InputFault{.problem = "the covariance is not symmetric",
                     .limit = fmt::format("{}, as in row {}, column {}", covariance(k, i), k + 1, i + 1)});
    }
  }
  return covariance;
}

/// Returns the lower triangular L with L L' = covariance (Cholesky). A parameter whose variance is used up by
/// those before it has no column. Then its covariances with later ones must be used up too (Higham, Accuracy
/// and Stability of Numerical Algorithms, 2002, section 10.3). Fails at the row that makes the matrix
/// indefinite.
Eigen::MatrixXd factor_of(const yaml::Node& node, const Eigen::MatrixXd& covariance) {
  const Eigen::Index n = covariance.rows();
  const auto refuse = [&node](Eigen::Index row, const char* problem) {
    node.items()[static_cast<std::size_t>(row)].fail(
        InputFault{.problem = problem, .limit = "the rows of a positive semidefinite matrix"});
  };
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double variance = covariance(j, j);
    const double left = variance - L.row(j).head(j).squaredNorm();
    if (variance < 0.0) refuse(j, "the variance in this row is negative");
    // Written so that a number that is not finite is refused too.
    if (!(left >= -kZeroVariance * variance)) refuse(j, "the covariances in this row are too large");
    const bool used_up = left <= kZeroVariance * variance;
    if (!used_up) L(j, j) = std::sqrt(left);
    for (Eigen::Index i = j + 1; i < n; ++i) {
      const double rest = covariance(i, j) - L.row(i).head(j).dot(L.row(j).head(j));
      if (!used_up) {
        L(i, j) = rest / L(j, j);
      } else if (std::abs(rest) > std::sqrt(kZeroVariance * variance * std::abs(covariance(i, i)))) {
        refuse(i, "the covariances in this row are too large");
      }
    }
  }
  return L;
}

/// Fails at a mean from which a drawn value could overflow.
void check_range(const yaml::Node& list, const ArmDistribution& distribution) {
  constexpr double kFarthest = 9.0;  // standard deviations; standard_normal() returns no larger number
  for (std::size_t i = 0; i < distribution.parameters.size(); ++i) {
    const ArmParameter& p = distribution.parameters[i];
    const auto k = static_cast<Eigen::Index>(i);
    const double most = p.mean + kFarthest * std::sqrt(distribution.covariance(k, k));
    if (std::isfinite(p.logarithmic ? std::exp(most) : most)) continue;
    list.items()[i].find("mean")->fail(
        InputFault{.problem = fmt::format("values of {} could be infinite", p.name),
                   .limit = "a mean and a variance with which values stay finite"});
  }
}

/// Fails if the calibration wrote another robot file than that of the scenario. Payloads cannot be compared,
/// because they are part of the last link there.
void check_robot_file(const yaml::Node& list, const ArmDistribution& distribution, const Scenario& scenario) {
  RobotModel robot = with_drive_gains(*scenario.robot);
  for (std::size_t i = 0; i < distribution.parameters.size(); ++i) {
    const ArmParameter& p = distribution.parameters[i];
    const JointVector* values = joint_values_of(p.kind, robot);
    if (!p.robot_file || values == nullptr) continue;
    const double here = (*values)[p.joint];
    if (std::abs(here - *p.robot_file) <= kSameValue * std::max(std::abs(here), std::abs(*p.robot_file)))
      continue;
    list.items()[i]
        .find("robot_file")
        ->fail(InputFault{.problem = fmt::format(
                              "this distribution belongs to another robot file than that of {}; simulate the "
                              "robot.yaml that the calibration wrote",
                              scenario.name),
                          .limit = fmt::format("{}, the value in the robot file of {}", here, robot.name)});
  }
}

}  // namespace

std::shared_ptr<const ArmDistribution> load_arm_distribution(const std::string& path,
                                                             std::span<const Scenario> scenarios) {
  const yaml::Node root = yaml::parse_file(path);
  yaml::MapReader map(root);
  const std::vector<std::string> joints = joint_names(*scenarios.front().robot);
  ArmDistribution distribution;
  distribution.file = path;
  distribution.note = map.string("note", "");
  const yaml::Node& list = map.required("parameters");
  distribution.parameters = read_parameters(list, joints);
  const yaml::Node& rows = map.required("covariance");
  distribution.covariance = read_covariance(rows, distribution.parameters.size());
  distribution.factor = factor_of(rows, distribution.covariance);
  map.finish();
  check_range(list, distribution);
  for (const Scenario& scenario : scenarios) {
    if (joint_names(*scenario.robot) != joints)
      throw InputError(InputPlace{path},
                       InputFault{.problem = fmt::format("{} and {} have arms with other joints",
                                                         scenarios.front().name, scenario.name),
                                  .value = scenario.name,
                                  .limit = "scenarios of one arm for one distribution"});
    check_robot_file(list, distribution, scenario);
  }
  return std::make_shared<const ArmDistribution>(std::move(distribution));
}

}  // namespace armtune::internal
