"""Carts that balance their poles: 64 worlds on all threads, as a vector environment of gymnasium, without needing it."""

import numpy as np

import rigor


class CartPoles(rigor.VectorEnv):
    """observation: x [m], x' [m/s], angle [rad], angle' [rad/s] of each world; action: force on each cart [N]."""

    widest = 0.4  # [rad]

    def __init__(self, count, threads=0):
        scene = rigor.Scene(
            name="cart-pole", run={"step": 0.01}, method={"scheme": "time-stepping", "solver": "substep"},
            bodies=[{"name": "cart", "mass": 1, "shapes": [{"type": "box", "size": [0.4, 0.2, 0.1]}]},
                    {"name": "pole", "position": [0, 0, 0.5], "mass": 0.1,
                     "shapes": [{"type": "capsule", "radius": 0.01, "length": 0.98}]}],
            joints=[{"name": "rail", "type": "slider", "bodies": ["world", "cart"], "axis": [1, 0, 0]},
                    {"name": "pivot", "type": "hinge", "bodies": ["cart", "pole"], "anchor": [0, 0, 0],
                     "axis": [0, 1, 0]}])
        super().__init__(scene, count, rigor.Box(-np.inf, np.inf, (4,), np.float64),
                         rigor.Box(-20, 20, (1,), np.float64), longest=4, threads=threads)

    def act(self, actions):
        self.batch.apply_forces("cart", actions * [1, 0, 0])

    def observe(self):
        return np.stack([self.batch.joint_coordinates("rail"), self.batch.joint_rates("rail"),
                         self.batch.joint_coordinates("pivot"), self.batch.joint_rates("pivot")], axis=1)

    def judge(self, observation, actions):
        angle = np.abs(observation[:, 2])
        return 1 - angle / self.widest, angle > self.widest

    def begin(self, index):
        # A push at the pole's upper end.
        self.batch.world(index).apply_angular_impulse("pole", [0, self.random.uniform(-0.01, 0.01), 0])


def main():
    carts = CartPoles(64)
    observation, _ = carts.reset(seed=0)
    falls = 0
    for _ in range(350):
        force = observation @ np.array([[3.2], [5.0], [36.0], [9.0]])
        observation, reward, terminated, truncated, _ = carts.step(force)
        falls += terminated.sum()
    print(f"{falls} of 64 poles fell; the widest angle is {np.abs(observation[:, 2]).max():.2g} rad")
    return falls == 0 and np.abs(observation[:, 2]).max() < 1e-2


if __name__ == "__main__":
    raise SystemExit(0 if main() else 1)
