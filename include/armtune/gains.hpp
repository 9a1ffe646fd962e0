#pragma once
// The gains of a controller, by the names of its gains file.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "armtune/robot.hpp"

namespace armtune {

namespace internal {
struct Gains;
}

/// The forms that robots read gains in.
enum class GainsFormat {
  kYaml,  ///< armtune's own, which is the published one
  kRos1,  ///< for rosparam load
  kRos2   ///< for --params-file
};

/// A value: copies are independent.
class Gains {
 public:
  /// Reads bundled gains by name, or a gains file by path, for that arm. Throws InputError.
  static Gains load(const std::string& name_or_path, const Robot& robot);

  Gains(const Gains& other);
  Gains& operator=(const Gains& other);
  Gains(Gains&&) noexcept;
  Gains& operator=(Gains&&) noexcept;
  ~Gains();

  const std::string& controller() const;
  const std::vector<std::string>& joints() const { return joints_; }
  /// Names of all gains that the controller has, switches and words included.
  std::vector<std::string> names() const;

  /// The numbers of a gain, to be read and written in place: one, six (x y z rx ry rz) or one for each joint.
  /// They stay where they are until other gains are assigned to these. Throws InputError if there is no such
  /// gain, or if it has no numbers.
  std::span<double> numbers(const std::string& name);
  std::span<const double> numbers(const std::string& name) const;
  /// Sets all numbers of a gain. One value stands for all of them. Throws InputError if their count does not
  /// fit.
  void set(const std::string& name, const std::vector<double>& values);
  void set(const std::string& name, double value) { set(name, std::vector<double>{value}); }
  /// A switch ("true", "false") or a word, as it stands in a gains file. Throws InputError if there is no
  /// such gain, if it has numbers, or if the word is none of its own.
  std::string word(const std::string& name) const;
  void set_word(const std::string& name, const std::string& word);

  /// The gains as a file. Throws InputError where a number is outside its limits.
  std::string text(GainsFormat format = GainsFormat::kYaml) const;
  /// Writes that, whole or not at all. Throws InputError if it cannot be written.
  void save(const std::string& path, GainsFormat format = GainsFormat::kYaml) const;

  /// For armtune itself.
  Gains(const internal::Gains& gains, std::vector<std::string> joints);
  const internal::Gains& inside() const { return *inside_; }
  internal::Gains& inside() { return *inside_; }

 private:
  std::unique_ptr<internal::Gains> inside_;
  std::vector<std::string> joints_;
};

}  // namespace armtune
