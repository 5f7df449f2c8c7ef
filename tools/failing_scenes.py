"""Random scenes of kinds that users bring and that may fail: what `check_advice.py` tries the program's advice on.

Each kind draws its sizes, masses, speeds, steps and settings; not every scene of it fails.
"""
import math
import pathlib
import random

from measured_runs import numbers

FLOOR = "  - {name: floor, motion: static, shapes: [{type: plane}]}\n"
STEPS = [1 / 30, 1 / 60, 0.01, 0.005]
SUBSTEP = "scheme: time-stepping, solver: substep"


def scene(bodies, joints="", forces="", gravity=9.81, duration=1, step=0.01, restitution=0.0, friction=0.5, method="", interval=None):
    """A scene file of these bodies."""
    interval = interval or max(step, 0.01)
    text = f"rigor: 1\nworld: {{gravity: [0, 0, -{gravity}]}}\nrun: {{duration: {duration}, step: {step:.9g}, output_interval: {interval:.9g}}}\n"
    text += f"materials: [{{name: default, friction: {friction:.4g}, restitution: {restitution:.4g}}}]\n"
    text += f"method: {{{method}}}\nbodies:\n{bodies}"
    return text + (f"joints:\n{joints}" if joints else "") + (f"forces:\n{forces}" if forces else "")


def body(name, shape, position, velocity=(0, 0, 0), spin=(0, 0, 0), more=""):
    return (f"  - {{name: {name}, position: {numbers(position)}, velocity: {numbers(velocity)}, angular_velocity: {numbers(spin)}, "
            f"{more + ', ' if more else ''}shapes: [{{{shape}}}]}}\n")


def solid(draw, size):
    """A convex shape of about this size [m]."""
    a, b, c = (size * draw.uniform(0.4, 1.2) for _ in range(3))
    return draw.choice([f"type: box, size: {numbers([a, b, c])}", f"type: sphere, radius: {a / 2:.6g}", f"type: cylinder, radius: {a / 2:.6g}, length: {b:.6g}",
                        f"type: cone, radius: {a / 2:.6g}, length: {b:.6g}", f"type: capsule, radius: {a / 3:.6g}, length: {b:.6g}",
                        f"type: ellipsoid, radii: {numbers([a / 2, b / 2, c / 2])}"])


def power(draw, low, high):
    return 10 ** draw.uniform(low, high)


def spin(draw, most):
    return [draw.uniform(-most, most) for _ in range(3)]


def pendulums(draw, folder):
    """Arms on hinges by integrators of fixed order, in steps that are too long for them."""
    count, length = draw.randint(1, 3), draw.uniform(0.2, 1)
    bodies = joints = ""
    for k in range(count):
        bodies += body(f"arm{k}", f"type: box, size: {numbers([length, 0.1 * length, 0.1 * length])}", [(k + 0.5) * length, 0, 0])
        joints += f"  - {{name: pin{k}, type: hinge, bodies: [{f'arm{k - 1}' if k else 'world'}, arm{k}], anchor: {numbers([k * length, 0, 0])}, axis: [0, 1, 0]}}\n"
    integrator, longest = draw.choice([("euler", 0.05), ("midpoint", 0.05), ("rk4", 0.1), ("semi-implicit-euler", 0.05), ("lie-rk4", 0.1)])
    return scene(bodies, joints, duration=2, step=longest * draw.uniform(0.3, 1), method=f"integrator: {integrator}")


def tumblers(draw, folder):
    """Free bodies that spin, by integrators of fixed order."""
    text = body("it", f"type: box, size: {numbers([draw.uniform(0.1, 0.5) for _ in range(3)])}", [0, 0, 0], spin=spin(draw, 25))
    return scene(text, gravity=0, duration=2, step=draw.uniform(0.01, 0.05), method=f"integrator: {draw.choice(['euler', 'midpoint', 'rk4'])}")


