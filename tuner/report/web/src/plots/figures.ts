// The list of all possible time plots, in their order on the page.
import type { Column, Scenario } from "../data";

export interface Figure {
  group: Column["group"];
  title: string;
  axis: string;
  /** True: the y axis begins at zero. */
  fromZero: boolean;
  lines: (scenario: Scenario) => { value: number; label: string }[];
}

const none = () => [];
const limit = () => [{ value: 1, label: "limit" }];

/** Plots for the joints of a plan. Joints that turn and joints that slide have separate plots, because their
 * units differ. */
const OF_PLANS: Figure[] = (["joint", "slide"] as const).flatMap((kind) => {
  const whose = kind === "joint" ? "Joint" : "Sliding joint";
  const figure = (quantity: "position" | "velocity" | "acceleration" | "jerk" | "torque", axis: string, plural: string): Figure => ({
    group: `${kind}_${quantity}`,
    title: `${whose} ${plural}`,
    axis,
    fromZero: false,
    lines: none,
  });
  return [
    figure("position", "position", "positions"),
    figure("velocity", "velocity", "velocities"),
    figure("acceleration", "acceleration", "accelerations"),
    figure("jerk", "jerk", "jerks"),
    kind === "joint" ? figure("torque", "torque", "torques") : figure("torque", "force", "forces"),
  ];
});

export const FIGURES: Figure[] = [
  { group: "position", title: "Tool position", axis: "position", fromZero: false, lines: none },
  { group: "position_error", title: "Position error", axis: "error", fromZero: false, lines: none },
  { group: "orientation_error", title: "Orientation error", axis: "error", fromZero: false, lines: none },
  { group: "linear_velocity_error", title: "Linear velocity error", axis: "error", fromZero: false, lines: none },
  { group: "angular_velocity_error", title: "Angular velocity error", axis: "error", fromZero: false, lines: none },
  { group: "joint_error", title: "Joint error from the planned trajectory", axis: "error", fromZero: false, lines: none },
  { group: "gaze", title: "Gaze angle to the target", axis: "angle", fromZero: true, lines: none },
  ...OF_PLANS,
  { group: "velocity_ratio", title: "Joint velocities divided by their limits", axis: "velocity / limit", fromZero: true, lines: limit },
  { group: "torque_ratio", title: "Joint torques divided by their limits", axis: "torque / limit", fromZero: true, lines: limit },
  { group: "theta", title: "Torque error of theta", axis: "torque", fromZero: true, lines: none },
  {
    group: "clearance",
    title: "Clearance of the arm",
    axis: "distance",
    fromZero: true,
    lines: (scenario) =>
      scenario.limits === undefined && scenario.influence_radius > 0 ? [{ value: scenario.influence_radius, label: "influence radius" }] : [],
  },
  { group: "manipulability", title: "Manipulability", axis: "manipulability", fromZero: true, lines: none },
];
