"""What tests of the Python module share: the program, a short scenario and a study of it."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

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


class ModuleCase(unittest.TestCase):
    """A short scenario and study in a folder, and gains that track soon."""

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
