import copy
import pathlib
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import rigor

G = 9.80665


def test_a_run_is_arrays_without_copies(ball):
    run = rigor.run(ball, duration=0.4)
    assert run.t.shape == (41,) and run.position["ball"].shape == (41, 3)
    assert np.allclose(run.position["ball"][:, 2], 1 - G * run.t**2 / 2, atol=1e-12)
    assert np.shares_memory(run.position["ball"], run.position.array)
    assert not run.position["ball"].flags.writeable
    assert np.allclose(run.energy["total"], G * 1.0, atol=1e-12)
    assert run.audit.ok and run.audit["complete"] is True
    assert "41 outputs" in repr(run)
    # The arrays live on without the run.
    place = run.position["ball"]
    del run
    assert place[0, 2] == 1


def test_a_run_knows_its_events(ball):
    run = rigor.run(ball)
    assert run.events[0].kind == "impact"
    assert abs(run.events[0].time - np.sqrt(1.8 / G)) < 1e-10
    assert run.audit["events"]["impacts"] == len([e for e in run.events if e.kind == "impact"])


def test_every_shipped_format_is_written(ball, tmp_path):
    run = rigor.run(ball, duration=0.1, files=[tmp_path / "a.csv"])
    run.save(tmp_path / "b.csv")
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()
    for suffix in ("h5", "json", "html", "png"):
        run.save(tmp_path / f"run.{suffix}")
        assert (tmp_path / f"run.{suffix}").stat().st_size > 100
    with pytest.raises(rigor.InputError, match="available"):
        run.save(tmp_path / "run.urdf")


def test_scenes_of_files_and_overrides(scenes):
    scene = rigor.load(scenes / "pendulum.yaml", **{"run.step": 0.005})
    assert scene.bodies and scene.joints
    assert scene._data.step == 0.005
    scene.set("run.duration", 0.5)
    assert rigor.run(scene).t[-1] == pytest.approx(0.5)
    assert rigor.run(scenes / "pendulum.yaml", duration=0.1).audit.ok


def test_mistakes_are_those_of_scene_files(ball):
    with pytest.raises(rigor.InputError) as wrong:
        rigor.Scene(bodies=[{"name": "a", "masss": 1, "shapes": [{"type": "sphere", "radius": -1}]}])
    assert len(wrong.value.messages) == 2
    assert "did you mean 'mass'" in wrong.value.messages[0]
    assert isinstance(wrong.value, ValueError)
    with pytest.raises(rigor.InputError, match="restitution"):
        ball.set("materials.rubber.restitution", 2)
    assert rigor.run(ball, duration=0.01).audit.ok
    with pytest.raises(FileNotFoundError):
        rigor.load("no_such_file.yaml")
    with pytest.raises(rigor.InputError, match="must be finite|nan"):
        rigor.Scene(bodies=[{"name": "a", "position": [np.nan, 0, 0], "shapes": [{"type": "sphere", "radius": 1}]}])


def test_numpy_goes_into_scenes():
    scene = rigor.Scene(bodies=[{"name": "a", "position": np.array([1.0, 2.0, 3.0]), "mass": np.float64(2),
                                 "shapes": [{"type": "box", "size": np.ones(3)}]}])
    assert scene.masses[0] == 2
    assert np.array_equal(rigor.Simulation(scene).position("a"), [1, 2, 3])


def test_a_simulation_steps(ball):
    sim = rigor.Simulation(ball)
    for _ in range(40):
        sim.step()
    assert sim.time == pytest.approx(0.4, abs=1e-15)
    k = sim.body("ball")
    assert sim.positions.shape == (2, 3)
    assert sim.positions[k, 2] == sim.position("ball")[2] == pytest.approx(1 - G * 0.08, abs=1e-12)
    assert sim.velocities[k, 2] == pytest.approx(-G * 0.4)
    # The same bits as a run.
    assert np.array_equal(sim.positions[k], rigor.run(ball, duration=0.4).position["ball"][-1])
    with pytest.raises(ValueError):
        sim.positions[0, 0] = 1
    with pytest.raises(rigor.InputError, match="did you mean 'ball'"):
        sim.position("bal")
    with pytest.raises(rigor.InputError, match="from 0 to 1"):
        sim.position(17)
    with pytest.raises(TypeError):
        sim.position(1.5)


