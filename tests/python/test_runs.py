"""Searches and other runs of the Python module."""

import json
import subprocess
import sys

import numpy as np

import armtune
from module_case import ModuleCase, ROOT, run


class Runs(ModuleCase):
    def test_tune_finds_what_the_program_finds(self):
        self.assertIn(run("tune", self.folder / "study.yaml", "--no-analysis", "--out", self.folder / "run").returncode, (0, 3))
        seen = []
        study = armtune.load_study(str(self.folder / "study.yaml"))
        tuned = armtune.tune(study, workers=2, analysis=False, progress=lambda at: seen.append((at.work, at.done, at.all)))
        found = armtune.load_gains(str(self.folder / "run/gains.yaml"), self.scenario)
        self.assertEqual(tuned.best.text(), found.text())
        searched = [done for work, done, most in seen if most == 8]
        self.assertEqual(searched, list(range(1, 9)))
        self.assertEqual(tuned.parameters, ["task_space_gains_p/rx", "slerpDurationErrorGain"])
        self.assertEqual(tuned.points.shape, (8, 2))
        self.assertEqual(tuned.objectives[0], 1.0, "the start scores 1")
        self.assertEqual(tuned.objective, min(tuned.objectives[tuned.violations == 0]))

    def test_an_evaluator_judges_points_as_the_search_does(self):
        study = armtune.load_study(self.folder / "study.yaml")
        tuned = armtune.tune(study, analysis=False)
        evaluator = armtune.make_evaluator(study, engine="simbody", workers=2)
        self.assertEqual(evaluator.start.objective, 1.0)
        points = evaluator.evaluate(tuned.points)
        self.assertEqual([point.objective for point in points], list(tuned.objectives))
        self.assertEqual([point.violation for point in points], list(tuned.violations))
        self.assertEqual([point.x for point in points], tuned.points.tolist())
        best = next(point for point in points if point.feasible and point.objective == tuned.objective)
        self.assertLessEqual(max(best.constraints), 0.0)
        self.assertEqual(evaluator.gains_at(best.x).text(), tuned.best.text())
        with self.assertRaisesRegex(armtune.InputError, "coordinates"):
            evaluator.evaluate([[0.5]])

        def enough(at):
            raise KeyError(at.done)

        with self.assertRaises(KeyError):
            evaluator.evaluate(tuned.points, progress=enough)

    def tuned_with(self, **parts):
        description = {
            "parameters": [
                {"name": "task_space_gains_p/rx", "lower": 10, "upper": 60},
                {"name": "slerpDurationErrorGain", "lower": 1, "upper": 4, "scale": "linear"},
            ],
            "constraints": [{"metric": "joint_velocity/max_ratio", "at_most": 0.9}],
            "search": {"algorithm": "COBYLA", "max_evaluations": 8, "seed": 1},
        }
        if "objective" not in parts:
            description["objective"] = [{"metric": "error/orientation/rms", "weight": 1}]
        study = armtune.make_study(description, scenarios=[self.scenario], gains=self.gains, **parts)
        return armtune.tune(study, analysis=False)

    def test_a_study_built_in_code_is_that_of_the_file(self):
        of_file = armtune.tune(armtune.load_study(self.folder / "study.yaml"), analysis=False)
        built = self.tuned_with()
        self.assertEqual(built.best.text(), of_file.best.text())
        self.assertEqual(str(built.verdict), str(of_file.verdict))
        self.assertEqual(built.verdict.passed, all(check.passed for check in built.verdict.checks))

    def test_an_own_objective_is_what_the_term_is(self):
        seen = []

        def objective(rollouts):
            seen.append([rollout.scenario for rollout in rollouts])
            return rollouts[0].metrics["error/orientation/rms"]

        own = self.tuned_with(objective=objective)
        self.assertEqual(own.best.text(), self.tuned_with().best.text())
        self.assertEqual(seen[0], ["short"])
        with self.assertRaises(ZeroDivisionError):
            self.tuned_with(objective=lambda rollouts: 1 / 0)
        with self.assertRaisesRegex(armtune.FailedError, "not a number"):
            self.tuned_with(objective=lambda rollouts: "good")

    def test_every_kind_of_run(self):
        found = armtune.robustness([self.scenario], self.gains, samples=2, engine="native")
        self.assertEqual([sample.number for sample in found.samples], [0, 1])
        self.assertEqual(found.yield_, sum(sample.keeps_all for sample in found.samples) / 2)
        margins = armtune.margins([self.scenario], self.gains, engine="native", workers=2)
        self.assertEqual({margin.kind for margin in margins}, {"torque_delay", "gain_factor", "control_rate", "velocity_noise"})
        study = armtune.load_study(self.folder / "study.yaml")
        front = armtune.front(study, ["error/orientation/rms", "joint_velocity/max_ratio"], levels=2, max_evaluations=12)
        firsts = [point.values[0] for point in front.points]
        self.assertEqual(firsts, sorted(firsts))
        armtune.tune(study, folder=self.folder / "run", analysis=False)
        armtune.report(self.folder / "run", self.folder / "page.html")
        self.assertIn(b"<html", (self.folder / "page.html").read_bytes()[:200])
        with self.assertRaisesRegex(armtune.InputError, "run"):
            armtune.tune(study, folder=self.folder / "run", analysis=False)
        if hasattr(armtune, "plan"):
            plan = armtune.plan("ur10_switch")
            self.assertTrue(plan.solved)
            self.assertEqual((len(plan.position), len(plan.position[0])), (len(plan.time), 6))
            self.assertAlmostEqual(plan.duration, plan.time[-1] - plan.time[0])
            self.assertEqual(run("simulate", "moving_target", "--out", self.folder / "log").returncode, 3)
            identified = armtune.identify(armtune.load_robot("ur10"), [self.folder / "log/rollout_moving_target.csv"])
            self.assertEqual(len(identified.theta), 13 * 6)
            self.assertLess(max(identified.held_out.by_theta), max(identified.held_out.torque))

    def test_simulate_and_margins_leave_a_folder_and_a_verdict(self):
        found = armtune.simulate([self.scenario], self.gains, engine="native", folder=self.folder / "sim")
        (rollout,) = found
        self.assertIs(found[-1], rollout)
        self.assertEqual((len(found), found[:1], found.rollouts), (1, [rollout], [rollout]))
        self.assertEqual((self.folder / "sim/errors.csv").read_text(), armtune.errors_csv(found))
        verdict = (self.folder / "sim/verdict.yaml").read_text()
        self.assertIn(f"passed: {str(found.verdict.passed).lower()}\n", verdict)
        self.assertEqual(verdict.count("{check: "), len(found.verdict.checks))
        bare = armtune.simulate([self.scenario], self.gains, engine="native")
        self.assertEqual((bare.files, str(bare.verdict)), ([], str(found.verdict)))
        with self.assertRaises(IndexError):
            found[1]
        with self.assertRaises(armtune.InputError) as caught:
            armtune.simulate([self.scenario], [self.gains], folder=self.folder / "sets")
        self.assertEqual(caught.exception.key, "folder")
        margins = armtune.margins([self.scenario], self.gains, engine="native", folder=self.folder / "margins")
        self.assertEqual([margin.unit for margin in margins], [check.unit for check in margins.verdict.checks])
        self.assertIn("margins.csv", margins.files)
        record = armtune.run_record(self.folder / "margins")
        self.assertEqual(record, json.loads((self.folder / "margins/run.json").read_text()))
        self.assertEqual((record["kind"], record["margins"]["margins"]), ("margins", len(margins)))
        with self.assertRaises(armtune.InputError):
            armtune.run_record(self.folder)

    def test_the_files_of_a_robot_are_tuned_into_its_parameter_file(self):
        example = ROOT / "examples/joint_trajectory"
        parameters = example / "ros2_controllers.yaml"
        with self.assertWarnsRegex(UserWarning, "500 Hz"):
            study = armtune.study_from_controllers("ur5e", parameters, [example / "moves.csv"], folder=self.folder / "study", workers=2)
        study.max_evaluations = 60
        tuned = armtune.tune(study, folder=self.folder / "run", workers=2)
        self.assertTrue(tuned.verdict.passed, str(tuned.verdict))
        self.assertIn(parameters.name, tuned.files)
        before, after = parameters.read_text().splitlines(), (self.folder / "run" / parameters.name).read_text().splitlines()
        changed = [line for line, old in zip(after, before, strict=True) if line != old]
        self.assertTrue(changed)
        self.assertTrue(all("_joint: {p: " in line for line in changed), changed)
        loaded = armtune.load_gains(self.folder / "run" / parameters.name, study.scenarios[0])
        np.testing.assert_allclose(loaded["jtc_p"], tuned.best["jtc_p"])
        with self.assertRaises(armtune.InputError) as caught:
            armtune.study_from_controllers("ur5e", parameters, [example / "moves.csv"], folder=self.folder / "slow", rate=1.0)
        self.assertEqual(caught.exception.key, "rate")

    def test_the_examples_with_other_optimisers_find_better_gains(self):
        for script, batches in (("with_scipy.py", 2), ("with_optuna.py", 3), ("own_controller.py", 0)):
            done = subprocess.run([sys.executable, ROOT / "examples/python" / script, str(batches)], capture_output=True, text=True)
            if "ModuleNotFoundError" in done.stderr and "armtune" not in done.stderr.splitlines()[-1]:
                continue  # SciPy or Optuna is not installed
            with self.subTest(script):
                self.assertEqual(done.returncode, 0, done.stderr)
                if batches:
                    before, after = map(float, done.stdout.split("gaze/rms ")[1].split(" rad")[0].split(" -> "))
                    self.assertLess(after, before)
                else:
                    self.assertIn("moving_target: completed", done.stdout)
