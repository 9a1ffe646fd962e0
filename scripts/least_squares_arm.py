#!/usr/bin/python3
"""Usage: scripts/least_squares_arm.py [--help]

The method by which the authors of public recordings identify their arms, for scripts/check-recordings, which imports it: least squares
on the torques of an arm given by a URDF, with masses, first moments and inertias of all links, friction (viscous, Coulomb, constant)
and, where they fit it, rotor inertia. It shares nothing with armtune. Filters are those of shamilmamedov/dynamic_calibration.
"""

import math
import sys
import xml.etree.ElementTree as ET

import numpy as np

EDGE = 1.0        # [s], left out at both ends, where filters have not settled
MOST_ROWS = 3000  # of the fit


def low_pass(x, period, cutoff, order=5):
    """Butterworth's filter forwards and backwards, which squares its gain; the signal is mirrored at its ends."""
    mirrored = np.concatenate([2 * x[0] - x[::-1], x, 2 * x[-1] - x[::-1]])
    frequency = np.fft.rfftfreq(len(mirrored), period)
    gain = 1 / (1 + (frequency / cutoff) ** (2 * order))
    filtered = np.fft.irfft(np.fft.rfft(mirrored, axis=0) * gain[:, None], len(mirrored), axis=0)
    return filtered[len(x):2 * len(x)]


def rotation(axis, angle):
    """Rotations about a fixed axis by N angles: N x 3 x 3 (Rodrigues)."""
    K = cross_matrix(np.asarray(axis)[None])[0]
    return np.eye(3) + np.sin(angle)[:, None, None] * K + (1 - np.cos(angle))[:, None, None] * (K @ K)


def cross_matrix(v):
    zero = np.zeros(len(v))
    return np.stack([np.stack([zero, -v[:, 2], v[:, 1]], 1), np.stack([v[:, 2], zero, -v[:, 0]], 1),
                     np.stack([-v[:, 1], v[:, 0], zero], 1)], 1)


def inertia_columns(w):
    """L(w) with L(w) (Ixx, Ixy, Ixz, Iyy, Iyz, Izz) = I w: N x 3 x 6."""
    x, y, z = w.T
    zero = np.zeros(len(w))
    return np.stack([np.stack([x, y, z, zero, zero, zero], 1), np.stack([zero, x, zero, y, z, zero], 1),
                     np.stack([zero, zero, x, zero, y, z], 1)], 1)


def chain(urdf, joints):
    """The fixed transform before each joint, and its axis."""
    by_child = {j.find("child").get("link"): j for j in ET.parse(urdf).getroot().findall("joint")}
    path, link = [], next(j for j in by_child.values() if j.get("name") == joints[-1]).find("child").get("link")
    while link in by_child:
        path.insert(0, by_child[link])
        link = by_child[link].find("parent").get("link")
    out, R, p = [], np.eye(3), np.zeros(3)
    for joint in path:
        origin = joint.find("origin")
        values = {key: [float(x) for x in (origin.get(key) if origin is not None and origin.get(key) else "0 0 0").split()]
                  for key in ("xyz", "rpy")}
        roll, pitch, yaw = (np.array([x]) for x in values["rpy"])
        p = p + R @ values["xyz"]
        R = R @ (rotation([0, 0, 1], yaw) @ rotation([0, 1, 0], pitch) @ rotation([1, 0, 0], roll))[0]
        if joint.get("name") in joints:
            out.append((R, p, np.array([float(x) for x in joint.find("axis").get("xyz").split()])))
            R, p = np.eye(3), np.zeros(3)
    return out


def regressor(links, q, qd, qdd):
    """Newton and Euler: the torques are linear in mass, first moment and inertia of every link, about its own origin: N x n x 10 n."""
    count, n = q.shape
    R = np.broadcast_to(np.eye(3), (count, 3, 3))
    p, w, alpha, a = (np.zeros((count, 3)) for _ in range(4))
    a = a + [0, 0, 9.81]  # the base accelerates upwards in place of gravity
    axes, origins, wrenches = [], [], []
    for j, (R0, p0, axis) in enumerate(links):
        r = np.einsum("nab,b->na", R, p0)
        a = a + np.cross(alpha, r) + np.cross(w, np.cross(w, r))
        p = p + r
        z = np.einsum("nab,b->na", R @ R0, axis)
        R = R @ R0 @ rotation(axis, q[:, j])
        alpha = alpha + z * qdd[:, j:j + 1] + np.cross(w, z * qd[:, j:j + 1])
        w = w + z * qd[:, j:j + 1]
        wl, al, ll = (np.einsum("nba,nb->na", R, x) for x in (w, alpha, a))
        W = cross_matrix(wl)
        force = np.concatenate([ll[:, :, None], cross_matrix(al) + W @ W, np.zeros((count, 3, 6))], 2)
        moment = np.concatenate([np.zeros((count, 3, 1)), -cross_matrix(ll), inertia_columns(al) + W @ inertia_columns(wl)], 2)
        axes.append(z)
        origins.append(p)
        wrenches.append((R @ force, R @ moment))
    Y = np.zeros((count, n, 10 * n))
    for i in range(n):
        force, moment = wrenches[i]
        for j in range(i + 1):
            about = moment + cross_matrix(origins[i] - origins[j]) @ force
            Y[:, j, 10 * i:10 * i + 10] = np.einsum("na,nab->nb", axes[j], about)
    return Y


def rows_of(log, links, rotors, direction):
    """The authors' observation matrix and torques, N x n x p and N x n. direction: of Coulomb friction, from the velocity."""
    period = log.t[1] - log.t[0]
    nyquist = 0.5 / period
    qd = low_pass(log.qd, period, min(0.15 * nyquist, 16.0))
    qdd = low_pass(np.gradient(qd, period, axis=0), period, min(0.15 * nyquist, 16.0))
    torque = low_pass(log.torque, period, min(0.2 * nyquist, 20.0))
    Y = regressor(links, log.q, qd, qdd)
    count, n = log.q.shape
    extra = [direction(qd), qd, np.ones((count, n))] + ([qdd] if rotors else [])
    own = np.zeros((count, n, len(extra) * n))
    for k, column in enumerate(extra):
        for j in range(n):
            own[:, j, k * n + j] = column[:, j]
    return np.concatenate([Y, own], 2), torque


def explained(fit, held, links, rotors, direction, cutoff):
    """Share of each joint's torque variance that least squares on `fit` explains on `held`, below a cutoff [Hz]."""
    Y, torque = rows_of(fit, links, rotors, direction)
    step = max(1, len(Y) // MOST_ROWS)
    Y, torque = Y[::step], torque[::step]
    solution = np.linalg.lstsq(Y.reshape(-1, Y.shape[2]), torque.reshape(-1), rcond=1e-9)[0]
    Y, _ = rows_of(held, links, rotors, direction)
    period = held.t[1] - held.t[0]
    predicted, measured = (low_pass(x, period, cutoff) for x in (Y @ solution, held.torque))
    edge = math.ceil(EDGE / period)
    left = (measured - predicted)[edge:-edge]
    return 1 - left.var(axis=0) / measured[edge:-edge].var(axis=0)


if __name__ == "__main__":
    print(__doc__.strip())
    sys.exit(0 if sys.argv[1:] else 2)