def springs(draw, folder):
    """Balls on springs that are stiff for an explicit method, or for their step."""
    count = draw.randint(1, 3)
    bodies = forces = ""
    for k in range(count):
        bodies += body(f"ball{k}", "type: sphere, radius: 0.1", [k + 1, 0, 0], more=f"mass: {power(draw, -1, 1):.4g}")
        forces += (f"  - {{type: spring, between: [{f'ball{k - 1}' if k else 'world'}, ball{k}], points: [[0, 0, 0], [0, 0, 0]], "
                   f"stiffness: {power(draw, 2, 12):.4g}, damping: {draw.choice([0, power(draw, -1, 4)]):.4g}, length: 0.5}}\n")
    return scene(bodies, forces=forces, gravity=draw.choice([0, 9.81]), step=draw.choice(STEPS),
                 method=f"integrator: {draw.choice(['euler', 'midpoint', 'rk4', 'semi-implicit-euler'])}")


def rolling(draw, folder):
    """Bodies that land and roll by integrators of fixed order."""
    bodies = FLOOR + "".join(body(f"b{k}", solid(draw, 0.3), [0.6 * k, 0, 0.4], [2, 0, 0], spin(draw, 8)) for k in range(draw.randint(1, 3)))
    return scene(bodies, step=draw.choice(STEPS), restitution=draw.choice([0, 0.5]),
                 method=f"integrator: {draw.choice(['euler', 'midpoint', 'semi-implicit-euler'])}, scheme: {draw.choice(['event-driven', 'hybrid'])}")


def overlaps(draw, folder):
    """Bodies that are written into each other or into the floor."""
    size, depth = draw.uniform(0.1, 0.5), power(draw, -5, -0.5)
    bodies = FLOOR
    for k in range(draw.randint(1, 5)):
        bodies += body(f"box{k}", f"type: box, size: {numbers([size] * 3)}", [draw.uniform(-0.1, 0.1) * size, 0, (k + 0.5) * size * (1 - depth) - depth * size],
                       more=f"density: {power(draw, 2, 4):.4g}")
    method = draw.choice(["scheme: event-driven", "scheme: impulse-based", "scheme: penalty", "scheme: hybrid", "scheme: time-stepping", SUBSTEP, ""])
    return scene(bodies, step=draw.choice(STEPS), method=method)


def towers(draw, folder):
    """Heavy on light, struck from above or at rest, by solvers that do not go to the end."""
    size = draw.uniform(0.05, 0.4)
    masses = [power(draw, -1, 1) for _ in range(draw.randint(1, 8))] + [power(draw, 2, 10)]
    bodies = FLOOR
    for k, mass in enumerate(masses):
        top = k + 1 == len(masses)
        gap = draw.choice([0, 0.3]) if top else 0
        bodies += body(f"box{k}", f"type: box, size: {numbers([size] * 3)}", [0, 0, (k + 0.5) * size + gap], [0, 0, -3 if gap else 0], more=f"mass: {mass:.4g}")
    method = draw.choice(["scheme: impulse-based", "scheme: time-stepping, solver: pgs, iterations: 3", "scheme: time-stepping, solver: pgs", "scheme: penalty", SUBSTEP,
                          "scheme: penalty, penalty: global", "scheme: hybrid"])
    return scene(bodies, duration=0.5, step=draw.choice(STEPS), method=method)


def soft_contacts(draw, folder):
    """Contacts of given springs and dampers, too soft for what lands on them, or too stiff for the step."""
    bodies = FLOOR + "".join(body(f"b{k}", solid(draw, 0.2), [0.03 * k, 0, 0.3 + 0.3 * k], [0, 0, -2], more=f"mass: {power(draw, -1, 1):.4g}") for k in range(draw.randint(1, 3)))
    law = draw.choice([f"stiffness: {power(draw, 1, 8):.4g}, damping: {power(draw, 0, 4):.4g}", f"penalty_depth: {power(draw, -3, -1):.4g}", "penalty: global",
                       f"stiffness: {power(draw, 1, 8):.4g}, penalty: global, penalty_law: hunt-crossley"])
    return scene(bodies, step=draw.choice(STEPS), restitution=draw.choice([0, 0.5]), method=f"scheme: penalty, {law}")


def global_penalty(draw, folder):
    """Springs and joints beside penalty contacts that all take one step."""
    if draw.random() < 0.5:
        bodies = FLOOR + body("ball", "type: sphere, radius: 0.1", [1, 0, 0.5], more="mass: 1")
        return scene(bodies, forces=f"  - {{type: spring, between: [world, ball], points: [[0, 0, 0.5], [0, 0, 0]], stiffness: {power(draw, 1.5, 4):.4g}, length: 0.5}}\n",
                     step=draw.choice(STEPS), method="scheme: penalty, penalty: global")
    bodies, joints = chain(draw.randint(1, 5), 0.2, 0.02)
    return scene(bodies, joints, step=draw.choice(STEPS), method="scheme: penalty, penalty: global")


