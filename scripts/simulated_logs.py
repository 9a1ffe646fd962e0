#!/usr/bin/env python3
"""Usage: scripts/simulated_logs.py [--help]

Logs of simulated arms, for scripts/check-logs, which imports them: arms that differ a little from their robot files, their motions,
and the changes that recorders, drivers and mistakes make to the numbers. Run by itself, it lists the arms.
"""

import copy
import csv
import math
import pathlib
import random
import re
import subprocess
import sys
import xml.etree.ElementTree as ET

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/bin/armtune"
DEGREE = math.pi / 180
UR_CENTER = ["--center", "0,-90,-60,-90,90,0"]
# Where the excitation is centred, and two joints that bear the weight of the arm.
ARMS = {
    "ur3e": dict(center=UR_CENTER, loaded=(1, 2)),
    "ur5e": dict(center=UR_CENTER, loaded=(1, 2)),
    "ur10": dict(center=UR_CENTER, loaded=(1, 2)),
    "panda": dict(center=[], loaded=(1, 3)),
    "iiwa14": dict(center=[], loaded=(1, 3)),
    "xarm6": dict(center=[], loaded=(1, 2)),
    "gen3_7": dict(center=[], loaded=(1, 3)),
    "youbot": dict(center=[], loaded=(1, 2)),
}
# Sensor noise: position [rad], velocity [rad/s], torque as a share of the effort limit.
POSITION_NOISE, VELOCITY_NOISE, TORQUE_NOISE = 5e-5, 2e-3, 0.003


def run(*arguments, cwd):
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=cwd, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def needed(*arguments, cwd, codes=(0,)):
    code, out, err = run(*arguments, cwd=cwd)
    if code not in codes:
        sys.exit(f"scripts/check-logs: armtune {' '.join(map(str, arguments))} ended with {code}:\n{out}{err}")


class Log:
    """Times, and for each quantity a list of rows with a number for each joint."""

    def __init__(self, joints, time, position, velocity, torque):
        self.joints, self.time, self.position, self.velocity, self.torque = joints, time, position, velocity, torque

    @staticmethod
    def read(path, joints):
        with open(path, encoding="utf-8") as lines:
            rows = list(csv.DictReader(lines))
        def of(key):
            return [[float(row[f"joint/{joint}/{key}"]) for joint in joints] for row in rows]
        return Log(joints, [float(row["time"]) for row in rows], of("position"), of("velocity"), of("torque"))

    def copy(self):
        return copy.deepcopy(self)

    def keep(self, rows):
        for key in ("time", "position", "velocity", "torque"):
            values = getattr(self, key)
            setattr(self, key, [values[i] for i in rows])
        return self

    def column(self, key, joint, change):
        """Replaces the values of a joint by change(list of them)."""
        rows = getattr(self, key)
        for row, value in zip(rows, change([row[joint] for row in rows])):
            row[joint] = value

    def scale(self, key, factor, joints=None):
        for joint in range(len(self.joints)) if joints is None else joints:
            self.column(key, joint, lambda values: [factor * x for x in values])

    def write(self, path, names="joint/{}/{}", units=None, separator=",", time="time", velocity=True, stamp=repr):
        """names: of a column, from joint and quantity. units: behind the names, by quantity."""
        keys = ["position", "velocity", "torque"] if velocity else ["position", "torque"]
        head = [time] + [names.format(joint, key) + (units or {}).get(key, "") for key in keys for joint in self.joints]
        with open(path, "w", encoding="utf-8") as out:
            out.write(separator.join(head) + "\n")
            for i, t in enumerate(self.time):
                numbers = [f"{x:.9g}" for key in keys for x in getattr(self, key)[i]]
                out.write(separator.join([stamp(t), *numbers]) + "\n")
        return path


