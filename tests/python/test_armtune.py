"""The Python module against the program, and its promises: no copies, no lock while it works, Ctrl-C."""

import ast
import copy
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import armtune

if not armtune.arithmetic()[0].startswith("baseline"):
    # As docs/python.md says: the program's own bytes.
    os.environ["GLIBC_TUNABLES"] = armtune.baseline_tunables(os.environ.get("GLIBC_TUNABLES", ""))
    os.execv(sys.executable, sys.orig_argv)

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = os.environ["ARMTUNE_PROGRAM"]

SHORT = "base: moving_target\nduration: 8\n"
STUDY = """gains: quick.yaml
scenarios: [short.yaml]
parameters:
  - {name: task_space_gains_p/rx, lower: 10, upper: 60}
  - {name: slerpDurationErrorGain, lower: 1, upper: 4, scale: linear}
objective: [{metric: error/orientation/rms, weight: 1}]
constraints: [{metric: joint_velocity/max_ratio, at_most: 0.9}]
search: {algorithm: COBYLA, max_evaluations: 8, seed: 1}
"""


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)


class Module(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "short.yaml").write_text(SHORT)
        (self.folder / "study.yaml").write_text(STUDY)
        self.scenario = armtune.load_scenario(str(self.folder / "short.yaml"))
        self.gains = armtune.load_gains("published", self.scenario)
        self.gains["joint_trajectory_duration"] = 2.0  # so that little of 8 s goes by before it tracks
        self.quick = self.folder / "quick.yaml"
        self.quick.write_text(self.gains.text())

    def rollout(self, **options):
        (rollout,) = armtune.simulate([self.scenario], self.gains, **options)
        return rollout

    def test_errors_and_columns_are_the_programs_to_the_byte(self):
        self.assertEqual(run("simulate", self.folder / "short.yaml", "--gains", self.quick, "--out", self.folder / "run").returncode, 0)
        rollout = self.rollout()
        armtune.write_errors([rollout], str(self.folder / "errors.csv"))
        self.assertEqual((self.folder / "errors.csv").read_bytes(), (self.folder / "run/errors.csv").read_bytes())
        rows = np.genfromtxt(self.folder / "run/rollout_short.csv", delimiter=",", names=None, skip_header=1)
        self.assertEqual(rows.shape, (len(rollout), len(rollout.keys())))
        for place, name in enumerate(rollout.keys()):
            np.testing.assert_array_equal(rollout[name], rows[:, place], err_msg=name)

    def test_columns_are_the_rollouts_own_numbers(self):
        rollout = self.rollout()
        first, again = rollout["time"], rollout["time"]
        self.assertTrue(np.shares_memory(first, again))
        self.assertFalse(first.flags.owndata)
        self.assertFalse(first.flags.writeable)
        self.assertEqual(first.strides[0], 8 * len(rollout.keys()), "row by row, as they were recorded")
        kept = np.array(first)
        del rollout, again  # the array keeps what it shows
        np.testing.assert_array_equal(first, kept)
        with self.assertRaises(KeyError):
            self.rollout()["no such column"]

    def test_gains_are_arrays_onto_their_numbers(self):
        self.gains["task_space_gains_p"][3] = 30.0
        self.assertEqual(self.gains["task_space_gains_p"][3], 30.0)
        twin = self.gains.copy()
        twin["task_space_gains_p"] = [1, 2, 3, 4, 5, 6]
        twin["slerpDurationErrorGain"] = 1.5
        twin["gaze_feedforward"] = True
        self.assertEqual(self.gains["task_space_gains_p"][3], 30.0)
        (self.folder / "gains.yaml").write_text(twin.text())
        back = armtune.load_gains(str(self.folder / "gains.yaml"), self.scenario)
        for name in twin.keys():
            np.testing.assert_array_equal(back[name], twin[name], err_msg=name)
        with self.assertRaises(KeyError):
            self.gains["task_space_gains_q"]
        with self.assertRaisesRegex(armtune.InputError, "give 6"):
            self.gains["task_space_gains_p"] = [1, 2]
        self.gains["task_space_gains_p"][0] = -1.0
        with self.assertRaisesRegex(armtune.InputError, "task_space_gains_p"):
            self.rollout()

    def test_force_gains_are_one_per_point_or_a_row_per_point(self):
        name = "force_control_gains"
        self.assertEqual(self.gains[name].shape, (6,))
        rows = np.arange(36.0).reshape(6, 6)
        for value in (rows, rows.tolist()):
            self.gains[name] = value
            np.testing.assert_array_equal(self.gains[name], rows)
        self.gains[name][2, 1] = 99.0
        (self.folder / "gains.yaml").write_text(self.gains.text())
        back = armtune.load_gains(str(self.folder / "gains.yaml"), self.scenario)
        self.assertEqual(back[name][2, 1], 99.0)
        self.assertEqual(back[name][1, 2], rows[1, 2])
        for wrong in ([1.0, 2.0], rows[:5], rows.ravel()):
            with self.assertRaisesRegex(armtune.InputError, "give 6"):
                self.gains[name] = wrong
        self.gains[name] = np.full(6, 5.0)
        self.assertEqual(self.gains[name].shape, (6,))

    def test_behaves_like_a_mapping(self):
        self.assertEqual(list(self.gains), self.gains.keys())
        self.assertEqual(len(self.gains), len(self.gains.keys()))
        self.assertIn("task_space_gains_p", self.gains)
        self.assertNotIn("task_space_gains_q", self.gains)
        for twin in (copy.copy(self.gains), copy.deepcopy(self.gains)):
            twin["slerpDurationErrorGain"] = 7.5
            self.assertNotEqual(self.gains["slerpDurationErrorGain"][0], 7.5)
        rollout = self.rollout()
        self.assertIn("time", rollout)
        self.assertNotIn("tide", rollout)

    def test_variants_of_a_scenario_go_by_names(self):
        other = armtune.load_scenario(self.folder / "short.yaml")
        other.duration = 4.0
        with self.assertRaisesRegex(armtune.InputError, "rename one"):
            armtune.simulate([self.scenario, other], self.gains)
        other.name = "shorter"
        long, short = armtune.simulate([self.scenario, other], self.gains)
        self.assertEqual((long.scenario, short.scenario), ("short", "shorter"))
        self.assertLess(len(short), len(long))
        np.testing.assert_array_equal(short["time"], long["time"][: len(short)])

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

    def test_many_gain_sets_are_each_alone(self):
        sets = []
        for value in (1.0, 2.0, 3.0):
            sets.append(self.gains.copy())
            sets[-1]["slerpDurationErrorGain"] = value
        for engine in ("simbody", "native"):
            together = armtune.simulate([self.scenario], sets, engine=engine, workers=2)
            self.assertEqual(len(together), 3)
            for gains, (rollout,) in zip(sets, together):
                (alone,) = armtune.simulate([self.scenario], gains, engine=engine)
                self.assertEqual(armtune.errors_csv([rollout]), armtune.errors_csv([alone]))
        with self.assertRaisesRegex(ValueError, "engine: mujoco"):
            armtune.simulate([self.scenario], sets, engine="mujoco")

    def test_a_rollout_says_what_it_is_and_gives_its_columns(self):
        rollout = self.rollout()
        self.assertIn("short: completed", repr(rollout))
        columns = rollout.columns
        self.assertEqual(list(columns), rollout.keys())
        self.assertTrue(np.shares_memory(columns["time"], rollout["time"]))
        self.assertEqual(list(rollout), rollout.keys())
        self.assertTrue(armtune.simulate([self.scenario], [self.gains], engine="native")[0][0], "without a recording, too")
        try:
            import pandas
        except ModuleNotFoundError:
            return
        frame = pandas.DataFrame(rollout.columns)
        self.assertEqual(frame.shape, (len(rollout), len(rollout.keys())))

    def test_a_law_written_in_python_drives_the_arm(self):
        calls = []

        def make(robot, gains, period):
            stiffness = np.array(gains["python_stiffness"])
            self.assertEqual(robot.joints, gains.joints)

            def torque(now):
                calls.append(now)
                tau = now.model_torque(now.reference_velocity, now.reference_acceleration)
                return tau - stiffness * now.sliding

            return torque

        own = {"shape": "joints", "unit": "N m s/rad", "meaning": "of S", "otherwise": 0.0}
        uses = ["task_space_gains_p", "task_space_gains_i"]
        armtune.register_controller("python_law", make, uses=uses, own=[{**own, "name": "python_stiffness"}])
        study = armtune.make_study(
            {"controller": "python_law", "objective": [{"metric": "error/position/max"}]}, scenarios=[self.scenario], gains=self.gains
        )
        gains = study.start
        self.assertEqual(gains.controller, "python_law")
        gains["python_stiffness"] = 40.0
        self.scenario.duration = 1.0
        (rollout,) = armtune.simulate([self.scenario], gains)
        self.assertGreater(len(calls), 100)
        with self.assertRaisesRegex(RuntimeError, "over"):
            calls[0].position
        gains["python_stiffness"] = 80.0
        (stiffer,) = armtune.simulate([self.scenario], gains)
        self.assertLess(np.abs(stiffer["joint/elbow_joint/velocity"] - rollout["joint/elbow_joint/velocity"]).max(), 1.0)
        self.assertGreater(np.abs(stiffer["joint/elbow_joint/velocity"] - rollout["joint/elbow_joint/velocity"]).max(), 0.0)

        def wrong(robot, gains, period):
            return lambda now: [1.0]

        armtune.register_controller("short_law", wrong, own=[{**own, "name": "short_stiffness"}])
        study = armtune.make_study(
            {"controller": "short_law", "objective": [{"metric": "error/position/max"}]}, scenarios=[self.scenario], gains=self.gains
        )
        with self.assertRaisesRegex(armtune.FailedError, "short_law: 1 torques were returned, but the arm has 6"):
            armtune.simulate([self.scenario], study.start)

        def broken(robot, gains, period):
            return lambda now: now.no_such_thing

        armtune.register_controller("broken_law", broken, own=[{**own, "name": "broken_stiffness"}])
        study = armtune.make_study(
            {"controller": "broken_law", "objective": [{"metric": "error/position/max"}]}, scenarios=[self.scenario], gains=self.gains
        )
        with self.assertRaisesRegex(AttributeError, "no_such_thing"):
            armtune.simulate([self.scenario], study.start)

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

    def test_python_goes_on_while_it_works(self):
        counted = [0]
        done = threading.Event()

        def count():
            while not done.wait(0.001):
                counted[0] += 1

        thread = threading.Thread(target=count)
        thread.start()
        before = counted[0]
        self.rollout()
        after = counted[0]
        done.set()
        thread.join()
        self.assertGreater(after, before + 10)

    def test_what_progress_raises_ends_the_work(self):
        def trouble(*_):
            raise ZeroDivisionError("mine")

        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            self.rollout(progress=trouble)
        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            armtune.tune(armtune.load_study(str(self.folder / "study.yaml")), progress=trouble)

    def test_ctrl_c_ends_a_search_and_gives_what_it_found(self):
        # A search that has no reason to end before.
        (self.folder / "study.yaml").write_text(STUDY.replace("COBYLA", "CRS2"))
        script = (
            "import armtune\n"
            f"study = armtune.load_study({str(self.folder / 'study.yaml')!r})\n"
            "study.max_evaluations = 100000\n"
            "try:\n"
            "    armtune.tune(study, progress=lambda at: at.done == 3 and print('under way', flush=True))\n"
            "except KeyboardInterrupt as error:\n"
            "    tuned = error.result\n"
            "    assert len(tuned.objectives) >= 3 and tuned.reason == 'interrupted'\n"
            "    feasible = tuned.objectives[tuned.violations == 0]\n"
            "    assert tuned.objective == feasible.min()\n"
            "    assert tuned.best.text().count('task_space_gains_p') == 1\n"
            "    print('interrupted')\n"
        )
        self.interrupt(script)

    def test_a_search_interrupted_at_once_has_its_start(self):
        study = armtune.load_study(self.folder / "study.yaml")
        threading.Timer(0.01, signal.raise_signal, [signal.SIGINT]).start()
        with self.assertRaises(armtune.Interrupted) as caught:
            armtune.tune(study)
        tuned = caught.exception.result
        self.assertEqual(tuned.points.shape[1], 2)
        if len(tuned.objectives) == 0:
            self.assertEqual(tuned.best.text(), tuned.start.text())
            self.assertTrue(np.isnan(tuned.objective))

    def test_ctrl_c_ends_one_long_rollout(self):
        self.interrupt(
            "import armtune, threading\n"
            "scenario = armtune.load_scenario('moving_target')\n"
            "scenario.duration = 20000\n"
            "gains = armtune.load_gains('published', scenario)\n"
            "threading.Timer(0.5, lambda: print('under way', flush=True)).start()\n"
            "try:\n"
            "    armtune.simulate([scenario], gains, record_every=1000)\n"
            "except KeyboardInterrupt:\n"
            "    print('interrupted')\n"
        )

    def interrupt(self, script):
        """Runs a script in a process of its own, and interrupts it once it says that it is under way."""
        took = []
        # A machine that does something else for a second is no fault of ours: of three calls one has to be in time.
        while len(took) < 3 and min(took, default=9.0) >= 1.0:
            child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
            self.addCleanup(child.stdout.close)
            self.assertEqual(child.stdout.readline(), "under way\n")
            sent = time.monotonic()
            child.send_signal(signal.SIGINT)
            said, _ = child.communicate(timeout=60)
            took.append(time.monotonic() - sent)
            self.assertEqual(said, "interrupted\n")
        print(f"Ctrl-C: returned after {min(took):.2f} s", file=sys.stderr)
        self.assertLess(min(took), 1.0)

    def test_errors_say_what_to_do(self):
        with self.assertRaisesRegex(armtune.InputError, "'moving_target'"):
            armtune.load_scenario("moving_targt")
        with self.assertRaisesRegex(ValueError, "workers"):
            self.rollout(workers=0)
        for duration in (0.0, -1.0, 1e-4, float("nan"), 1e12):
            with self.assertRaisesRegex(armtune.InputError, "duration"):
                self.scenario.duration = duration
        with self.assertRaisesRegex(TypeError, "None"):
            armtune.errors_csv([None])
        for name, value, must in (
            ("task_space_gains_p", "much", "numbers"),
            ("task_space_gains_p", [1, 2, 3, 4, 5, None], "numbers"),
            ("gaze_feedforward", "much", "True or False"),
        ):
            with self.assertRaisesRegex(TypeError, f"{name}: .*; give {must}"):
                self.gains[name] = value
        study = armtune.load_study(self.folder / "study.yaml")
        with self.assertRaisesRegex(ValueError, "max_evaluations: -5"):
            study.max_evaluations = -5
        with self.assertRaisesRegex(ValueError, "seed: -1"):
            study.seed = -1
        with self.assertRaisesRegex(ValueError, "workers: 100000"):
            self.rollout(workers=100000)
        broken = self.gains.copy()
        broken["task_space_gains_p"][0] = float("nan")
        with self.assertRaisesRegex(armtune.InputError, "task_space_gains_p/x"):
            broken.text("ros1")
        unknown = self.folder / "unknown.yaml"
        unknown.write_text("base: moving_target\npath: {center: [1, 2]}\n")
        with self.assertRaises(armtune.InputError) as caught:
            armtune.load_scenario(unknown)
        self.assertEqual((caught.exception.file, caught.exception.line, caught.exception.key), (str(unknown), 2, "path/center"))
        self.assertEqual((caught.exception.value, caught.exception.limit), ("2", "3 numbers"))
        with self.assertRaises(armtune.InputError) as caught:
            self.rollout(workers=100000)
        self.assertEqual((caught.exception.file, caught.exception.key, caught.exception.value, caught.exception.limit),
                         (None, "workers", "100000", "1 to 1024"))
        with self.assertRaises(armtune.InputError) as caught:
            armtune.load_scenario("moving_targt")
        self.assertEqual((caught.exception.line, caught.exception.key, caught.exception.value), (None, None, "moving_targt"))
        for name in ("", "a,b", "../up", "=1"):
            with self.assertRaisesRegex(armtune.InputError, "name: "):
                self.scenario.name = name
        panda = armtune.load_scenario("panda_moving_target")
        with self.assertRaisesRegex(ValueError, "other joints"):
            armtune.simulate([panda], self.gains)
        with self.assertRaisesRegex(TypeError, "gains"):
            armtune.simulate([self.scenario], None)
        with self.assertRaisesRegex(armtune.InputError, "criteria: 0"):
            armtune.front(study, [])
        with self.assertRaisesRegex(armtune.InputError, "folder: 'nonsense'"):
            armtune.bundled("nonsense")

    def test_a_daemon_thread_at_work_does_not_abort_the_end_of_the_script(self):
        (self.folder / "study.yaml").write_text(STUDY.replace("COBYLA", "CRS2"))
        begin = (
            "import armtune, sys, threading, time\n"
            f"study = armtune.load_study({str(self.folder / 'study.yaml')!r})\n"
            "study.max_evaluations = 100000\n"
            "scenario = armtune.load_scenario('moving_target')\n"
            "scenario.duration = 20000\n"
            "gains = armtune.load_gains('published', scenario)\n"
            "def again():\n"
            "    while True:\n"
            "        try:\n"
            "            armtune.tune(study)\n"
            "        except Exception:\n"
            "            pass\n"
        )
        works = {
            "tune": "lambda: armtune.tune(study)",
            "tune with progress": "lambda: armtune.tune(study, workers=2, progress=lambda at: None)",
            "simulate": "lambda: armtune.simulate([scenario], gains, record_every=1000)",
            "tune again and again": "again",
            "a progress that sleeps": "lambda: armtune.tune(study, progress=lambda at: time.sleep(0.2))",
        }
        for name, work in works.items():
            for ending in ("", "sys.exit(7)\n"):
                with self.subTest(name, ending=ending):
                    script = begin + f"threading.Thread(target={work}, daemon=True).start()\ntime.sleep(0.7)\n" + ending
                    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
                    self.assertEqual((done.returncode, done.stderr), (7 if ending else 0, ""))

    def test_objects_that_hold_nothing_cannot_be_made(self):
        script = (
            "import armtune, copy, pickle\n"
            "made = {'Scenario': armtune.load_scenario('moving_target'), 'Study': armtune.load_study('ur10_gaze')}\n"
            "made['Scenario'].duration = 0.1\n"
            "made['Gains'] = armtune.load_gains('published', made['Scenario'])\n"
            "(made['Rollout'],) = armtune.simulate([made['Scenario']], made['Gains'])\n"
            "made['Robot'] = made['Scenario'].robot\n"
            "classes = [one for one in vars(armtune).values() if isinstance(one, type) and not issubclass(one, BaseException)]\n"
            "assert len(classes) > 15\n"
            "for one in classes:\n"
            "    class Sub(one):\n"
            "        def __init__(self): pass\n"
            "    ways = [lambda: one.__new__(one), lambda: one(), lambda: object.__new__(one), lambda: Sub(), lambda: Sub.__new__(Sub),\n"
            "            lambda: one.__base__.__new__(one)]\n"
            "    if one.__name__ in made:\n"
            "        thing = made[one.__name__]\n"
            "        other = classes[(classes.index(one) + 1) % len(classes)]\n"
            "        ways += [lambda: pickle.loads(pickle.dumps(thing)), lambda: setattr(thing, '__class__', other)]\n"
            "        if one is not armtune.Gains: ways.append(lambda: copy.copy(thing))\n"
            "    for place, way in enumerate(ways):\n"
            "        try:\n"
            "            empty = way()\n"
            "        except TypeError:\n"
            "            continue\n"
            "        print(one.__name__, place, 'was made', flush=True)\n"
            "        for name in dir(empty): getattr(empty, name, None)\n"
        )
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_names_that_are_not_utf_8_are_shown(self):
        folder = os.fsencode(self.folder) + b"/caf\xe9"
        os.mkdir(folder)
        for load in (armtune.load_scenario, armtune.load_study, lambda name: armtune.load_gains(name, self.scenario)):
            with self.assertRaisesRegex(armtune.InputError, r"caf.*nowhere\.yaml"):
                load(folder + b"/nowhere.yaml")
            with self.assertRaisesRegex(armtune.InputError, r"caf.*nowhere\.yaml"):
                load(os.fsdecode(folder + b"/nowhere.yaml"))
        with open(folder + b"/caf\xe9.yaml", "w") as file:
            file.write(SHORT)
        with self.assertRaisesRegex(armtune.InputError, r"caf.*UTF-8"):
            armtune.load_scenario(folder + b"/caf\xe9.yaml")
        (rollout,) = armtune.simulate([self.scenario], self.gains)
        with self.assertRaisesRegex(armtune.InputError, "caf.*errors"):
            armtune.write_errors([rollout], folder + b"/none/errors.csv")

    def test_the_example_gives_the_programs_bytes(self):
        # 3: the published gains saturate the elbow when the task begins.
        self.assertEqual(run("simulate", "moving_target", "--out", self.folder / "run").returncode, 3)
        out = self.folder / "errors.csv"
        done = subprocess.run([sys.executable, ROOT / "examples/python/published_figures.py", out], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("largest error along x: 0.00", done.stdout)
        self.assertEqual(out.read_bytes(), (self.folder / "run/errors.csv").read_bytes())

    def test_the_stub_says_what_there_is(self):
        tree = ast.parse((ROOT / "python/armtune/__init__.pyi").read_text())
        stub = {node.name: node for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(set(stub), set(armtune.__all__))
        for name, node in stub.items():
            if not isinstance(node, ast.ClassDef):
                continue
            said = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
            said |= {n.target.id for n in node.body if isinstance(n, ast.AnnAssign)}
            public = {member for member in vars(getattr(armtune, name)) if not member.startswith("_")}
            special = {"__getitem__", "__setitem__", "__len__", "__iter__", "__contains__", "__copy__", "__deepcopy__"}
            public |= special & set(vars(getattr(armtune, name)))
            public |= set(vars(getattr(armtune, name)).get("__annotations__", {}))
            self.assertEqual(said, public, name)


if __name__ == "__main__":
    unittest.main()