def chain(count, length, radius, direction=(1, 0, 0), top=(0, 0, 2), ends=1, first=0):
    """Links on balls, straight along `direction` from `top`, the first of them number `first`; the last one is held too if `ends` is 2."""
    bodies = joints = ""
    x, y, z = direction
    turn = f"axis_angle: {{axis: {numbers([-y, x, 0])}, angle: {math.acos(max(-1, min(1, z))):.12g}}}"
    for k in range(count):
        middle = [t + (k + 0.5) * length * d for t, d in zip(top, direction)]
        anchor = [t + k * length * d for t, d in zip(top, direction)]
        link, before = first + k, f"link{first + k - 1}" if first + k else "world"
        bodies += body(f"link{link}", f"type: capsule, radius: {radius:.6g}, length: {length - 2.5 * radius:.6g}", middle, more=turn)
        joints += f"  - {{name: pin{link}, type: ball, bodies: [{before}, link{link}], anchor: {numbers(anchor)}}}\n"
    if ends == 2:
        end = [t + count * length * d for t, d in zip(top, direction)]
        joints += f"  - {{name: end, type: ball, bodies: [link{first + count - 1}, world], anchor: {numbers(end)}}}\n"
    return bodies, joints


def taut_chains(draw, folder):
    """Chains pulled straight between two walls, which a body falls on: no force holds them so. The cure in words is some slack."""
    count, length = 2 * draw.randint(1, 4), draw.uniform(0.1, 0.3)
    mass, step = power(draw, -1, 2), draw.choice(STEPS)
    method = draw.choice(["", "scheme: event-driven", "scheme: time-stepping", SUBSTEP, "scheme: penalty"])

    def with_sag(sag):
        along, half = math.sqrt(1 - sag * sag), count // 2
        bodies, joints = chain(half, length, 0.1 * length, (along, 0, -sag))
        middle = (half * length * along, 0, 2 - half * length * sag)
        rest, links = chain(half, length, 0.1 * length, (along, 0, sag), middle, ends=2, first=half)
        weight = body("weight", "type: sphere, radius: 0.1", [middle[0], 0, middle[2] + 0.3], more=f"mass: {mass:.4g}")
        return scene(bodies + rest + weight, joints + links, step=step, method=method)

    return with_sag(0), {"a little slack": with_sag(0.2)}


def whips(draw, folder):
    """Chains that turn fast, in steps of about their own time: joints drift apart."""
    count, length = draw.randint(2, 10), draw.uniform(0.05, 0.2)
    bodies, joints = chain(count, length, 0.1 * length)
    bodies = bodies.replace("velocity: [0, 0, 0]", f"velocity: [0, {draw.uniform(5, 40):.4g}, 0]", draw.randint(1, count))
    method = draw.choice(["scheme: time-stepping", SUBSTEP, "scheme: penalty, penalty: global", "integrator: euler"])
    return scene(bodies, joints, step=draw.choice(STEPS), method=method)


def motors(draw, folder):
    """Motors without a bound against limits, and in four-bar linkages that do not turn all round. The cure in words is a bound."""
    speed, mass, step = power(draw, 0, 6), power(draw, -2, 2), draw.choice(STEPS)
    limits = f", limits: [-{power(draw, -2, 0):.4g}, {power(draw, -2, 0):.4g}]" if draw.random() < 0.6 else ""
    is_linkage, friction, bound = draw.random() < 0.5, draw.choice([0, 5]), power(draw, 0, 2)
    method = draw.choice(["", "scheme: time-stepping", SUBSTEP, "scheme: event-driven", "scheme: penalty"])

    def with_bound(words):
        bodies = body("arm", "type: box, size: [0.5, 0.05, 0.05]", [0.25, 0, 1], more=f"mass: {mass:.4g}")
        joints = (f"  - {{name: drive, type: hinge, bodies: [world, arm], anchor: [0, 0, 1], axis: [0, 1, 0]{limits}, "
                  f"motor: {{velocity: {speed:.4g}{words}}}}}\n")
        if is_linkage:
            bodies += body("coupler", "type: box, size: [0.05, 0.05, 0.4]", [0.5, 0, 0.8]) + body("rocker", "type: box, size: [0.3, 0.05, 0.05]", [0.35, 0, 0.6])
            joints += "  - {name: pin, type: hinge, bodies: [arm, coupler], anchor: [0.5, 0, 1], axis: [0, 1, 0]}\n"
            joints += "  - {name: knee, type: ball, bodies: [coupler, rocker], anchor: [0.5, 0, 0.6]}\n"
            joints += f"  - {{name: hold, type: hinge, bodies: [world, rocker], anchor: [0.2, 0, 0.6], axis: [0, 1, 0], friction: {friction}}}\n"
        return scene(bodies, joints, step=step, method=method)

    return with_bound(""), {"a max_force": with_bound(f", max_force: {bound:.4g}")}


