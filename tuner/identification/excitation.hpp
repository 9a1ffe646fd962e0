#pragma once
// Defines exciting trajectories. An exciting trajectory is a motion from whose log an arm's parameters can
// be identified. Each joint follows a finite Fourier series around a centre. Quintic polynomials fade the
// series in and out (Swevers et al., Optimal robot excitation and identification, 1997).

#include <string>
#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"

namespace armtune::internal {

struct Excitation {
  double frequency = 0.1;  ///< base frequency [Hz]
  double duration = 20.0;  ///< [s], fades included
  double fade = 2.0;       ///< duration of the fade-in and of the fade-out [s]
  JointVector center;      ///< (n) [rad, m]
  Eigen::MatrixXd sine;    ///< n x harmonics [rad, m]
  Eigen::MatrixXd cosine;

  /// Returns q, q', q'' at t in 0 .. duration [s]. Before and after, the arm is at rest in the centre.
  MotionPoint<JointVector> at(double t) const;
};

/// The longest duration [s] and the highest frequency of a harmonic [Hz] that are allowed. They limit the
/// memory use, and correspond to what an arm can do in one log.
inline constexpr double kLongestExcitation = 1000.0;
inline constexpr double kFastestHarmonic = 20.0;

/// Returns the text of excitation.yaml. load_excitation reads such a file, and throws InputError if it does
/// not fit the joints.
std::string excitation_yaml(const Excitation& excitation, const std::vector<std::string>& joints);
Excitation load_excitation(const std::string& path, const std::vector<std::string>& joints);

/// Returns the text of trajectory.csv: time, and position, velocity and acceleration of every joint. There is
/// one row per period [s] from 0 to the end. Numbers have all digits that are needed to read back the same
/// value.
std::string excitation_csv(const Excitation& excitation, const std::vector<std::string>& joints,
                           double period);

}  // namespace armtune::internal
