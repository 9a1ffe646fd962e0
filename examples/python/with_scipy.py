"""SciPy's differential evolution over batched rollouts: 32 gain sets at a time in the native engine."""

import sys

import armtune
import numpy as np
from scipy.optimize import differential_evolution

GENERATIONS = int(sys.argv[1]) if len(sys.argv) > 1 else 5
scenario = armtune.load_scenario("moving_target")
scenario.duration = 15
start = armtune.load_gains("published", scenario)
bounds = [(0.5, 12.0), (1.0, 20.0)]


def gains_of(point):
    gains = start.copy()
    gains["slerpDurationErrorGain"], gains["trajectoryDurationErrorGain"] = point
    return gains


def cost(points):  # 2 x N, of which SciPy wants N values
    rollouts = armtune.simulate([scenario], [gains_of(point) for point in points.T], engine="native")
    return np.array([worth(rollout) for (rollout,) in rollouts])


def worth(rollout):
    over = max(0.0, rollout.metrics["joint_velocity/max_ratio"] - 0.9)
    return rollout.metrics["gaze/rms"] + 10.0 * over if rollout.completed else 1e3


found = differential_evolution(
    cost, bounds, popsize=16, maxiter=GENERATIONS, seed=1, polish=False, vectorized=True, updating="deferred"
)
# The last word is Simbody's.
before, after = (armtune.simulate([scenario], gains)[0] for gains in (start, gains_of(found.x)))
print(f"{found.nfev} evaluations; gaze/rms {before.metrics['gaze/rms']:.4f} -> {after.metrics['gaze/rms']:.4f} rad,", end=" ")
print(f"joint_velocity/max_ratio {before.metrics['joint_velocity/max_ratio']:.3f} -> {after.metrics['joint_velocity/max_ratio']:.3f}")
