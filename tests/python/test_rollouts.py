"""Rollouts, gains and controllers of the Python module, compared with the program."""

import copy
import subprocess
import sys

import numpy as np

import armtune
from module_case import ModuleCase, ROOT, run


class Rollouts(ModuleCase):
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

    def test_the_example_gives_the_programs_bytes(self):
        # 3: the published gains saturate the elbow when the task begins.
        self.assertEqual(run("simulate", "moving_target", "--out", self.folder / "run").returncode, 3)
        out = self.folder / "errors.csv"
        done = subprocess.run([sys.executable, ROOT / "examples/python/published_figures.py", out], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("largest error along x: 0.00", done.stdout)
        self.assertEqual(out.read_bytes(), (self.folder / "run/errors.csv").read_bytes())
