#pragma once
// The components of the tool's motion that the task prescribes. An arm of n joints can control at most n of
// them; joints beyond the number of components are redundant.

namespace armtune::internal {

enum class TaskMask {
  kPose,             ///< position and orientation
  kPositionAndAxis,  ///< position and direction of the tool's z axis; the turn about this axis is free
  kPosition          ///< position only
};

constexpr int components(TaskMask mask) {
  switch (mask) {
    case TaskMask::kPose:
      return 6;
    case TaskMask::kPositionAndAxis:
      return 5;
    case TaskMask::kPosition:
      return 3;
  }
  return 0;
}

constexpr const char* name(TaskMask mask) {
  switch (mask) {
    case TaskMask::kPose:
      return "pose";
    case TaskMask::kPositionAndAxis:
      return "position_and_axis";
    case TaskMask::kPosition:
      return "position";
  }
  return "";
}

/// Returns the mask with the most components that this number of joints can control.
constexpr TaskMask largest_mask(int joints) {
  if (joints >= components(TaskMask::kPose)) return TaskMask::kPose;
  if (joints >= components(TaskMask::kPositionAndAxis)) return TaskMask::kPositionAndAxis;
  return TaskMask::kPosition;
}

constexpr bool tracks_orientation(TaskMask mask) {
  return mask != TaskMask::kPosition;
}

}  // namespace armtune::internal