@pytest.mark.parametrize("method", [{"scheme": "event-driven"}, {"scheme": "time-stepping"},
                                    {"scheme": "time-stepping", "solver": "substep"}, {"scheme": "penalty"},
                                    {"scheme": "impulse-based"}, {"scheme": "hybrid"}, {"scheme": "auto"}])
def test_efforts_and_forces_in_every_scheme(wheel, method):
    wheel.set("method", method)
    sim = rigor.Simulation(wheel)
    sim.set_motor_effort("axle", 0.18)
    sim.advance_to(0.5)
    assert sim.joint_motion("axle").rates[0] == pytest.approx(1.0, abs=2e-5)
    assert sim.joint_forces("axle").efforts[0] == pytest.approx(0.18)
    assert sim.audit().ok
    assert sim.audit()["energy"]["work"] == pytest.approx(0.045, abs=2e-3)


def test_a_controller_is_a_function(wheel):
    sim = rigor.Simulation(wheel)
    times = []

    def control(own):
        assert own is sim
        times.append(own.time)
        own.set_motor_effort("axle", -0.9 * own.joint_motion("axle").rates[0])

    sim.set_motor_velocity("axle", 3)
    sim.advance_to(0.1)
    sim.release_motor("axle")
    sim.set_controller(control, 0.05)
    sim.advance_to(0.35)
    assert times == pytest.approx([0.1, 0.15, 0.2, 0.25, 0.3])
    # Held over each period: ω falls by the factor 1 - 0.9 · 0.05 / 0.09.
    assert sim.joint_motion("axle").rates[0] == pytest.approx(3 * 0.5**5, rel=1e-6)

    def broken(own):
        raise RuntimeError("of the controller")

    sim.set_controller(broken)
    with pytest.raises(RuntimeError, match="of the controller"):
        sim.step()
    sim.set_controller(None)
    sim.step()


def test_copies_pickles_and_bytes_continue_with_the_same_bits(ball):
    sim = rigor.Simulation(ball)
    sim.set_velocity("ball", [1, 2, 3], [4, 5, 6])
    sim.advance_to(0.3)
    others = [sim.copy(), copy.deepcopy(sim), pickle.loads(pickle.dumps(sim)), rigor.Simulation(ball)]
    others[-1].restore(sim.save())
    sim.advance_to(0.9)
    for other in others:
        other.advance_to(0.9)
        assert np.array_equal(other.positions, sim.positions)
        assert np.array_equal(other.velocities, sim.velocities)
    with pytest.raises(rigor.InputError, match="saved simulation"):
        sim.restore(b"nonsense")


def test_questions(ball):
    sim = rigor.Simulation(ball)
    hit = sim.ray([0, 0, 3], [0, 0, -2])
    assert hit.body == 1 and hit.fraction == pytest.approx(0.95) and np.allclose(hit.normal, [0, 0, 1])
    assert sim.ray([5, 5, 3], [0, 0, 1]) is None
    assert sim.nearest([0, 0, 2], 2)[0] == (1, pytest.approx(0.9))
    ball.set("bodies.ball.position", [0, 0, 0.1])
    rest = rigor.Simulation(ball)
    rest.advance_to(0.1)
    contact, = rest.contacts()
    assert contact.force[2] == pytest.approx(G) and contact.mode == "stick"
    assert rest.take_events() == []
    assert sim.audit().violations == []
    with pytest.raises(rigor.InputError):
        sim.ray([0, 0, np.nan], [0, 0, 1])


