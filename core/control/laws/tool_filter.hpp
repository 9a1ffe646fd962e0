#pragma once
// Filters the desired pose of the tool, as the Cartesian impedance controllers for Franka's arms do, and
// computes the tool's error from the filtered pose.

namespace armtune::internal {

/// The filtered pose of one arm. Vectors and matrices are passed as their numbers, column by column, so that
/// laws compiled for any kind of processor can call these functions. p_0T, R_0T: measured pose of the tool.
class ToolFilter {
 public:
  /// share: the last filtered pose's share in the next, from 0 (no filter) to below 1.
  void start(double share);
  /// Sets the filtered pose to the measured one.
  void begin(const double* R_0T, const double* p_0T);
  /// Moves the filtered pose towards the desired one. Then computes e (6) [m, 1], the error of the measured
  /// pose from the filtered one. The rotational part of e is sin(angle / 2) times the axis of the turn.
  /// pose_error (6): error dx of the measured pose from the desired one (CartesianErrors::pose).
  void follow(const double* R_0T, const double* p_0T, const double* pose_error, double* e);

 private:
  double share_ = 0.0;
  double position_[3] = {0.0, 0.0, 0.0};
  double orientation_[4] = {0.0, 0.0, 0.0, 1.0};  ///< unit quaternion (x, y, z, w)
};

}  // namespace armtune::internal
