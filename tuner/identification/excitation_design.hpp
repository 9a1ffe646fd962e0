#pragma once
// Designs an exciting trajectory: a motion from whose log an arm's inertial and friction parameters can be
// identified well. It minimises the condition number of the regressor within the arm's limits.

#include <atomic>
#include <functional>

#include "core/robot/robot_model.hpp"
#include "tuner/identification/base_parameters.hpp"
#include "tuner/identification/excitation.hpp"
#include "tuner/identification/excitation_clearance.hpp"

namespace armtune::internal {

struct ExcitationOptions {
  double frequency = 0.1;  ///< base frequency [Hz]
  int harmonics = 5;
  double duration = 20.0;    ///< [s]
  double fade = 2.0;         ///< duration of fade-in and of fade-out [s]; at most half of `duration`
  JointVector center;        ///< empty: the middle of the position limits
  double amplitude = 1.0;    ///< largest distance from the centre [rad, m]
  double margin = 0.8;       ///< share of the velocity and effort limits that may be used
  double min_height = -1e9;  ///< least height of the tool and of the third and later joints' origins [m]
  KeptDistances kept;        ///< distances that the motion keeps
  long evaluations = 20000;
  std::uint64_t seed = 1;
  std::function<void(long evaluations, double condition)> progress;
};

/// Results for one trajectory: the largest fractions of the arm's limits that it uses, its lowest point, and
/// how well it excites the parameters.
struct ExcitationUse {
  double condition = 0.0;        ///< condition number of the base regressor with columns of unit length
  double distance = 0.0;         ///< largest distance from the centre [rad, m]
  double position_margin = 0.0;  ///< smallest distance to a position limit [rad, m]
  double velocity_ratio = 0.0;
  double effort_ratio = 0.0;  ///< from the inverse dynamics of the model
  double lowest = 0.0;        ///< least height of the points that `min_height` limits [m]
  double shortfall = 0.0;     ///< of distances, with 1 cm to spare; see DistanceTally::shortfall
};

/// Evaluates the trajectory at 20 instants of each period of its highest harmonic.
ExcitationUse use_of(const Excitation& excitation, const RobotModel& model, const BaseParameters& base,
                     const KeptDistances& kept = {});

struct ExcitationDesign {
  Excitation excitation;
  ExcitationUse use;
  DistancesAlong distances;       ///< along the whole trajectory
  double scale = 1.0;             ///< factor by which amplitudes were reduced to keep the distances
  double random_condition = 0.0;  ///< condition number of the best random trajectory
  long evaluations = 0;
};

/// Returns the best trajectory found. Throws InputError if the options do not fit the arm, if the centre is
/// nearer to a contact than allowed, or if no trajectory around the centre keeps the limits and the
/// distances.
ExcitationDesign design_excitation(const RobotModel& model, const ExcitationOptions& options,
                                   const std::atomic<bool>& stop);

}  // namespace armtune::internal
