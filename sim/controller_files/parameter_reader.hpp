#pragma once
// Reads numbers from the parameters of a controller in a ROS parameter file, as ROS would read them.

#include <string>

#include "armtune/error.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

class ParameterReader {
 public:
  /// Both arguments must outlive this object.
  ParameterReader(const RosController& controller, const std::string& file)
      : controller_(controller), file_(file) {}

  const RosController& controller() const { return controller_; }

  /// Throws InputError "FILE:LINE: CONTROLLER: what". The key of the error is the name of the controller.
  /// value, limit: see InputError.
  [[noreturn]] void fail(int line, const std::string& what, const std::string& value = {},
                         const std::string& limit = {}) const;

  /// Returns the number, which may be infinite (.inf). what: name of the parameter, for messages. Throws
  /// InputError if the value is not a plain number that all YAML readers read alike.
  double number(const yaml::PlacedValue& value, const std::string& what) const;
  /// Does the same, but also throws InputError if the number is infinite.
  double finite(const yaml::PlacedValue& value, const std::string& what) const;

 private:
  InputError error(const yaml::PlacedValue& value, const std::string& problem,
                   const std::string& limit) const;

  const RosController& controller_;
  const std::string& file_;
};

}  // namespace armtune::internal
