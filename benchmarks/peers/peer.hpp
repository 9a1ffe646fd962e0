#pragma once
// What the program of each library has in common: the same states, results to compare, time per call.
// scripts/measure-peers runs them; nothing of armtune is in here, so that every library gets the same.

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace peers {

inline constexpr int kJoints = 6;
/// Of the semi-implicit step: q' += q'' h, q += q' h [s].
inline constexpr double kStep = 0.002;

struct State {
  std::array<double, kJoints> q{}, qd{}, qdd{}, tau{};  ///< [rad, rad/s, rad/s^2, N m]
};

/// One piece of work on one state. Links only: no rotor inertia, no friction; gravity 9.81 m/s^2 along -z.
struct Kernel {
  /// forward_kinematics   pose of link tool0: position, then rotation by rows (12 numbers)
  /// jacobian             J of tool0's origin, linear rows first, by rows (36), and J' q' (6), kinematics
  /// included inverse_dynamics     torque for q'' mass_matrix          by rows forward_dynamics     q'' for
  /// the torque step                 q and q' after kStep
  const char* name;
  std::function<void(const State&)> run;              ///< timed
  std::function<void(std::vector<double>&)> results;  ///< of the last run, appended; not timed
};

/// What has no peer: a whole control period in closed loop.
struct Period {
  const char* name;
  std::function<double()> nanoseconds;  ///< a period and arm, of one measurement
};

struct Peer {
  std::string name;
  std::string version;
  std::vector<Kernel> kernels;
  std::vector<Period> periods = {};
};

/// PROGRAM results    every kernel's results for some states: "kernel number number ..." per line
/// PROGRAM time       nanoseconds a call of every kernel, least of several batches: "kernel nanoseconds"; the
///                    same of every period
/// PROGRAM version
int peer_main(int argc, char** argv, const std::function<Peer(const std::string& urdf)>& load);

}  // namespace peers
