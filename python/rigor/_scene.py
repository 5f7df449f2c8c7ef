"""Scenes: from a file, from text, or built with the keys of scene files."""

import json
import os

from . import _rigor


def _plain(value):
    """Numbers and arrays of numpy as JSON has them."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a scene has no place for a {type(value).__name__}")


def _text(value):
    # Not finite numbers are as YAML writes them, so that the scene's own checks speak of them.
    text = json.dumps(value, default=_plain, ensure_ascii=False)
    return text.replace("-Infinity", "-.inf").replace("Infinity", ".inf").replace("NaN", ".nan")


class Scene:
    """A checked scene.

    Scene(bodies=[...], joints=[...], run={...}, ...) takes the keys of scene files (docs/scene.md), with numpy arrays
    where lists may be. Errors are InputError, with the messages of `rigor check`.
    """

    def __init__(self, description=None, *, folder=".", **keys):
        described = dict(description or {}, **keys)
        described.setdefault("rigor", 1)
        self._begin(_text(described), "scene", os.fspath(folder), [])

    @classmethod
    def from_text(cls, text, name="scene.yaml", folder="."):
        """The scene of a YAML (or JSON) text; meshes are looked for in the folder."""
        scene = cls.__new__(cls)
        scene._begin(text, name, os.fspath(folder), [])
        return scene

    def _begin(self, text, name, folder, overrides):
        self._parsed = _rigor.TextScene(text, name, folder, overrides)
        self._data = self._parsed.scene
        self._text, self._name, self._folder, self._overrides = text, name, folder, list(overrides)

    def set(self, path, value):
        """Sets a key, as --set does: scene.set("materials.steel.restitution", 0.5). Returns the scene."""
        self._begin(self._text, self._name, self._folder, self._overrides + [f"{path}={_text(value)}"])
        return self

    def copy(self):
        """An independent copy."""
        return _remade(*self._state())

    @property
    def name(self):
        """Name of the scene."""
        return self._data.name

    @property
    def bodies(self):
        """Names of the bodies, in their order."""
        return self._data.bodies

    @property
    def masses(self):
        """Masses of the bodies [kg]; 0 for those that forces do not move."""
        return self._data.masses

    @property
    def joints(self):
        """Names of the joints, in their order."""
        return [name for name, _ in self._data.joints]

    @property
    def warnings(self):
        """What is allowed but probably unintended."""
        return self._data.warnings

    def _state(self):
        return self._text, self._name, self._folder, self._overrides

    def __reduce__(self):
        return _remade, self._state()

    def __repr__(self):
        return f"<rigor.Scene {self.name!r}: {len(self.bodies)} bodies, {len(self.joints)} joints>"


def data_of(scene):
    """What the compiled part knows of a scene."""
    if isinstance(scene, Scene):
        return scene._data
    raise TypeError(f"a scene is a rigor.Scene, as rigor.load(file) gives one, not a {type(scene).__name__}")


def _remade(text, name, folder, overrides):
    scene = Scene.__new__(Scene)
    scene._begin(text, name, folder, overrides)
    return scene


def load(path, **overrides):
    """The scene of a file. Overrides: load("x.yaml", **{"run.step": 0.001})."""
    path = os.fspath(path)
    try:
        with open(path, encoding="utf-8") as file:
            text = file.read()
    except UnicodeDecodeError as error:
        raise _rigor.InputError(f"{path}: the file is not UTF-8: {error}") from None
    folder = os.path.dirname(os.path.abspath(path))
    return _remade(text, path, folder, [f"{key}={_text(value)}" for key, value in overrides.items()])
