#pragma once

namespace rigor {

/// A large τ in [0, τ_max] such that the concave function f, with f(0) ≥ 0, is not negative on [0, τ]. The
/// value is found by safeguarded false position: it is τ_max itself if f(τ_max) ≥ 0, and 0 if no positive one
/// was found.
template <typename Function>
double safe_step_of_concave(const Function& f, double tau_max) {
  constexpr double factor = 8;
  constexpr int most_reductions = 25, refinements = 4;
  // A concave function that is not negative at 0 and at τ_max is not negative in between.
  double high = tau_max, at_high = f(tau_max);
  if (at_high >= 0) return tau_max;
  // Bracketing: τ is reduced until f is not negative there, however small that τ is. f may fall steeply at
  // first, so the reduction is by a large factor.
  double low = high / factor, at_low = f(low);
  for (int k = 0; at_low < 0; ++k) {
    if (k == most_reductions) return 0;
    high = low;
    at_high = at_low;
    low /= factor;
    at_low = f(low);
  }
  // Refinement: the chord of a concave function lies below it, so the zero of the chord between a safe and an
  // unsafe τ is safe as well. The midpoint then moves one of the two ends, so that the bracket is at least
  // halved even where the chord is poor.
  for (int k = 0; k < refinements; ++k) {
    const double chord = low + (high - low) * (at_low / (at_low - at_high));
    if (!(chord > low) || !(chord < high)) break;
    const double at_chord = f(chord);
    if (!(at_chord >= 0)) break;
    low = chord;
    at_low = at_chord;
    const double middle = 0.5 * (low + high), at_middle = f(middle);
    (at_middle >= 0 ? low : high) = middle;
    (at_middle >= 0 ? at_low : at_high) = at_middle;
  }
  return low;
}

}  // namespace rigor