def thin_bodies(draw, folder):
    """Thin bodies that are thrown fast, and blades that strike."""
    thin = power(draw, -3, -2)
    bodies = body("plate", f"type: box, size: [1, 1, {thin:.4g}]", [0, 0, 0], more="motion: static")
    kind = draw.choice(["shot", "blade"])
    for k in range(draw.randint(1, 4)):
        at = [draw.uniform(-0.3, 0.3), draw.uniform(-0.3, 0.3), 0.2 + 0.2 * k]
        if kind == "shot":
            bodies += body(f"shot{k}", solid(draw, power(draw, -2, -1)), at, [0, 0, -power(draw, 1.5, 3.3)], spin(draw, 300))
        else:
            bodies += body(f"shot{k}", solid(draw, 0.1), at)
    if kind == "blade":
        bodies += body("blade", f"type: box, size: [1, 0.1, {thin:.4g}]", [0, 0.5, 0.15], spin=[0, 0, power(draw, 1, 3)], more="motion: kinematic")
    return scene(bodies, step=draw.choice(STEPS), duration=0.3, restitution=draw.choice([0, 0.5]), method=draw.choice([SUBSTEP, SUBSTEP, "scheme: time-stepping", "scheme: penalty"]))


def heaps(draw, folder):
    """Heaps and columns under strong gravity in long steps."""
    count, size = draw.randint(4, 16), draw.uniform(0.02, 0.5)
    bodies = FLOOR
    for k in range(count):
        at = [draw.uniform(-1, 1) * size, draw.uniform(-1, 1) * size, (1 + 1.3 * k) * size]
        bodies += body(f"b{k}", solid(draw, size), at, [0, 0, -draw.uniform(0, 5)], spin(draw, 5), f"density: {power(draw, 2, 5):.4g}")
    method = draw.choice([SUBSTEP, SUBSTEP, "scheme: time-stepping, solver: pgs, iterations: 5", "scheme: impulse-based", "scheme: penalty"])
    return scene(bodies, step=draw.choice(STEPS[:2]), gravity=draw.choice([9.81, 30, 100]), restitution=draw.choice([0, 0.5, 0.9]), method=method)


def open_meshes(draw, folder):
    """Bodies on sheets that are not closed, with creases and holes."""
    cells, size, height = draw.randint(2, 6), 2.0, draw.uniform(0, 0.5)
    name = f"sheet{draw.randint(0, 10 ** 9)}.obj"
    lines = [f"v {size * (i / cells - 0.5):.9g} {size * (j / cells - 0.5):.9g} {height * draw.random():.9g}" for j in range(cells + 1) for i in range(cells + 1)]
    for j in range(cells):
        for i in range(cells):
            a = j * (cells + 1) + i + 1
            if draw.random() < 0.9:
                lines += [f"f {a} {a + 1} {a + cells + 2}", f"f {a} {a + cells + 2} {a + cells + 1}"]
    (pathlib.Path(folder) / name).write_text("\n".join(lines) + "\n")
    bodies = body("sheet", f"type: mesh, file: {name}", [0, 0, 0], more="motion: static")
    bodies += "".join(body(f"b{k}", solid(draw, 0.3), [draw.uniform(-0.7, 0.7), draw.uniform(-0.7, 0.7), 0.8 + 0.4 * k], [0, 0, -draw.uniform(0, 20)], spin(draw, 5))
                      for k in range(draw.randint(1, 4)))
    return scene(bodies, step=draw.choice(STEPS), method=draw.choice(["", "scheme: time-stepping", SUBSTEP, "scheme: event-driven", "scheme: penalty"]))


