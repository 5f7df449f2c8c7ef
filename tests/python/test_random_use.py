"""Random calls, good and bad, on random scenes of every scheme: what a program does that nobody foresaw."""

import copy
import pickle
import random

import numpy as np
import pytest

import rigor

SCHEMES = [{"scheme": "auto"}, {"scheme": "event-driven"}, {"scheme": "time-stepping"},
           {"scheme": "time-stepping", "solver": "substep"}, {"scheme": "penalty"},
           {"scheme": "penalty", "penalty": "global"}, {"scheme": "impulse-based"}, {"scheme": "hybrid"}]
NAN, INF = float("nan"), float("inf")
REFUSALS = (rigor.InputError, TypeError, UnicodeEncodeError)
JOINTS = [{"type": "hinge", "axis": [0.3, 1, 0]}, {"type": "slider", "axis": [1, 0, 0]}, {"type": "ball"}, {"type": "fixed"},
          {"type": "cylindrical", "axis": [0, 1, 0.2]}, {"type": "planar", "axis": [0, 0, 1]},
          {"type": "universal", "axis": [1, 0, 0], "second_axis": [0, 1, 0]}, {"type": "screw", "axis": [0, 0, 1], "pitch": 0.1}]


def random_scene(chance, method):
    def size():
        return chance.uniform(0.05, 0.3)

    bodies = [{"name": "belt", "motion": "kinematic", "position": [0, 3, 1], "shapes": [{"type": "box", "size": [0.5, 0.5, 0.5]}]}]
    if chance.random() < 0.7:
        bodies.append({"name": "floor", "motion": "static", "shapes": [{"type": "plane", "normal": [0, 0, 1], "offset": 0}]})
    joints = []
    for i in range(chance.randint(1, 3)):
        shape = chance.choice([{"type": "sphere", "radius": size()}, {"type": "box", "size": [size(), size(), size()]},
                               {"type": "capsule", "radius": size(), "length": size()},
                               {"type": "cylinder", "radius": size(), "length": size()}])
        bodies.append({"name": f"b{i}", "position": [0.8 * i, 0, 0.8], "mass": 10 ** chance.uniform(-1, 1),
                       "velocity": [chance.uniform(-1, 1) for _ in range(3)],
                       "angular_velocity": [chance.uniform(-3, 3) for _ in range(3)], "shapes": [shape]})
        if chance.random() < 0.5:
            kind = dict(chance.choice(JOINTS), name=f"j{i}", bodies=["world", f"b{i}"])
            joints.append(kind if kind["type"] == "slider" else dict(kind, anchor=[0.8 * i - 0.4, 0, 0.8]))
    return rigor.Scene(run={"step": chance.choice([0.01, 0.002])}, method=dict(method), bodies=bodies, joints=joints)


