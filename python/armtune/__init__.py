"""Offline gain tuning and trajectory planning for robot arms.

    import armtune

    scenario = armtune.load_scenario("moving_target")
    gains = armtune.load_gains("published", scenario)
    (rollout,) = armtune.simulate([scenario], gains)
    print(rollout.metrics["error/position/max"], rollout["time"][-1])
"""

import os as _os
import pathlib as _pathlib

# Finds the bundled data (share/armtune) in a build folder, where this file is in python/armtune/, or below a
# prefix, where it is in lib/python3/dist-packages/armtune/.
for _above in _pathlib.Path(__file__).absolute().parents[2:5:2]:
    if (_above / "share" / "armtune").is_dir():
        _os.environ.setdefault("ARMTUNE_DATA", str(_above / "share" / "armtune"))

from ._armtune import *  # noqa: E402, F403
from ._armtune import versions  # noqa: E402

__version__ = dict(versions())["armtune"]


class Interrupted(KeyboardInterrupt):
    """Raised by Ctrl-C in a long-running function. `result` holds the results so far."""

    result: object


__all__ = [name for name in dir() if not name.startswith("_")]
