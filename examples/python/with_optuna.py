"""Optuna's TPE in place of armtune's search: 16 trials are asked for and told at a time."""

import sys

import armtune
import optuna

BATCHES = int(sys.argv[1]) if len(sys.argv) > 1 else 6
scenario = armtune.load_scenario("moving_target")
scenario.duration = 15
study = armtune.make_study(
    {
        "parameters": [
            {"name": "slerpDurationErrorGain", "lower": 0.5, "upper": 12, "scale": "log"},
            {"name": "trajectoryDurationErrorGain", "lower": 1, "upper": 20, "scale": "log"},
        ],
        "objective": [{"metric": "gaze/rms", "weight": 1}],
        "constraints": [{"metric": "joint_velocity/max_ratio", "at_most": 0.9}],
    },
    scenarios=[scenario],
    gains=armtune.load_gains("published", scenario),
)
evaluator = armtune.make_evaluator(study, engine="native")

optuna.logging.set_verbosity(optuna.logging.WARNING)
search = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=1, constant_liar=True))
search.enqueue_trial(dict(zip(study.parameters, evaluator.start.x)))
for _ in range(BATCHES):
    trials = [search.ask() for _ in range(16)]
    points = [[trial.suggest_float(name, 0, 1) for name in study.parameters] for trial in trials]
    for trial, point in zip(trials, evaluator.evaluate(points)):
        search.tell(trial, point.objective + 10 * point.violation)

best = evaluator.gains_at([search.best_params[name] for name in study.parameters])
# The last word is Simbody's.
before, after = (armtune.simulate([scenario], gains)[0] for gains in (study.start, best))
print(f"{len(search.trials)} trials; gaze/rms {before.metrics['gaze/rms']:.4f} -> {after.metrics['gaze/rms']:.4f} rad,", end=" ")
print(f"joint_velocity/max_ratio {before.metrics['joint_velocity/max_ratio']:.3f} -> {after.metrics['joint_velocity/max_ratio']:.3f}")