def test_geometry():
    g = rigor.geometry
    box, sphere = g.box([1, 1, 1]), g.sphere(0.25)
    apart = g.distance(box, sphere, pose_b=[0, 0, 2])
    assert float(apart) == pytest.approx(1.25) and apart.lower <= apart.distance <= apart.upper
    assert np.allclose(apart.normal, [0, 0, 1])
    mass = g.mass(box, 1000)
    assert mass["mass"] == pytest.approx(1000) and np.allclose(mass["inertia"], np.eye(3) * 1000 / 6)
    assert g.time_of_contact(box, sphere, pose_b=[0, 0, 2], velocity_b=[0, 0, -1], t_end=5) == pytest.approx(1.25)
    assert g.time_of_contact(box, sphere, pose_b=[0, 0, 2], velocity_b=[0, 0, 1], t_end=5) is None
    assert len(g.contacts(box, g.plane([0, 0, 1]), pose_a=[0, 0, 0.5])) == 4
    assert [f for f, _ in g.ray(box, [0, 0, 2], [0, 0, -1])] == pytest.approx([1.5, 2.5])
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    assert g.mass(g.convex(corners))["center"] == pytest.approx([0.5, 0.5, 0.5])
    tetrahedron = g.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    assert g.mass(tetrahedron, 6)["mass"] == pytest.approx(1)
    turned = np.eye(4)
    turned[:3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    assert float(g.distance(box, sphere, turned, [2, 0, 0, 1, 0, 0, 0])) == pytest.approx(1.25)
    for wrong in (lambda: g.sphere(-1), lambda: g.mass(g.plane([0, 0, 1])), lambda: g.plane([0, 0, 0]),
                  lambda: g.distance(g.plane([0, 0, 1]), g.plane([0, 0, 1])), lambda: g.convex(corners[:3]),
                  lambda: g.mesh(corners, [[0, 1, 99]]), lambda: g.distance(box, sphere, pose_b=[1, 2])):
        with pytest.raises(rigor.InputError):
            wrong()


def test_shapes_are_pushed_through_a_simulation(ball):
    sim = rigor.Simulation(ball)
    height = sim.position("ball")[2]
    probe = rigor.geometry.sphere(0.05)
    # From 3 m above straight down: it meets the ball of 0.1 m when the centres are 0.15 m apart.
    hit = sim.cast(probe, [0, 0, height + 3], [0, 0, -4])
    assert sim.body_names[hit.body] == "ball"
    assert hit.fraction == pytest.approx((3 - 0.15) / 4, abs=1e-9)
    assert hit.normal == pytest.approx([0, 0, -1]) and hit.point[2] == pytest.approx(height + 0.1)
    assert sim.cast(probe, [5, 0, height + 3], [0, 0, -1]) is None
    assert sim.overlapping(probe, [0, 0, height + 0.12]) == [sim.body("ball")]
    assert sim.overlapping(probe, [0, 0, height + 0.2]) == []


def test_a_batch_has_the_same_bits_on_any_number_of_threads(wheel):
    states = []
    for threads in (1, 3):
        batch = rigor.Batch(wheel, 6, threads)
        for _ in range(5):
            batch.set_motor_efforts("axle", 0.1 * np.arange(6))
            batch.step()
        states.append(batch.states.copy())
    assert states[0].shape == (6, 1, 13)
    assert np.array_equal(*states)
    assert np.allclose(batch.joint_rates("axle"), 0.1 * np.arange(6) * 0.05 / 0.09)
    assert batch.world(3).joint_motion("axle").rates[0] == batch.joint_rates("axle")[3]
    batch.reset(3)
    assert batch.joint_rates("axle")[3] == 0 and batch.stops == [""] * 6
    with pytest.raises(rigor.InputError, match="shape"):
        batch.set_motor_efforts("axle", np.zeros(5))
    with pytest.raises(rigor.InputError):
        batch.world(6)


def test_the_lock_of_the_interpreter_is_free_while_a_simulation_runs(ball):
    ball.set("run.duration", 1000)
    counts = []

    def count():
        while not counts or counts[-1] >= 0:
            counts.append(len(counts))
            time.sleep(0.001)

    done = []
    worker = threading.Thread(target=lambda: done.append(rigor.run(ball, duration=30)))
    worker.start()
    beats = 0
    while worker.is_alive():
        time.sleep(0.001)
        beats += 1
    assert done[0].audit["complete"] and beats >= 1


def test_control_c_ends_a_run():
    program = """
import rigor
scene = rigor.Scene(run={"duration": 1e5, "output_interval": 0.001}, world={"gravity": [0, 0, 0]},
                    bodies=[{"name": "top", "angular_velocity": [1, 2, 3], "inertia": {"mass": 1, "moments": [1, 2, 2.5]}}],
                    forces=[{"type": "torque", "body": "top", "torque": [0, 0, 1e-9]}])
print("started", flush=True)
try:
    rigor.run(scene)
except KeyboardInterrupt:
    print("interrupted")
"""
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "started\n"
    time.sleep(0.3)
    child.send_signal(signal.SIGINT)
    out, _ = child.communicate(timeout=30)
    assert out == "interrupted\n"


def test_a_study_gives_arrays(scenes, tmp_path):
    study = rigor.study(scenes / "studies" / "slide_distance.yaml", threads=2, journal=tmp_path / "slide.journal")
    mu, v = study.parameters["mu"], study.parameters["v"]
    assert len(study) == 72 and set(study.status) == {"done"} and study.unmet == []
    assert np.allclose(study.outcomes["distance"], v**2 / (2 * mu * 9.81), rtol=0, atol=1e-9)
    study.save(tmp_path / "slide.csv")
    assert len((tmp_path / "slide.csv").read_text().splitlines()) == 73
    again = rigor.study(scenes / "studies" / "slide_distance.yaml", threads=1, journal=tmp_path / "slide.journal")
    assert np.array_equal(again.outcomes["distance"], study.outcomes["distance"])
    with pytest.raises(rigor.InputError, match="available"):
        study.save(tmp_path / "slide.urdf")
    with pytest.raises(KeyError, match="there are: mu, v"):
        study.column("nu")
    with pytest.raises(KeyError, match="there are"):
        study.finding("nothing of the kind")
    (tmp_path / "wrong.yaml").write_text("rigor_study: 1\nkind: guess\n")
    with pytest.raises(rigor.InputError, match="wrong.yaml:2"):
        rigor.study(tmp_path / "wrong.yaml")


def test_a_study_is_plotted(scenes):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    study = rigor.study(scenes / "studies" / "slide_distance.yaml", threads=2)
    axes = study.plot("distance", axes=plt.figure().gca())
    assert sum(bar.get_height() for bar in axes.patches) == len(study)
    # Each of the values of mu has several runs: their mean and Student's interval.
    axes = study.plot("distance", over="mu", axes=plt.figure().gca())
    line = axes.containers[0].lines[0]
    mu, distance = study.parameters["mu"], study.outcomes["distance"]
    assert np.array_equal(line.get_xdata(), np.unique(mu))
    assert np.allclose(line.get_ydata(), [distance[mu == x].mean() for x in np.unique(mu)], rtol=1e-12)
    ends = axes.containers[0].lines[2][0].get_segments()[0][:, 1]
    first = distance[mu == np.unique(mu)[0]]
    half = rigor._rigor.student_quantile(0.975, len(first) - 1) * first.std(ddof=1) / np.sqrt(len(first))
    assert np.allclose(ends, [first.mean() - half, first.mean() + half], rtol=1e-9)
    axes = study.plot_parallel(by="distance", axes=plt.figure().gca())
    assert len(axes.lines) == len(study)
    assert "distance" in [label.get_text() for label in axes.get_xticklabels()]
    with pytest.raises(KeyError, match="that varies"):
        study.plot_parallel(by="nothing")


def test_the_stubs_name_what_is_there():
    stub = (pathlib.Path(rigor.__file__).parent / "_rigor.pyi").read_text()
    import re

    import rigor._rigor as module
    for name, body in re.findall(r"^class (\w+)[^\n]*:\n((?:    .*\n|\n)*)", stub, re.M):
        own = getattr(module, name)
        if issubclass(own, Exception):
            continue
        stubbed = set(re.findall(r"^    def (\w+)|^    (\w+):", body, re.M))
        stubbed = {a or b for a, b in stubbed if not (a or b).startswith("_")}
        real = {n for n in vars(own) if not n.startswith("_")}
        assert stubbed == real, f"{name}: {stubbed ^ real}"
        assert name in ("SceneData", "TextScene", "Record", "StudyRecord") or all(getattr(own, n).__doc__ for n in real), name
    stub = (pathlib.Path(rigor.__file__).parent / "geometry.pyi").read_text()
    assert set(re.findall(r"^(?:class|def) (\w+)", stub, re.M)) == set(rigor.geometry.__all__)


def test_a_wheel_is_installed_without_a_network(tmp_path):
    package = pathlib.Path(rigor.__file__).parent
    maker = pathlib.Path(__file__).parents[2] / "python" / "make_wheel.py"
    made = subprocess.run([sys.executable, maker, package, tmp_path, rigor.__version__], check=True,
                          capture_output=True, text=True)
    wheel = pathlib.Path(made.stdout.strip())
    installed = subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps",
                                "--target", tmp_path / "site", wheel], capture_output=True, text=True)
    if "No module named pip" in installed.stderr:
        import zipfile

        zipfile.ZipFile(wheel).extractall(tmp_path / "site")
    else:
        assert installed.returncode == 0, installed.stderr
    program = "import rigor; print(rigor.__file__, rigor.geometry.mass(rigor.geometry.sphere(1), 1)['mass'])"
    ran = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, check=True, capture_output=True, text=True,
                         env={"PYTHONPATH": str(tmp_path / "site"), "PATH": "/usr/bin"})
    place, mass = ran.stdout.split()
    assert place.startswith(str(tmp_path)) and float(mass) == pytest.approx(4 * np.pi / 3)


