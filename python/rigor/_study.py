"""Studies: thousands of runs for an answer."""

import json
import os

from ._rigor import StudyRecord


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