def huge_numbers(draw, folder):
    """Wrong units: forces, torques and stiff joints that no step of the scene follows."""
    bodies = body("a", solid(draw, 0.2), [0, 0, 2], more=f"mass: {power(draw, -4, 1):.4g}") + body("b", solid(draw, 0.2), [0.5, 0, 2])
    joints = (f"  - {{name: link, type: distance, bodies: [a, b], anchors: [[0, 0, 2], [0.5, 0, 2]], limits: [0.4, 0.6], "
              f"stiffness: {power(draw, 3, 12):.4g}, damping: {draw.choice([0, power(draw, 0, 9)]):.4g}}}\n")
    forces = draw.choice(["", f"  - {{type: constant, body: b, force: [{power(draw, 3, 15):.4g}, 0, 0], point: [0, 0, 0.05]}}\n",
                          f"  - {{type: torque, body: b, torque: [0, {power(draw, 3, 15):.4g}, 0]}}\n"])
    method = draw.choice(["", "scheme: time-stepping", SUBSTEP, "scheme: event-driven", "integrator: rk4", "scheme: hybrid"])
    return scene(bodies, joints, forces, step=draw.choice(STEPS), method=method)


def coarse_settings(draw, folder):
    """Tolerances of the method that are wrong for the scene."""
    bodies = FLOOR + "".join(body(f"b{k}", solid(draw, 0.2), [0.4 * k, 0, 0.3], [1, 0, 0], spin(draw, 9)) for k in range(draw.randint(1, 4)))
    setting = draw.choice([f"integrator: dopri5, tolerance: {power(draw, -3, -1):.4g}", f"contact_tolerance: {power(draw, -2, 0):.4g}",
                           f"time_tolerance: {power(draw, -4, -1):.4g}", f"resting_velocity: {power(draw, 0, 2):.4g}", f"substeps: 1, {SUBSTEP}"])
    scheme = "" if "scheme" in setting else f", scheme: {draw.choice(['event-driven', 'hybrid', 'impulse-based', 'time-stepping'])}"
    return scene(bodies, step=draw.choice(STEPS), restitution=draw.choice([0, 0.5, 1]), method=setting + scheme)


def squeezed(draw, folder):
    """Bodies under a press that comes down nearly to them and stays; what rebounds without loss rebounds between them."""
    size = 0.2
    low = draw.uniform(1.02, 1.5) * size
    bodies = FLOOR + body("press", "type: box, size: [2, 2, 0.2]", [0, 0, 0], more=(
        f"motion: kinematic, path: [{{time: 0, position: [0, 0, 0.8]}}, {{time: {draw.uniform(0.2, 0.8):.4g}, position: [0, 0, {low + 0.1:.9g}]}}]"))
    bodies = bodies.replace("position: [0, 0, 0], velocity: [0, 0, 0], angular_velocity: [0, 0, 0], motion: kinematic", "motion: kinematic")
    bodies += "".join(body(f"b{k}", f"type: sphere, radius: {size / 2}", [0.25 * k - 0.3, 0, 0.3], more=f"density: {power(draw, 2, 4):.4g}") for k in range(draw.randint(1, 4)))
    return scene(bodies, step=draw.choice(STEPS), restitution=draw.choice([0, 0.8, 1]),
                 method=draw.choice(["", "scheme: event-driven", "scheme: hybrid", "scheme: impulse-based", "scheme: time-stepping", SUBSTEP, "scheme: penalty"]))


KINDS = [pendulums, tumblers, springs, rolling, overlaps, towers, soft_contacts, global_penalty, taut_chains, whips, motors, thin_bodies, heaps, open_meshes,
         huge_numbers, coarse_settings, squeezed]


def draw_scene(kind, seed, folder):
    """The seed's scene of a kind, and for what the program advises in words the scene that obeys; meshes are written into the folder."""
    drawn = kind(random.Random(f"{kind.__name__} {seed}"), folder)
    return drawn if isinstance(drawn, tuple) else (drawn, {})