def test_the_examples_run():
    folder = pathlib.Path(__file__).parents[2] / "examples" / "python"
    for example in sorted(folder.glob("*.py")):
        subprocess.run([sys.executable, example], check=True, capture_output=True)


def cart_poles(count, threads=1):
    import importlib.util

    path = pathlib.Path(__file__).parents[2] / "examples" / "python" / "cart_pole.py"
    spec = importlib.util.spec_from_file_location("cart_pole", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.CartPoles(count, threads=threads)


def test_a_vector_environment_begins_anew_where_a_world_has_ended():
    one, two = cart_poles(6), cart_poles(6, threads=2)
    observation, info = one.reset(seed=3)
    assert info == {} and one.observation_space.contains(observation)
    assert np.array_equal(two.reset(seed=3)[0], observation)
    ends = 0
    for k in range(160):
        # The first carts are pushed until their poles have fallen.
        force = np.where(np.arange(6) < 3, 15.0, 0.0)[:, np.newaxis]
        observation, reward, terminated, truncated, info = one.step(force)
        assert all(np.array_equal(a, b) for a, b in zip(two.step(force)[:4], (observation, reward, terminated, truncated)))
        assert one.observation_space.contains(observation) and reward.shape == terminated.shape == (6,)
        for world in np.flatnonzero(terminated):
            ends += 1
            assert abs(info["final_obs"][world, 2]) > one.widest and info["_final_obs"][world]
            assert abs(observation[world, 2]) < 1e-9, "a world that has ended is at its beginning"
    assert ends >= 3
    with pytest.raises(ValueError, match="shape"):
        one.step(np.zeros((5, 1)))


def test_gymnasium_takes_the_environment_for_one_of_its_own():
    gymnasium = pytest.importorskip("gymnasium")
    from gymnasium.wrappers.vector import ClipAction, RecordEpisodeStatistics

    carts = cart_poles(4)
    assert isinstance(carts, gymnasium.vector.VectorEnv)
    assert isinstance(carts.single_action_space, gymnasium.spaces.Box)
    wrapped = RecordEpisodeStatistics(ClipAction(carts))
    wrapped.reset(seed=1)
    wrapped.action_space.seed(1)
    episodes = []
    for _ in range(300):
        *_, info = wrapped.step(wrapped.action_space.sample())
        episodes += [info["episode"]["l"][k] for k in np.flatnonzero(info.get("_episode", []))]
    assert len(episodes) >= 4 and min(episodes) > 1


def test_the_page_of_the_documentation(tmp_path, monkeypatch, scenes):
    """Runs each block of Python of docs/python.md, one after another."""
    import re

    text = (scenes.parent / "docs" / "python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
    assert len(blocks) >= 5
    (tmp_path / "scenes").symlink_to(scenes)
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
