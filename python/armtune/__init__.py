"""Offline trajectory and gain tuning for robot arms.

    import armtune

    scenario = armtune.load_scenario("moving_target")
    gains = armtune.load_gains("published", scenario)
    (rollout,) = armtune.simulate([scenario], gains)
    print(rollout.metrics["error/position/max"], rollout["time"][-1])
"""

import os as _os
import pathlib as _pathlib
import sys as _sys

# The bundled data of a build folder (python/armtune/ in it) or of a prefix (lib/python3/dist-packages/armtune/).
for _above in _pathlib.Path(__file__).absolute().parents[2:5:2]:
    if (_above / "share" / "armtune").is_dir():
        _os.environ.setdefault("ARMTUNE_DATA", str(_above / "share" / "armtune"))

from ._armtune import (  # noqa: E402
    Gains,
    InputError,
    Rollout,
    Scenario,
    Study,
    Tuned,
    arithmetic,
    baseline_tunables,
    bundled,
    errors_csv,
    load_gains,
    load_scenario,
    load_study,
    simulate,
    tune,
    versions,
    write_errors,
)

__version__ = dict(versions())["armtune"]


class Interrupted(KeyboardInterrupt):
    """Ctrl-C in tune(): `tuned` has the best gains and the evaluations so far."""

    tuned: Tuned


__all__ = [name for name in dir() if not name.startswith("_")] + ["compute_as_the_program"]


def compute_as_the_program() -> None:
    """Begins the running script anew, where its figures would differ from the program's in the last bit.

    The C library takes other variants of sin, exp ... on processors that have FMA. The program `armtune` asks for those that
    every processor has, before it starts; a script does so by calling this first. Where that is not possible it goes on as
    it is, and arithmetic() says so.
    """
    tried = "ARMTUNE_ARITHMETIC_TRIED"
    if arithmetic()[0].startswith("baseline") or _os.environ.get(tried) == str(_os.getpid()):
        return
    script = getattr(_sys.modules["__main__"], "__file__", None)
    if script is None or not _os.path.isfile(script):
        return  # typed, piped or in a notebook: it cannot begin again
    _os.environ[tried] = str(_os.getpid())
    _os.environ["GLIBC_TUNABLES"] = baseline_tunables(_os.environ.get("GLIBC_TUNABLES", ""))
    _sys.stdout.flush()
    _sys.stderr.flush()
    _os.execv(_sys.executable, _sys.orig_argv)
