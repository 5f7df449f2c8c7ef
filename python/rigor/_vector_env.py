"""Many worlds behind the interface of gymnasium's vector environments, with gymnasium or without it."""

import numpy as np

from ._simulation import Batch

try:
    import gymnasium
    _Base = gymnasium.vector.VectorEnv
except ImportError:
    gymnasium = None
    _Base = object


class _Box:
    """A space of arrays between two bounds, as gymnasium.spaces.Box, where gymnasium is absent."""

    def __init__(self, low, high, shape=None, dtype=np.float32, seed=None):
        self.shape = tuple(shape) if shape is not None else np.broadcast(low, high).shape
        self.dtype = np.dtype(dtype)
        self.low = np.broadcast_to(np.asarray(low, self.dtype), self.shape)
        self.high = np.broadcast_to(np.asarray(high, self.dtype), self.shape)
        if not np.all(self.low <= self.high):
            raise ValueError("low must nowhere be above high")
        self.seed(seed)

    def seed(self, seed=None):
        """Begins the random numbers of sample() anew."""
        self._random = np.random.default_rng(seed)

    def sample(self):
        """An array of the space: evenly spread where it is bounded, else normally or exponentially."""
        low, high = self.low.astype(float), self.high.astype(float)
        has_low, has_high = np.isfinite(low), np.isfinite(high)
        even = self._random.uniform(np.where(has_low & has_high, low, 0), np.where(has_low & has_high, high, 1))
        tail = self._random.exponential(size=self.shape)
        free = self._random.normal(size=self.shape)
        one_sided = np.where(has_low, np.where(has_low, low, 0) + tail, np.where(has_high, high, 0) - tail)
        value = np.where(has_low & has_high, even, np.where(has_low | has_high, one_sided, free))
        return value.astype(self.dtype)

    def contains(self, x):
        """Whether x is an array of the space."""
        x = np.asarray(x)
        return bool(np.can_cast(x.dtype, self.dtype) and x.shape == self.shape and np.all(x >= self.low)
                    and np.all(x <= self.high))

    __contains__ = contains

    def __eq__(self, other):
        return (isinstance(other, _Box) and self.shape == other.shape and self.dtype == other.dtype
                and np.array_equal(self.low, other.low) and np.array_equal(self.high, other.high))

    def __repr__(self):
        return f"Box({self.low.min() if self.low.size else ''}, {self.high.max() if self.high.size else ''}, {self.shape}, {self.dtype})"


Box = gymnasium.spaces.Box if gymnasium else _Box


def _batched(space, count):
    """The space of `count` arrays of a space."""
    repeated = (count,) + (1,) * len(space.shape)
    return Box(np.tile(space.low, repeated), np.tile(space.high, repeated), dtype=space.dtype)


class VectorEnv(_Base):
    """`count` worlds of a scene as an environment: reset() and step() of all at once, as arrays with a row for each.

    A subclass says what is seen, done and wanted:

    - act(actions): applies an array of the action space to self.batch;
    - observe(): an array of the observation space;
    - judge(observation, actions): rewards and flags of the ends, one for each world;
    - begin(index): what a world begins with after its reset to t = 0, with random numbers of self.random.

    A world that has ended begins anew within the same step (gymnasium's SAME_STEP): `observation` is then that of
    its new beginning, and the last one of its past stands in info["final_obs"], where info["_final_obs"] is true. A
    world whose engine has stopped ends as truncated, with its reason in info["stops"].

    longest: the time [s] after which a world ends as truncated. steps: of the simulation in one step of this.
    """

    metadata = {"autoreset_mode": gymnasium.vector.AutoresetMode.SAME_STEP
                if gymnasium and hasattr(gymnasium.vector, "AutoresetMode") else "SameStep"}
    render_mode = None
    spec = None

    def __init__(self, scene, count, observation_space, action_space, longest=np.inf, steps=1, threads=0):
        self.batch = Batch(scene, count, threads)
        self.num_envs = count
        self.longest = longest
        self.steps = steps
        self.single_observation_space = observation_space
        self.single_action_space = action_space
        self.observation_space = _batched(observation_space, count)
        self.action_space = _batched(action_space, count)
        self.random = np.random.default_rng()

    def act(self, actions):
        raise NotImplementedError("act(actions) applies the actions to self.batch")

    def observe(self):
        raise NotImplementedError("observe() gives the observations, a row for each world")

    def judge(self, observation, actions):
        raise NotImplementedError("judge(observation, actions) gives rewards and flags of the ends")

    def begin(self, index):
        """What a world begins with: as the scene says, unless a subclass does something."""

    def reset(self, *, seed=None, options=None):
        """All worlds from their beginning: observation, info. A seed begins the random numbers anew."""
        if seed is not None:
            self.random = np.random.default_rng(seed)
        for index in range(self.num_envs):
            self._begin(index)
        return self._observed(), {}

    def step(self, actions):
        """One step of all worlds: observation, rewards, terminated, truncated, info."""
        actions = np.asarray(actions)
        if actions.shape != self.action_space.shape:
            raise ValueError(f"actions have the shape {actions.shape}, must have {self.action_space.shape}")
        for _ in range(self.steps):
            self.act(actions)
            self.batch.step()
        observation = self._observed()
        rewards, terminated = self.judge(observation, actions)
        rewards = np.asarray(rewards, dtype=np.float64)
        terminated = np.asarray(terminated, dtype=bool)
        stops = list(self.batch.stops)
        has_stopped = np.array([bool(stop) for stop in stops])
        truncated = ((self.batch.times >= self.longest * (1 - 1e-12)) | has_stopped) & ~terminated

        info = {}
        ended = terminated | truncated
        if ended.any():
            info = {"final_obs": observation.copy(), "_final_obs": ended, "stops": stops}
            for index in np.flatnonzero(ended):
                self._begin(int(index))
            observation = self._observed()
        return observation, rewards, terminated, truncated, info

    def close(self, **kwargs):
        """Nothing is open."""

    @property
    def unwrapped(self):
        return self

    def _begin(self, index):
        self.batch.reset(index)
        self.begin(index)

    def _observed(self):
        return np.asarray(self.observe(), dtype=self.single_observation_space.dtype)
