#include "armtune/robot.hpp"

#include "core/robot/robot_model.hpp"
#include "sim/scenario/robot_file.hpp"

namespace armtune {
namespace {

std::vector<double> numbers_of(const internal::JointVector& values) {
  return {values.data(), values.data() + values.size()};
}

}  // namespace

Robot Robot::load(const std::string& name_or_path) {
  return Robot(internal::load_robot(name_or_path));
}

const std::string& Robot::name() const {
  return model_->name;
}
std::vector<std::string> Robot::joints() const {
  return internal::joint_names(*model_);
}
std::vector<double> Robot::velocity_limits() const {
  return numbers_of(model_->velocity_limits());
}
std::vector<double> Robot::effort_limits() const {
  return numbers_of(model_->effort_limits());
}
std::vector<double> Robot::lower_position_limits() const {
  return numbers_of(model_->lower_limits());
}
std::vector<double> Robot::upper_position_limits() const {
  return numbers_of(model_->upper_limits());
}

}  // namespace armtune
