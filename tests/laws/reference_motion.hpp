#pragma once

#include <cmath>

namespace rigor::test {

/// Angle and rate of one freedom after the duration, by the classical Runge-Kutta method in long double:
/// with thousands of steps a second its error is far below the rounding of doubles.
struct OneFreedom {
  long double angle = 0, rate = 0;
};
template <typename Acceleration>
OneFreedom motion_after(OneFreedom y, long double duration, int steps, const Acceleration& acceleration) {
  const long double h = duration / steps;
  const auto slope = [&](const OneFreedom& at) { return OneFreedom{at.rate, acceleration(at)}; };
  const auto moved = [](const OneFreedom& from, long double by, const OneFreedom& k) {
    return OneFreedom{from.angle + by * k.angle, from.rate + by * k.rate};
  };
  for (int i = 0; i < steps; ++i) {
    const OneFreedom k1 = slope(y), k2 = slope(moved(y, h / 2, k1)), k3 = slope(moved(y, h / 2, k2)),
                     k4 = slope(moved(y, h, k3));
    y = moved(moved(moved(moved(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  return y;
}

}  // namespace rigor::test