class Caller:
    """Makes up calls: one argument in ten is wrong."""

    def __init__(self, chance, sim):
        self.chance, self.sim = chance, sim

    def either(self, good, bad):
        return self.chance.choice(bad) if self.chance.random() < 0.1 else good

    def number(self, low, high):
        return self.either(self.chance.uniform(low, high), [NAN, INF, -INF, 1e300, -1, "x", None, [1], 2**70, 1e-320])

    def vector(self, most):
        good = np.array([self.chance.uniform(-most, most) for _ in range(3)])
        return self.either(good, [[NAN, 0, 0], [1, 2], [1, 2, 3, 4], np.zeros((2, 3)), "abc", None, 5, [], [1e300] * 3])

    def body(self):
        k = self.chance.randrange(self.sim.body_count)
        good = self.chance.choice([k, self.sim.body_names[k], np.int64(k)])
        return self.either(good, ["b", "", "world", -1, 99, 2**40, -2**70, 1.5, None, b"b0", "b0\0x", "\ud800"])

    def joint(self):
        good = self.chance.randrange(self.sim.joint_count) if self.sim.joint_count else "none"
        return self.either(good, ["j", -1, 9, 2**40, None, 0.5])

    def pose(self):
        return self.either([self.chance.uniform(-1, 3), self.chance.uniform(-1, 3), self.chance.uniform(0.8, 2)],
                           [[1, 2], [0] * 7, [NAN] * 7, np.zeros((4, 4)), 2 * np.eye(4), "p", [0, 0, 1e300]])

    def call(self):
        chance, number, vector = self.chance, self.number, self.vector
        k = self.either(0, [1, 2, -1, 5, 2**40, "0"])
        calls = [("apply_force", self.body(), vector(5)), ("apply_force", self.body(), vector(5), vector(1)),
                 ("apply_torque", self.body(), vector(0.1)), ("apply_impulse", self.body(), vector(0.2)),
                 ("apply_angular_impulse", self.body(), vector(0.01)),
                 ("set_velocity", self.body(), vector(1), vector(2)), ("set_pose", "belt", self.pose()),
                 ("move_to", self.either("belt", ["b0", "no"]), self.pose(), number(0.05, 0.5)),
                 ("set_motor_velocity", self.joint(), number(-2, 2), number(0, 20), k),
                 ("set_motor_effort", self.joint(), number(-0.5, 0.5), k),
                 ("set_motor_position", self.joint(), number(-0.5, 0.5), number(0, 50), number(0, 5), k, number(0, 10)),
                 ("set_motor_position", self.joint(), number(-0.5, 0.5), number(0, 50), number(0, 5), k),
                 ("release_motor", self.joint(), k), ("set_gravity", vector(10)), ("set_friction", "default", number(0, 1)),
                 ("set_restitution", "default", number(0, 1)), ("contacts",), ("take_events",), ("joint_motion", self.joint()),
                 ("joint_forces", self.joint()), ("ray", vector(2), vector(2)), ("nearest", vector(2), self.either(2, [0, -1, None])),
                 ("restore", self.chance.choice([b"", b"\x81" * 1000000, "x", self.sim.save()[:-3]])), ("is_asleep", self.body())]
        return chance.choice(calls)


def bits(sim):
    return b"".join(a.tobytes() for a in (sim.positions, sim.orientations, sim.velocities, sim.angular_velocities))


def twin_of(sim, chance):
    how = chance.randrange(4)
    if how == 3:
        twin = rigor.Simulation(sim.scene)
        twin.apply_impulse("b0", [1, 2, 3])
        twin.restore(sim.save())
        return twin
    return [sim.copy, lambda: copy.deepcopy(sim), lambda: pickle.loads(pickle.dumps(sim))][how]()


@pytest.mark.parametrize("seed", range(48))
def test_random_calls_are_done_or_refused_and_twins_have_the_same_bits(seed):
    chance = random.Random(seed)
    sim = rigor.Simulation(random_scene(chance, SCHEMES[seed % len(SCHEMES)]), separate=True)
    twin = None
    for _ in range(20):
        name, *arguments = Caller(chance, sim).call()
        before = sim.save()
        try:
            getattr(sim, name)(*arguments)
        except REFUSALS:
            assert sim.save() == before, f"{name}{arguments} was refused and has changed something"
        else:
            if twin is not None and name != "restore":
                getattr(twin, name)(*arguments)
        if twin is None and chance.random() < 0.2:
            twin = twin_of(sim, chance)
            assert twin.save() == sim.save()
        until = sim.time + chance.uniform(0, 0.03)
        advances = [lambda own: own.step(), lambda own: own.advance_to(until)]
        advance = chance.choice(advances)
        try:
            advance(sim)
        except rigor.SimulationStopped as stop:
            if twin is not None:
                with pytest.raises(rigor.SimulationStopped) as again:
                    advance(twin)
                assert str(again.value) == str(stop)
            return
        if twin is not None:
            advance(twin)
            assert bits(twin) == bits(sim), f"after {name}{arguments}"
        assert all(np.isfinite(a).all() for a in (sim.positions, sim.velocities, sim.angular_velocities))


