"""The Python module holds no lock while it works, and Ctrl-C ends its work."""

import signal
import subprocess
import sys
import threading
import time

import numpy as np

import armtune
from module_case import ModuleCase, STUDY


class Interrupts(ModuleCase):
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
