#!/usr/bin/env python3
"""Usage: scripts/machine.py [--help]

Prints the processor as committed results name it, such as "AMD EPYC (family 25, model 1, AVX2)": makers give one name to
processors of very different speed, and how many arms share an instruction depends on the widest vectors. Scripts that write
such results import `processor`.
"""

import pathlib
import platform
import re
import sys

VECTORS = (("avx512f", "AVX-512"), ("avx2", "AVX2"), ("avx", "AVX"), ("asimd", "NEON"))


def processor():
    """Name, family, model and widest vectors."""
    try:
        text = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return platform.machine()

    def said(key):
        found = re.search(rf"^{key}[ \t]*:[ \t]*(.+)$", text, re.MULTILINE)
        return found[1].strip() if found else None

    flags = (said("flags") or said("Features") or "").split()
    details = [f"{word} {said(key)}" for word, key in (("family", "cpu family"), ("model", "model")) if said(key)]
    details += [name for flag, name in VECTORS if flag in flags][:1]
    return (said("model name") or platform.machine()) + (f" ({', '.join(details)})" if details else "")


if __name__ == "__main__":
    print(__doc__ if set(sys.argv) & {"--help", "-h"} else processor())
