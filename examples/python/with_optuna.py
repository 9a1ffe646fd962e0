"""Optuna's TPE over batched rollouts: 16 trials are asked for and told at a time."""

import sys

import armtune
import optuna

BATCHES = int(sys.argv[1]) if len(sys.argv) > 1 else 6
scenario = armtune.load_scenario("moving_target")
scenario.duration = 15
start = armtune.load_gains("published", scenario)


def gains_of(params):
    gains = start.copy()
    for name, value in params.items():
        gains[name] = value
    return gains


optuna.logging.set_verbosity(optuna.logging.WARNING)
search = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=1, constant_liar=True))
search.enqueue_trial({name: float(start[name][0]) for name in ("slerpDurationErrorGain", "trajectoryDurationErrorGain")})
for _ in range(BATCHES):
    trials = [search.ask() for _ in range(16)]
    for trial in trials:
        trial.suggest_float("slerpDurationErrorGain", 0.5, 12.0, log=True)
        trial.suggest_float("trajectoryDurationErrorGain", 1.0, 20.0, log=True)
    rollouts = armtune.simulate([scenario], [gains_of(trial.params) for trial in trials], engine="native")
    for trial, (rollout,) in zip(trials, rollouts):
        over = max(0.0, rollout.metrics["joint_velocity/max_ratio"] - 0.9)
        search.tell(trial, rollout.metrics["gaze/rms"] + 10.0 * over if rollout.completed else 1e3)

# The last word is Simbody's.
before, after = (armtune.simulate([scenario], gains)[0] for gains in (start, gains_of(search.best_params)))
print(f"{len(search.trials)} trials; gaze/rms {before.metrics['gaze/rms']:.4f} -> {after.metrics['gaze/rms']:.4f} rad,", end=" ")
print(f"joint_velocity/max_ratio {before.metrics['joint_velocity/max_ratio']:.3f} -> {after.metrics['joint_velocity/max_ratio']:.3f}")
