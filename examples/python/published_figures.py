"""The published figures of one scenario, and the errors.csv of `armtune simulate moving_target`."""

import sys

import armtune

scenario = armtune.load_scenario("moving_target")
gains = armtune.load_gains("published", scenario)
rollouts = armtune.simulate([scenario], gains)
for axis in "xyz":
    print(f"largest error along {axis}: {rollouts[0].metrics[f'error/position/{axis}/max']:.4f} m (report: 0.003 m of any axis)")
print(f"largest velocity: {rollouts[0].metrics['joint_velocity/max_ratio']:.3f} of a limit, over {len(rollouts[0]['time'])} rows")
armtune.write_errors(rollouts, sys.argv[1] if len(sys.argv) > 1 else "errors.csv")
