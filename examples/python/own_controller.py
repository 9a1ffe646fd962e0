"""A controller written in Python: sliding mode with a boundary layer, tau = Y theta - rho tanh(S / phi). For experiments:
each control period calls Python. examples/controller is the same law in C++."""

import armtune
import numpy as np


def sliding_mode(robot, gains, period):
    rho, phi = np.array(gains["rho"]), np.array(gains["phi"])

    def torque(now):
        return now.model_torque(now.reference_velocity, now.reference_acceleration) - rho * np.tanh(now.sliding / phi)

    return torque


armtune.register_controller(
    "sliding_mode",
    sliding_mode,
    uses=["task_space_gains_p", "task_space_gains_i"],
    own=[
        {"shape": "joints", "name": "rho", "unit": "N m", "meaning": "most torque against what the model does not know", "otherwise": 30.0},
        {"shape": "joints", "name": "phi", "unit": "rad/s", "meaning": "S at which tanh has most of it", "otherwise": 0.3, "positive": True, "in_loop": False},
    ],
)
# A law that learns nothing has to know the arm: theta of the model, as published.
study = armtune.make_study(
    {
        "scenarios": ["realistic_moving_target"],
        "gains": "published",
        "controller": "sliding_mode",
        "objective": [{"metric": "error/position/rms"}],
        "constraints": [{"metric": "joint_velocity/max_ratio", "at_most": 0.9}],
    }
)
(scenario,) = study.scenarios
scenario.duration = 10
(rollout,) = armtune.simulate([scenario], study.start)
print(rollout)
