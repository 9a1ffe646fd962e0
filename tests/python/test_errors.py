"""Errors of the Python module, its names, and its stub."""

import ast
import copy
import os
import subprocess
import sys

import armtune
from module_case import ModuleCase, ROOT, SHORT


class Errors(ModuleCase):
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
