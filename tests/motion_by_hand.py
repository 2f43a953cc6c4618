"""How an object moves, in NumPy: what the kernel of motion is compared with.

Wind and water are asked of `Wind.load` and `Current.load`, the drag of turning is added up by
Gauss's rule, the inertia's forces come from Kirchhoff's equations, and robots go their exact way.
"""

import numpy as np

from swarmgrasp.simulation.motion import AROUND, FIXED, FREE, following_of

NODES, WEIGHTS = np.polynomial.legendre.leggauss(3)


def turned(vectors, angles):
    """Turn vectors (runs, 2) counter-clockwise."""
    c, s = np.cos(angles), np.sin(angles)
    x, y = vectors[:, 0], vectors[:, 1]
    return np.column_stack([c * x - s * y, s * x + c * y])


def turning_drag(length, factor, v, r):
    """Return force and moment of cross-flow drag beyond that of no turning; Gauss is exact here."""
    force, moment = np.zeros_like(v), np.zeros_like(v)
    still = np.clip(
        np.divide(-v, r, out=np.full_like(v, np.inf), where=r != 0.0), -length / 2, length / 2
    )
    for low, high in ((-length / 2, still), (still, length / 2)):
        for node, weight in zip(NODES, WEIGHTS, strict=True):
            x = 0.5 * (low + high) + 0.5 * node * (high - low)
            strip = v + x * r
            drag = np.abs(strip) * strip - np.abs(v) * v
            force -= factor * 0.5 * (high - low) * weight * drag
            moment -= factor * 0.5 * (high - low) * weight * x * drag
    return force, moment


def loads(plant, states, streams):
    """Return the wrenches (runs, 3) of wind and of water."""
    outline, wind, current = plant.swarm.outline, plant.environment.wind, plant.environment.current
    corners = outline.vertices - outline.origin
    midship, length = 0.5 * (corners.max(axis=0) + corners.min(axis=0)), np.ptp(corners[:, 0])
    psi, r = states[:, 2], states[:, 5]
    swing = states[:, 3:5] + r[:, None] * np.array([-midship[1], midship[0]])
    air = turned(streams[:, :2] - streams[:, 2:], -psi) - swing
    water = -swing
    from_air = wind.load(outline, np.arctan2(air[:, 1], -air[:, 0]), np.hypot(*air.T))
    from_water = current.load(outline, np.arctan2(water[:, 1], -water[:, 0]), np.hypot(*water.T))
    factor = 0.5 * current.density * current.lateral_area / length * current.coefficients.sway
    force, moment = turning_drag(length, factor, swing[:, 1], r)
    from_water[:, 1] += force
    from_water[:, 2] += moment + midship[0] * force
    return from_air, from_water


def given(plant, states):
    """Return the wrenches (runs, 3) of the robots."""
    n, psi = len(plant), states[:, 2]
    arms = plant.swarm.contacts - plant.swarm.outline.origin
    found = np.zeros((len(states), 3))
    for i, (name, actuator) in enumerate(zip(plant.swarm.names, plant.each_actuator, strict=True)):
        angle = states[:, 6 + n + i]
        if actuator.follows == "earth":
            angle = angle - (psi - plant.headings.get(name, 0.0))
        size = actuator.efficiency * states[:, 6 + i]
        x, y = size * np.cos(angle), size * np.sin(angle)
        found += np.column_stack([x, y, arms[i, 0] * y - arms[i, 1] * x])
    return found


def left_of(way, lag, rate, time):
    """Return what is left of a way after a time, as `Actuator` says."""
    ramp = lag * rate
    size = np.abs(way)
    start = np.maximum(0.0, (size - ramp) / rate)
    slow = np.minimum(size, ramp) * np.exp(-np.maximum(0.0, time - start) / lag)
    return np.sign(way) * np.where(time < start, size - rate * time, slow)


def later(plant, states, orders, time):
    """Return the robots' forces and angles (runs, 2 n) some time after orders."""
    n, swarm = len(plant), plant.swarm
    forces, angles = states[:, 6 : 6 + n].copy(), states[:, 6 + n :].copy()
    for i, (actuator, following) in enumerate(
        zip(plant.each_actuator, following_of(swarm), strict=True)
    ):
        lag, rate = actuator.lag, swarm.limits[i] / actuator.slew
        force, angle = orders[:, i].T
        if following == FREE:
            end = force * np.exp(1j * angle)
            way = end - forces[:, i] * np.exp(1j * angles[:, i])
            size = np.maximum(np.abs(way), 1e-300)
            vector = end - way / size * left_of(size, lag, rate, time)
            forces[:, i], angles[:, i] = np.abs(vector), np.angle(vector)
            continue
        forces[:, i] = force - left_of(force - forces[:, i], lag, rate, time)
        if following == FIXED:
            continue
        way = angle - angles[:, i]
        if following == AROUND:
            way = (way + np.pi) % (2.0 * np.pi) - np.pi
        angles[:, i] = angle - left_of(way, actuator.turn_lag, actuator.turn_rate, time)
    return np.concatenate([forces, angles], axis=1)


def rates(plant, states, streams, extra):
    """Return the rates of change (runs, 6) of pose and velocity."""
    hull, (u, v, r), psi = plant.whole, states[:, 3:6].T, states[:, 2]
    ground = turned(states[:, 3:5], psi) + streams[:, 2:]
    over = np.column_stack([turned(ground, -psi), r])
    wrench = given(plant, states) + sum(loads(plant, states, streams)) + extra
    wrench -= np.einsum("ij,kj->ki", np.array(hull.damping), over)
    px, py, _ = np.einsum("ij,jk->ik", hull.matrix, np.array([u, v, r]))
    a11, a22, _ = hull.added
    p, q = hull.added_at
    munk = (a22 - a11) * (u - q * r) * (v + p * r)  # in the coefficients of DNV already
    wrench -= np.column_stack([-r * py, r * px, u * py - v * px - munk])
    return np.column_stack([ground, r, np.linalg.solve(hull.matrix, wrench.T).T])


def advance(plant, states, orders, streams, extra, step, steps):
    """Return the states some steps on."""
    states = np.array(states, dtype=float)
    for _ in range(steps):
        middle, end = (later(plant, states, orders, part * step) for part in (0.5, 1.0))
        slopes, start = [], states[:, 6:]
        for part, robots in ((0.0, start), (0.5, middle), (0.5, middle), (1.0, end)):
            body = states[:, :6] + (part * step * slopes[-1] if slopes else 0.0)
            slopes.append(rates(plant, np.hstack([body, robots]), streams, extra))
        weights = np.array([1.0, 2.0, 2.0, 1.0]) * step / 6.0
        body = states[:, :6] + sum(w * slope for w, slope in zip(weights, slopes, strict=True))
        states = np.hstack([body, end])
    return states
