#pragma once
// A set of controller gains. A program reads it from a gains file, reads and changes single gains by their
// names in that file, and writes it again.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "armtune/robot.hpp"

namespace armtune {

namespace internal {
struct Gains;
}

/// The file formats that gains can be written in.
enum class GainsFormat {
  kYaml,  ///< armtune's gains file, with the keys of the published controller
  kRos1,  ///< ROS 1 parameter file, for rosparam load
  kRos2   ///< ROS 2 parameter file, for --params-file
};

/// The gains of one controller for one arm. It is a value: copies are independent.
class Gains {
 public:
  /// Reads bundled gains by name, or a gains file by path. robot: the arm that the gains are for. Throws
  /// InputError.
  static Gains load(const std::string& name_or_path, const Robot& robot);

  Gains(const Gains& other);
  Gains& operator=(const Gains& other);
  Gains(Gains&&) noexcept;
  Gains& operator=(Gains&&) noexcept;
  ~Gains();

  const std::string& controller() const;
  const std::vector<std::string>& joints() const { return joints_; }
  /// Returns the names of all gains of the controller. They include options that are not numbers but switches
  /// or words.
  std::vector<std::string> names() const;

  /// Returns the values of a gain, which can be read and changed in place. A gain has one value, six values
  /// (x y z rx ry rz) or one for each joint. Only force_control_gains can have n x n values for n joints. The
  /// span stays valid until other gains are assigned to this object. Throws InputError if there is no such
  /// gain, or if it is not numeric.
  std::span<double> numbers(const std::string& name);
  std::span<const double> numbers(const std::string& name) const;
  /// Sets all values of a gain. A single value is used for all of them. Throws InputError if the number of
  /// values does not fit.
  void set(const std::string& name, const std::vector<double>& values);
  void set(const std::string& name, double value) { set(name, std::vector<double>{value}); }
  /// Reads or sets a switch ("true", "false") or a word, as written in a gains file. Throws InputError if
  /// there is no such gain, if it is numeric, or if the word is not one of its allowed words.
  std::string word(const std::string& name) const;
  void set_word(const std::string& name, const std::string& word);

  /// Returns the text of a gains file. Throws InputError if a number is outside its limits.
  std::string text(GainsFormat format = GainsFormat::kYaml) const;
  /// Writes the text of a gains file to a file, either completely or not at all. Throws InputError if it
  /// cannot be written.
  void save(const std::string& path, GainsFormat format = GainsFormat::kYaml) const;

  /// For armtune's own code.
  Gains(const internal::Gains& gains, std::vector<std::string> joints);
  const internal::Gains& inside() const { return *inside_; }
  internal::Gains& inside() { return *inside_; }

 private:
  std::unique_ptr<internal::Gains> inside_;
  std::vector<std::string> joints_;
};

}  // namespace armtune
