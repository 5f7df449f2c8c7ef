"""Carts that balance their poles: 64 worlds on all threads, behind the interface of gymnasium's vector environments
(reset, step, observation and action of all worlds at once), without needing it.
"""

import numpy as np

import rigor


class CartPoles:
    """observation: x [m], x' [m/s], angle [rad], angle' [rad/s] of each world; action: force on each cart [N]."""

    longest = 4.0  # [s]
    widest = 0.4  # [rad]

    def __init__(self, count, seed=0):
        scene = rigor.Scene(
            name="cart-pole", run={"step": 0.01}, method={"scheme": "time-stepping", "solver": "substep"},
            bodies=[{"name": "cart", "mass": 1, "shapes": [{"type": "box", "size": [0.4, 0.2, 0.1]}]},
                    {"name": "pole", "position": [0, 0, 0.5], "mass": 0.1,
                     "shapes": [{"type": "capsule", "radius": 0.01, "length": 0.98}]}],
            joints=[{"name": "rail", "type": "slider", "bodies": ["world", "cart"], "axis": [1, 0, 0]},
                    {"name": "pivot", "type": "hinge", "bodies": ["cart", "pole"], "anchor": [0, 0, 0],
                     "axis": [0, 1, 0]}])
        self.num_envs = count
        self.batch = rigor.Batch(scene, count)
        self.random = np.random.default_rng(seed)

    def reset(self):
        for i in range(self.num_envs):
            self._begin(i)
        return self._observation(), {}

    def step(self, action):
        self.batch.apply_forces("cart", np.outer(action, [1, 0, 0]))
        self.batch.step()
        observation = self._observation()
        terminated = np.abs(observation[:, 2]) > self.widest
        truncated = np.array([self.batch.world(i).time for i in range(self.num_envs)]) > self.longest
        reward = 1.0 - np.abs(observation[:, 2]) / self.widest
        for i in np.flatnonzero(terminated | truncated):
            self._begin(int(i))
        return observation, reward, terminated, truncated, {}

    def _begin(self, i):
        self.batch.reset(i)
        # A push at the pole's upper end.
        self.batch.world(i).apply_angular_impulse("pole", [0, self.random.uniform(-0.01, 0.01), 0])

    def _observation(self):
        return np.stack([self.batch.joint_coordinates("rail"), self.batch.joint_rates("rail"),
                         self.batch.joint_coordinates("pivot"), self.batch.joint_rates("pivot")], axis=1)


def main():
    carts = CartPoles(64)
    observation, _ = carts.reset()
    falls = 0
    for _ in range(350):
        force = observation @ np.array([3.2, 5.0, 36.0, 9.0])
        observation, reward, terminated, truncated, _ = carts.step(force)
        falls += terminated.sum()
    print(f"{falls} of 64 poles fell; the widest angle is {np.abs(observation[:, 2]).max():.2g} rad")
    return falls == 0 and np.abs(observation[:, 2]).max() < 1e-2


if __name__ == "__main__":
    raise SystemExit(0 if main() else 1)
