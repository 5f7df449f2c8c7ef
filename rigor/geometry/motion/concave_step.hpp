#pragma once

namespace rigor {

/// A large τ in [0, τ_max] up to which a concave function f with f(0) ≥ 0 is not negative, by safeguarded
/// false position: τ_max itself if f(τ_max) ≥ 0; 0 if none could be found.
template <typename Function>
double safe_step_of_concave(const Function& f, double tau_max) {
  constexpr double factor = 8;
  constexpr int most_reductions = 25, refinements = 4;
  double high = tau_max, at_high = f(tau_max);
  if (at_high >= 0) return tau_max;
  double low = high / factor, at_low = f(low);
  for (int k = 0; at_low < 0; ++k) {
    if (k == most_reductions) return 0;
    high = low;
    at_high = at_low;
    low /= factor;
    at_low = f(low);
  }
  // The chord of a concave function lies below it: its zero is safe.
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