class Arm:
    """One arm: its robot file, an arm that differs from it a little, excitations and logs of them."""

    def __init__(self, name, folder):
        self.name, self.folder, self.facts = name, folder / name, ARMS[name]
        self.folder.mkdir(parents=True, exist_ok=True)
        self.urdf = ET.parse(ROOT / f"sim/robots/{name}.urdf")
        moving = [j for j in self.urdf.getroot().findall("joint") if j.get("type") in ("revolute", "continuous", "prismatic")]
        self.joints = [j.get("name") for j in moving]
        self.effort = [float(j.find("limit").get("effort")) for j in moving]
        self.file = self.robot("file", self.urdf)
        self.truth = self.robot("truth", self.drawn(), friction=1.1)
        self.excited, self.logs = {}, {}

    def robot(self, name, urdf, friction=1.0):
        """Writes the bundled robot's files with this URDF, and with friction, which few robot files have."""
        urdf.write(self.folder / f"{name}.urdf")
        lines = (ROOT / f"sim/robots/{self.name}.yaml").read_text(encoding="utf-8").splitlines()
        text = [line for line in lines if not re.match(r"(urdf|viscous_friction|coulomb_friction):", line)]
        text.append(f"urdf: {name}.urdf")
        text.append(f"coulomb_friction: {[0.02 * friction * e for e in self.effort]}")
        text.append(f"viscous_friction: {[0.01 * friction * e for e in self.effort]}")
        (self.folder / f"{name}.yaml").write_text("\n".join(text) + "\n", encoding="utf-8")
        return f"{name}.yaml"

    def drawn(self):
        """Masses within 3 % and centres of mass within 1 mm of the file's."""
        draw = random.Random(self.name)
        urdf = ET.ElementTree(ET.fromstring(ET.tostring(self.urdf.getroot())))
        for inertial in urdf.iter("inertial"):
            mass, inertia, origin = inertial.find("mass"), inertial.find("inertia"), inertial.find("origin")
            factor = 1 + draw.uniform(-0.03, 0.03)
            mass.set("value", repr(factor * float(mass.get("value"))))
            for key in inertia.keys():
                inertia.set(key, repr(factor * float(inertia.get(key))))
            if origin is not None and origin.get("xyz"):
                origin.set("xyz", " ".join(repr(float(x) + draw.uniform(-0.001, 0.001)) for x in origin.get("xyz").split()))
        return urdf

    def rotated(self, roll):
        """The arm that differs from the file, on a base that is turned about x by an angle [rad]."""
        urdf = self.drawn()
        robot = urdf.getroot()
        children = {j.find("child").get("link") for j in robot.findall("joint")}
        base = next(link.get("name") for link in robot.findall("link") if link.get("name") not in children)
        ET.SubElement(robot, "link", name="mount")
        joint = ET.SubElement(robot, "joint", name="mount_joint", type="fixed")
        ET.SubElement(joint, "parent", link="mount")
        ET.SubElement(joint, "child", link=base)
        ET.SubElement(joint, "origin", rpy=f"{roll!r} 0 0", xyz="0 0 0")
        return self.robot(f"turned_{round(roll / DEGREE)}", urdf, friction=1.1)

    def excitation(self, seed):
        """The folder of a designed excitation."""
        if seed not in self.excited:
            needed("excite", self.file, *self.facts["center"], "--evaluations", 60, "--seed", seed, "--clearance", 0,
                   "--out", f"excite{seed}", cwd=self.folder)
            self.excited[seed] = f"excite{seed}"
        return self.excited[seed]

    def scenario(self, name, robot, seed, period=0.002):
        noise = f"position_noise: {POSITION_NOISE}, velocity_noise: {VELOCITY_NOISE}"
        (self.folder / f"{name}.yaml").write_text(
            f"robot: {robot}\nseed: {seed}\ncontrol_period: {period}\nduration: planned\ntheta_start: {{model_scale: 1}}\n"
            f"planned: {self.excitation(seed)}/trajectory.csv\nplant: {{{noise}}}\n", encoding="utf-8")
        return f"{name}.yaml"

    def log(self, seed, robot=None, name=None):
        """The log of an excitation, at 500 Hz, with noisy torques."""
        name = name or f"log{seed}"
        if name in self.logs:
            return self.logs[name].copy()
        scenario = self.scenario(name, robot or self.truth, seed)
        needed("excite", robot or self.truth, "--trajectory", f"{self.excitation(seed)}/excitation.yaml", "--scenario", scenario,
               "--clearance", 0, "--out", f"{name}_log", cwd=self.folder)
        log = Log.read(self.folder / f"{name}_log/log_{name}.csv", self.joints)
        self.logs[name] = self.noisy(log, seed, position=0.0, velocity=0.0)
        return self.logs[name].copy()

    def rollout(self, name, seed, gains, period=0.002, every=1):
        """A planned motion under a controller: the folder of CSV and MCAP."""
        scenario = self.scenario(name, self.truth, seed, period)
        needed("simulate", scenario, "--gains", gains, "--record-every", every, "--mcap", "--out", f"{name}_run",
               cwd=self.folder, codes=(0, 3))
        return self.folder / f"{name}_run"

    def noisy(self, log, seed, position=POSITION_NOISE, velocity=VELOCITY_NOISE):
        draw = random.Random(f"{self.name} {seed} noise")
        for j, effort in enumerate(self.effort):
            for key, sigma in (("position", position), ("velocity", velocity), ("torque", TORQUE_NOISE * effort)):
                if sigma > 0:
                    log.column(key, j, lambda values, s=sigma: [x + draw.gauss(0, s) for x in values])
        return log

    def ros_file(self, interface):
        """A parameter file of ROS's joint_trajectory_controller, with gains by rule of thumb."""
        gains = []
        for joint, effort in zip(self.joints, self.effort):
            of = f"p: {12 * effort:.4g}, i: {effort:.4g}, d: {0.6 * effort:.4g}, i_clamp: {effort:.4g}" if interface == "effort" \
                else "p: 10.0, i: 0.5, d: 0.0, i_clamp: 1.0, ff_velocity_scale: 1.0"
            gains.append(f"      {joint}: {{{of}}}\n")
        path = self.folder / f"{interface}_controllers.yaml"
        path.write_text(
            "controller_manager:\n  ros__parameters:\n    update_rate: 500\n"
            "    arm_controller: {type: joint_trajectory_controller/JointTrajectoryController}\n"
            f"arm_controller:\n  ros__parameters:\n    joints: [{', '.join(self.joints)}]\n"
            f"    command_interfaces: [{interface}]\n    state_interfaces: [position, velocity]\n    gains:\n" + "".join(gains),
            encoding="utf-8")
        return path.name


