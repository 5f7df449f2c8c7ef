"""Runs in memory."""

import os
import sys
import tempfile
import webbrowser
from collections.abc import Mapping

from . import _rigor
from ._scene import Scene
from ._simulation import Audit


def _place(places, name, what):
    """Where a name is; a KeyError with the names that there are."""
    if name in places:
        return places[name]
    names = list(places)
    known = ", ".join(names[:12]) + (", ..." if len(names) > 12 else "")
    raise KeyError(f"no {what} {name!r}; there are: {known}" if names else f"no {what} {name!r}; there is none")


class Columns(Mapping):
    """Arrays by the name of their body: slices of one array, no copies. `array` has all of them (T x n x k)."""

    def __init__(self, names, array):
        self._index = {name: i for i, name in enumerate(names)}
        self.array = array

    def __getitem__(self, name):
        return self.array[:, _place(self._index, name, "body")]

    def __iter__(self):
        return iter(self._index)

    def __len__(self):
        return len(self._index)


class Joints(Mapping):
    """Arrays by the name of their joint (T x its coordinates)."""

    def __init__(self, joints, array):
        self._range, begin = {}, 0
        for name, count in joints:
            self._range[name] = slice(begin, begin + count)
            begin += count
        self.array = array

    def __getitem__(self, name):
        return self.array[:, _place(self._range, name, "joint")]

    def __iter__(self):
        return iter(self._range)

    def __len__(self):
        return len(self._range)


class Run:
    """A run in memory: T output times."""

    def __init__(self, scene, record, how):
        self.scene, self._record, self._how = scene, record, how
        names = scene.bodies
        self.t = record.time
        """Output times (T) [s]."""
        self.position = Columns(names, record.position)
        """run.position["ball"]: origin of the body's frame (T x 3) [m]."""
        self.orientation = Columns(names, record.orientation)
        """Quaternions w, x, y, z (T x 4)."""
        self.velocity = Columns(names, record.velocity)
        """Of the centre of mass (T x 3) [m/s]."""
        self.angular_velocity = Columns(names, record.angular_velocity)
        """In the world (T x 3) [rad/s]."""
        self.joint_coordinate = Joints(scene._data.joints, record.joint_coordinate)
        """run.joint_coordinate["axle"] (T x its coordinates) [rad] or [m]."""
        self.joint_rate = Joints(scene._data.joints, record.joint_rate)
        """Their rates [rad/s] or [m/s]."""
        self.energy = {"kinetic": record.kinetic, "potential": record.potential, "elastic": record.elastic,
                       "total": record.kinetic + record.potential + record.elastic}
        """Energies (T) [J]."""
        self.penetration = record.penetration
        """Deepest overlap since the output before (T) [m]."""
        self.events = record.events
        """Impacts, rests, separations, slips that end, as a list of Event."""
        self.audit = Audit(record.audit_json(), record.violations())
        """How far the run can be trusted."""

    def save(self, path):
        """Writes the run to a .csv, .h5, .json, .html or .png file. The scene is run again: same bits."""
        _recorded(self.scene, dict(self._how, files=[os.fspath(path)], progress=None))

    def show(self):
        """Opens the replay in the browser; returns the path of its page."""
        path = os.path.join(tempfile.mkdtemp(prefix="rigor-"), "run.html")
        self.save(path)
        webbrowser.open("file://" + path)
        return path

    def frame(self):
        """A pandas DataFrame: a row for each output time."""
        import pandas

        columns = {"t": self.t}
        for name, table in (("position", self.position), ("velocity", self.velocity)):
            for body in table:
                for k, axis in enumerate("xyz"):
                    columns[f"{body}.{name}.{axis}"] = table[body][:, k]
        return pandas.DataFrame(columns)

    def plot(self, what="energy", axes=None):
        """Plots "energy", "penetration", or "ball.position" with matplotlib; returns the axes."""
        if axes is None:
            import matplotlib.pyplot

            axes = matplotlib.pyplot.gca()
        if what == "energy":
            for name, values in self.energy.items():
                axes.plot(self.t, values, label=name)
            axes.set_ylabel("energy [J]")
        elif what == "penetration":
            axes.plot(self.t, self.penetration, label=what)
            axes.set_ylabel("penetration [m]")
        else:
            body, _, quantity = what.rpartition(".")
            table = getattr(self, quantity, None) if isinstance(getattr(self, quantity, None), Columns) else None
            if table is None or body not in table:
                raise _rigor.InputError(f"there is no {what!r} to plot: 'energy', 'penetration', or 'BODY.position' "
                                        "(velocity, orientation, angular_velocity)")
            for k, values in enumerate(table[body].T):
                axes.plot(self.t, values, label=f"{what}.{k}")
        axes.set_xlabel("t [s]")
        axes.legend()
        return axes

    def __len__(self):
        return len(self.t)

    def __repr__(self):
        verdict = "trusted" if self.audit.ok else f"{len(self.audit.violations)} violations"
        return f"<rigor.Run of {self.scene.name!r}: {len(self)} outputs to t = {self.t[-1]:g} s, {verdict}>"


def _recorded(scene, how):
    return _rigor.record(scene._parsed, **how)


def run(scene, duration=None, *, output_interval=None, threads=1, separate=False, files=(), progress=False):
    """Runs a scene (or a file of one) and returns a Run.

    duration and output_interval [s]: those of the scene, unless given. files: one or several that are written on the
    way (.csv, .h5, .json, .html, .png). progress: True for a line on stderr, or a function of the time. Ctrl-C raises KeyboardInterrupt.
    """
    if not isinstance(scene, Scene):
        from ._scene import load

        scene = load(scene)
    files = [files] if isinstance(files, (str, os.PathLike)) else files
    how = {"duration": duration, "output_interval": output_interval, "threads": threads, "separate": separate,
           "files": [os.fspath(file) for file in files], "progress": None}
    line = progress is True
    if line:
        end = duration if duration is not None else scene._data.duration
        progress = lambda t: sys.stderr.write(f"\r{100 * t / end:5.1f} %")
    record = _recorded(scene, dict(how, progress=progress or None))
    if line:
        sys.stderr.write("\n")
    return Run(scene.copy(), record, how)
