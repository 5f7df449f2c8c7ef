"""Studies: thousands of runs for an answer."""

import json
import os

from ._rigor import StudyRecord, student_quantile


def _axes(axes):
    if axes is None:
        import matplotlib.pyplot

        axes = matplotlib.pyplot.gca()
    return axes


class Study:
    """A study that was carried out: one row a run, and what the rows say."""

    def __init__(self, record):
        self._record = record
        self.name = record.name
        self.parameters = record.parameters
        """study.parameters["mu"]: what each run was given (one number a run)."""
        self.outcomes = record.outcomes
        """study.outcomes["distance"]: what each run gave; NaN if it did not end well."""
        self.status = record.statuses
        """"done", "violated", "stopped", "refused" or "out of time", one a run."""
        self.reason = record.reasons
        """Of runs that are not done: why."""
        self.answer = json.loads(record.answer)
        """The answer as --json of the program writes it: findings with their intervals, tables."""
        self.unmet = record.unmet
        """Expectations of the study file that the findings do not meet: one message each."""

    def __len__(self):
        return len(self.status)

    def __repr__(self):
        return f"<rigor.Study {self.name!r}: {len(self)} runs>"

    def finding(self, name):
        """A number that the study found, by its name: a dictionary with value, low and high."""
        for finding in self.answer["findings"]:
            if finding["name"] == name:
                return finding
        known = ", ".join(finding["name"] for finding in self.answer["findings"])
        raise KeyError(f"no finding {name!r}; there are: {known}")

    def frame(self):
        """The rows as a frame of pandas: parameters, outcomes, status."""
        import pandas

        return pandas.DataFrame({**self.parameters, **self.outcomes, "status": self.status})

    def column(self, name):
        """The numbers of a parameter or an outcome, one a run; NaN where the run did not end."""
        for table in (self.parameters, self.outcomes):
            if name in table:
                return table[name]
        raise KeyError(f"no parameter or outcome {name!r}; there are: {', '.join([*self.parameters, *self.outcomes])}")

    def plot(self, what, over=None, axes=None):
        """Plots a column with matplotlib; returns the axes.

        what: a parameter or an outcome. over: another one; where several runs share each of its values the means with
        their intervals of Student, else a dot a run. Without it, a histogram. Runs without a finite number are left out.
        """
        import numpy

        axes = _axes(axes)
        values = numpy.asarray(self.column(what))
        if over is None:
            axes.hist(values[numpy.isfinite(values)], bins="auto")
            axes.set_xlabel(what)
            axes.set_ylabel("runs")
            return axes
        at = numpy.asarray(self.column(over))
        known = numpy.isfinite(values) & numpy.isfinite(at)
        values, at = values[known], at[known]
        places, group, count = numpy.unique(at, return_inverse=True, return_counts=True)
        if len(places) > 0 and count.min() > 1:
            mean = numpy.bincount(group, values) / count
            spread = numpy.sqrt(numpy.bincount(group, (values - mean[group]) ** 2) / (count - 1) / count)
            factor = [student_quantile(0.5 + 0.5 * self.answer["confidence"], int(n) - 1) for n in count]
            axes.errorbar(places, mean, factor * spread, fmt="o", capsize=3)
        else:
            axes.plot(at, values, ".")
        axes.set_xlabel(over)
        axes.set_ylabel(what)
        return axes

    def plot_parallel(self, by=None, axes=None, most=500):
        """Parallel coordinates of all columns that vary: a line a run, in the colour of the column `by` (the last one).

        most: how many runs, evenly. Returns the axes.
        """
        import matplotlib
        import numpy

        axes = _axes(axes)
        names, shares = [], []
        for name in [*self.parameters, *self.outcomes]:
            values = numpy.array(self.column(name), dtype=float)[:: len(self) // most + 1]
            values[~numpy.isfinite(values)] = numpy.nan
            known = values[~numpy.isnan(values)]
            if len(known) > 0 and known.min() < known.max():
                names.append(name)
                shares.append((values - known.min()) / (known.max() - known.min()))
        if not names:
            raise ValueError("no column of the study varies")
        if by is not None and by not in names:
            raise KeyError(f"no column {by!r} that varies; there are: {', '.join(names)}")
        colors = matplotlib.colormaps["cividis"](numpy.nan_to_num(shares[names.index(by) if by else -1], nan=0.5))
        for run, color in enumerate(colors):
            axes.plot(range(len(names)), [share[run] for share in shares], color=color, linewidth=0.6)
        axes.set_xticks(range(len(names)), names)
        axes.set_ylabel("from the least to the greatest")
        return axes

    def save(self, path):
        """Writes .csv, .json, .h5, .html, .svg or .png."""
        self._record.save(os.fspath(path))


def study(file, threads=None, journal=None):
    """Carries out the study of a file (docs/studies.md).

    file: of the study. threads: how many runs at a time; None: as many as there are processors. The answer does
    not depend on it. journal: a file that keeps the runs; the same call goes on from it.

    Raises InputError for a study or a first run that cannot be, OSError, and KeyboardInterrupt on Ctrl-C.
    """
    kept = "" if journal is None else os.fspath(journal)
    return Study(StudyRecord(os.fspath(file), threads or os.cpu_count() or 1, kept))