# What recorders do to a log.


def lossy(log, share, seed):
    draw = random.Random(seed)
    return log.keep([i for i in range(len(log.time)) if draw.random() >= share])


def every(log, step):
    return log.keep(range(0, len(log.time), step))


def in_degrees(log):
    log.scale("position", 1 / DEGREE)
    log.scale("velocity", 1 / DEGREE)
    return log


def jittery(log, share, seed):
    draw = random.Random(seed)
    period = log.time[1] - log.time[0]
    log.time = [t + draw.uniform(-share, share) * period for t in log.time]
    return log


def with_gap(log, begin, end):
    return log.keep([i for i, t in enumerate(log.time) if not begin <= t < end])


def shifted(log, offset):
    log.time = [t + offset for t in log.time]
    return log


# What drivers and mistakes do to a log.


def late(log, key, seconds):
    """Moves a quantity to later times; below zero, to earlier ones."""
    rows = round(seconds / (log.time[1] - log.time[0]))
    values = getattr(log, key)
    count = len(values)
    setattr(log, key, [list(values[min(max(i - rows, 0), count - 1)]) for i in range(count)])
    return log


def filtered(log, constant):
    keep = math.exp(-(log.time[1] - log.time[0]) / constant)
    def low_pass(values):
        out = [values[0]]
        for x in values[1:]:
            out.append(keep * out[-1] + (1 - keep) * x)
        return out
    for joint in range(len(log.joints)):
        log.column("torque", joint, low_pass)
    return log


def clipped(log, joint, share):
    most = share * max(abs(row[joint]) for row in log.torque)
    log.column("torque", joint, lambda values: [min(most, max(-most, x)) for x in values])
    return log


def frozen(log, key, joint, begin, end):
    first = next(i for i, t in enumerate(log.time) if t >= begin)
    log.column(key, joint, lambda values: [values[first] if begin <= t < end else x for t, x in zip(log.time, values)])
    return log


def geared(log, joint, factor):
    for key, by in (("position", factor), ("velocity", factor), ("torque", 1 / factor)):
        log.scale(key, by, [joint])
    return log


def interrupted(log):
    """The samples of 3 s are missing, and the recorder counted on."""
    time = log.time
    log.keep([i for i, t in enumerate(time) if not 8.0 <= t < 11.0])
    log.time = time[:len(log.time)]
    return log


def started_again(log):
    """The time starts at 0 again in the middle."""
    half = next(i for i, t in enumerate(log.time) if t >= 10.0)
    log.time = [t if i < half else t - log.time[half] for i, t in enumerate(log.time)]
    return log


def faster(log, factor):
    log.time = [t * factor for t in log.time]
    return log


if __name__ == "__main__":
    print(__doc__.strip() if sys.argv[1:] else "\n".join(ARMS))
