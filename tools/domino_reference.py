#!/usr/bin/env python3
"""When the dominoes of scenes/studies/domino_wave.yaml strike each other: an integration of its own.

Dominoes of height h and thickness d turn about their front lower edges, at multiples of s. θ is the angle from upright. The
upper front edge of one slides without friction on the back of the next: with their angles θ and φ the gap between them is

    g = s cos φ - h sin(θ - φ) - d.

Between strikes the accelerations fulfil I θ'' = m g_0 x(θ) + Gᵀ λ with λ ≥ 0 where gaps are closed and stay so, else λ = 0; a
strike is the nearest velocities, in kinetic energy, at which no closed gap closes further (restitution 0). Runge-Kutta of
order 4 with steps of 0.1 ms; strikes by bisection.

usage: tools/domino_reference.py [spacing...] [--steps N]     prints for each spacing [m] when 5 strikes 6, when 15 strikes 16,
                                                              and the speed of the wave between them
"""
import argparse
import math

G0, D, H, M, DENSITY = 9.81, 0.01, 0.05, 20, 1200
MASS = DENSITY * D * H * 0.025
INERTIA = MASS * (D * D + H * H) / 3
FIRST_RATE = 6.0


class Row:
    """Angles and rates of the dominoes, and which gaps are closed."""

    def __init__(self, spacing):
        self.s = spacing
        self.angles = [0.0] * M
        self.rates = [FIRST_RATE] + [0.0] * (M - 1)
        self.closed = set()

    def gap(self, k, angles):
        return self.s * math.cos(angles[k + 1]) - H * math.sin(angles[k] - angles[k + 1]) - D

    def gradient(self, k, angles):
        """Derivatives of the gap k by the two angles."""
        reach = H * math.cos(angles[k] - angles[k + 1])
        return -reach, reach - self.s * math.sin(angles[k + 1])

    def gap_rate(self, k, angles, rates):
        a, b = self.gradient(k, angles)
        return a * rates[k] + b * rates[k + 1]


def free_acceleration(angle):
    arm = -0.5 * D * math.cos(angle) + 0.5 * H * math.sin(angle)
    return MASS * G0 * arm / INERTIA


def least_corrections(row, angles, base, wanted, contacts, inverse):
    """Smallest changes of `base` (in kinetic energy) so that G base + wanted ≥ 0 on the contacts: new values, multipliers.

    Active set on the tridiagonal system: all contacts first, those that would pull are left out."""
    active = sorted(contacts)
    while True:
        rows = [row.gradient(k, angles) for k in active]
        # (G M⁻¹ Gᵀ) λ = -(G base + wanted)
        n = len(active)
        matrix = [[0.0] * n for _ in range(n)]
        right = [0.0] * n
        for i, k in enumerate(active):
            a, b = rows[i]
            matrix[i][i] = inverse[k] * a * a + inverse[k + 1] * b * b
            right[i] = -(a * base[k] + b * base[k + 1] + wanted.get(k, 0.0))
            if i + 1 < n and active[i + 1] == k + 1:
                matrix[i][i + 1] = matrix[i + 1][i] = inverse[k + 1] * b * rows[i + 1][0]
        forces = solve_tridiagonal(matrix, right)
        pulling = [k for k, f in zip(active, forces) if f < 0]
        if not pulling:
            break
        active = [k for k in active if k not in pulling]
    changed = list(base)
    for k, f in zip(active, forces):
        a, b = row.gradient(k, angles)
        changed[k] += inverse[k] * a * f
        changed[k + 1] += inverse[k + 1] * b * f
    return changed, set(active)


def solve_tridiagonal(matrix, right):
    n = len(right)
    diagonal = [matrix[i][i] for i in range(n)]
    x = list(right)
    for i in range(1, n):
        share = matrix[i][i - 1] / diagonal[i - 1]
        diagonal[i] -= share * matrix[i - 1][i]
        x[i] -= share * x[i - 1]
    for i in reversed(range(n)):
        if i + 1 < n:
            x[i] -= matrix[i][i + 1] * x[i + 1]
        x[i] /= diagonal[i]
    return x


def accelerations(row, angles, rates, closed):
    base, inverse = [], []
    for k in range(M):
        stands = angles[k] <= 0 and rates[k] <= 0  # On its whole base: nothing but a strike moves it.
        base.append(0.0 if stands else free_acceleration(angles[k]))
        inverse.append(0.0 if stands else 1 / INERTIA)
    wanted = {}
    for k in closed:
        lean = angles[k] - angles[k + 1]
        wanted[k] = H * math.sin(lean) * (rates[k] - rates[k + 1]) ** 2 - row.s * math.cos(angles[k + 1]) * rates[k + 1] ** 2
    return least_corrections(row, angles, base, wanted, closed, inverse)


def advanced(row, h):
    """Angles and rates after h, under the gaps that are closed now, and which of them still press."""
    def slope(angles, rates):
        return rates, accelerations(row, angles, rates, row.closed)[0]

    def moved(by, rate, factor):
        return [y + factor * r for y, r in zip(by, rate)]

    q, v = row.angles, row.rates
    a1 = slope(q, v)
    a2 = slope(moved(q, a1[0], h / 2), moved(v, a1[1], h / 2))
    a3 = slope(moved(q, a2[0], h / 2), moved(v, a2[1], h / 2))
    a4 = slope(moved(q, a3[0], h), moved(v, a3[1], h))

    def sum_of(y, part):
        return [y[i] + h / 6 * (a1[part][i] + 2 * a2[part][i] + 2 * a3[part][i] + a4[part][i]) for i in range(M)]

    return sum_of(q, 0), sum_of(v, 1)


def strikes(spacing, step, until):
    """Times at which each pair first touches, up to that of the pair `until`; what parted on the way."""
    row, t, times, parted = Row(spacing), 0.0, {}, []
    while until not in times:
        _, pressing = accelerations(row, row.angles, row.rates, row.closed)
        for k in sorted(row.closed - pressing):
            parted.append((t, k + 1))
        row.closed = pressing
        open_gaps = [k for k in range(M - 1) if k not in row.closed]
        q, v = advanced(row, step)
        if all(row.gap(k, q) > 0 for k in open_gaps):
            row.angles, row.rates, t = q, v, t + step
            continue
        low, high = 0.0, step
        while high - low > 1e-15:
            middle = 0.5 * (low + high)
            q, _ = advanced(row, middle)
            if all(row.gap(k, q) > 0 for k in open_gaps):
                low = middle
            else:
                high = middle
        q, v = advanced(row, high)
        row.angles, row.rates, t = q, v, t + high
        struck = [k for k in open_gaps if row.gap(k, q) <= 0]
        for k in struck:
            times.setdefault(k + 1, t)
            row.closed.add(k)
        row.rates, row.closed = least_corrections(row, q, v, {}, row.closed, [1 / INERTIA] * M)
        row.closed |= set(struck)
    return times, parted


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("spacings", nargs="*", type=float, default=[0.02, 0.025, 0.03, 0.035, 0.04])
    parser.add_argument("--step", type=float, default=1e-4)
    options = parser.parse_args()
    for s in options.spacings:
        times, parted = strikes(s, options.step, 15)
        print(f"s = {s} m: 1 strikes 2 at {times[1]:.12f} s, 5 strikes 6 at {times[5]:.12f} s, 15 strikes 16 at {times[15]:.12f} s, "
              f"speed {10 * s / (times[15] - times[5]):.12f} m/s, parted {len(parted)} times")


if __name__ == "__main__":
    main()