@pytest.mark.parametrize("method", SCHEMES)
def test_free_bodies_follow_parabolas_whatever_is_applied(method):
    chance = np.random.default_rng(7)
    count, h = 4, 0.01
    mass = 10 ** chance.uniform(-1, 1, count)
    scene = rigor.Scene(run={"step": h}, method=method, bodies=[
        {"name": f"b{i}", "position": [10 * i, 0, 0], "mass": mass[i], "shapes": [{"type": "sphere", "radius": 0.1}]} for i in range(count)])
    sim = rigor.Simulation(scene)
    x, v, g = sim.positions.copy(), np.zeros((count, 3)), np.array([0, 0, -9.80665])
    # The substep scheme has velocities of 32 bits and takes the one at the end of a part of a step for all of it.
    soft = method.get("solver") == "substep"
    for _ in range(30):
        i = chance.integers(count)
        force, impulse = chance.normal(size=3), chance.normal(size=3)
        if chance.random() < 0.3:
            g = chance.normal(size=3) * 5
            sim.set_gravity(g)
        if chance.random() < 0.5:
            sim.apply_impulse(int(i), impulse)
            v[i] += impulse / mass[i]
        acceleration = np.tile(g, (count, 1))
        sim.apply_force(int(i), force)
        acceleration[i] += force / mass[i]
        sim.step()
        x += h * v + h**2 / 2 * acceleration
        v += h * acceleration
        assert np.allclose(sim.velocities, v, rtol=0, atol=1e-5 if soft else 1e-12)
        assert np.allclose(sim.positions, x, rtol=0, atol=2e-3 if soft else 1e-11)
    energy = np.sum(mass * (np.sum(v**2, 1) / 2 - x @ g))
    assert sim.energy == pytest.approx(energy, rel=1e-3 if soft else 1e-12)
    assert sim.audit().ok, sim.audit().violations


def test_worlds_of_a_batch_are_all_set_or_none(ball):
    batch = rigor.Batch(ball, 4, 2)
    batch.step()
    before = [batch.world(i).save() for i in range(4)]
    for refused in (lambda: batch.set_frictions("rubber", [0, 1, 2, -1]), lambda: batch.set_gravities(np.full((4, 3), NAN)),
                    lambda: batch.apply_forces("ball", [[0, 0, 1]] * 3 + [[0, 0, INF]]), lambda: batch.reset([0, 99]),
                    lambda: batch.reset(2**40), lambda: batch.reset([1.5]), lambda: batch.reset("x"), lambda: batch.reset(None),
                    lambda: batch.set_states(np.where(np.arange(4)[:, None, None] == 3, NAN, batch.states)),
                    lambda: rigor.Batch(ball, 10**9), lambda: rigor.Batch(ball, 2, 10**6), lambda: rigor.Batch("ball.yaml", 2)):
        with pytest.raises((rigor.InputError, TypeError)):
            refused()
        assert [batch.world(i).save() for i in range(4)] == before
    batch.reset(np.int64(2))
    assert batch.times.tolist() == [0.01, 0.01, 0, 0.01]


def test_worlds_of_a_batch_are_simulations(ball):
    batch = rigor.Batch(ball, 2, 1)
    world = batch.world(1)
    times = []
    world.set_controller(lambda own: times.append(own.time))
    del world
    batch.step()
    batch.step()
    assert times == [0, 0.01]
    twin = batch.world(1).copy()
    saved = batch.world(1).save()
    batch.world(1).set_controller(None)
    batch.step()
    twin.step()
    batch.world(0).restore(saved)
    batch.world(0).step()
    assert bits(twin) == bits(batch.world(1)) == bits(batch.world(0))
    assert batch.world(0).audit().ok


def test_what_is_missing_is_named(ball):
    run = rigor.run(ball, duration=0.02)
    with pytest.raises(KeyError, match="no body 'bal'; there are: floor, ball"):
        run.position["bal"]
    with pytest.raises(KeyError, match="no joint 'axle'; there is none"):
        run.joint_rate["axle"]
    with pytest.raises(TypeError, match="rigor.load"):
        rigor.Simulation("ball.yaml")
    with pytest.raises(TypeError, match="a controller is a function"):
        rigor.Simulation(ball).set_controller(3)
    with pytest.raises(rigor.InputError, match="is 1e\\+300 s"):
        rigor.run(ball, duration=1e300)
    with pytest.raises(rigor.InputError, match="index out of range"):
        rigor.geometry.mesh(np.eye(3), [[0, 1, 1.5]])


def test_one_file_is_enough(ball, tmp_path):
    rigor.run(ball, duration=0.02, files=tmp_path / "a.csv")
    rigor.run(ball, duration=0.02, files=str(tmp_path / "b.csv"))
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()
