#include "tuner/identification/identification_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/common/message_text.hpp"
#include "core/robot/urdf_writer.hpp"
#include "sim/csv/cell.hpp"
#include "sim/scenario/robot_writer.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {

std::string theta_yaml(const RobotModel& model, const ParameterVector& theta,
                       const std::vector<std::string>& header) {
  std::string text;
  for (const std::string& line : header) text += yaml::comment(line);
  Eigen::Index i = 0;
  for (const std::string& name : theta_names(model))
    text += yaml::entry("", name, fmt::format("{}", theta[i++]));
  return text;
}

std::string base_parameters_csv(const RobotModel& model, const Identification& found) {
  const Eigen::VectorXd file = found.base.map * theta_of(model.chain);
  const Eigen::VectorXd physical = found.base.map * found.theta;
  const Eigen::VectorXd deviation = found.estimate.deviation();
  const std::vector<int>& dead = found.estimate.not_excited;
  std::string text = "group,estimate,standard_deviation,robot_file,physical,status\n";
  for (Eigen::Index b = 0; b < file.size(); ++b) {
    const char* status = std::isfinite(deviation[b]) ? "estimated" : "no standard deviation";
    if (!std::isfinite(found.estimate.theta[b])) status = "no estimate";
    if (std::find(dead.begin(), dead.end(), b) != dead.end()) status = "not excited";
    text += fmt::format("{},{},{},{},{},{}\n", cell(found.base.names[static_cast<std::size_t>(b)]),
                        cell(found.estimate.theta[b]), cell(deviation[b]), cell(file[b]), cell(physical[b]),
                        status);
  }
  return text;
}

RobotModel with_theta(const RobotModel& model, const ParameterVector& theta) {
  RobotModel found = model;
  for (int i = 0; i < model.n(); ++i) {
    const auto p = theta.segment<kLinkParameters>(i * kLinkParameters);
    LinkInertia& link = found.chain.link[static_cast<std::size_t>(i)];
    link.mass = p[0];
    link.first_moment = p.segment<3>(1);
    link.inertia << p[4], p[5], p[6], p[5], p[7], p[8], p[6], p[8], p[9];
    const auto joint = theta.segment<kJointParameters>(joint_parameter_index(model.n(), i));
    found.chain.rotor_inertia[i] = joint[0];
    found.chain.viscous_friction[i] = joint[1];
    found.chain.coulomb_friction[i] = joint[2];
  }
  return found;
}

std::string identified_robot_yaml(const RobotModel& model, const std::string& urdf) {
  const auto list = [](const JointVector& v) {
    return fmt::format("[{}]", fmt::join(v.data(), v.data() + v.size(), ", "));
  };
  return fmt::format(
             "urdf: {}\nbase_link: {}\ntip_link: {}\nrotor_inertia: {}\nviscous_friction: {}\n"
             "coulomb_friction: {}\n",
             yaml::word(urdf), yaml::quoted(model.base_link), yaml::word(urdf_tool_link(model)),
             list(model.chain.rotor_inertia), list(model.chain.viscous_friction),
             list(model.chain.coulomb_friction)) +
         acceleration_limits_yaml(model);
}

}  // namespace armtune::internal
