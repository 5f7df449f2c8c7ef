#include "rigor/sim/scheme_check.hpp"

namespace rigor {

namespace {

bool has_moments(const PairCoefficients& pair) {
  return pair.rolling_friction > 0 || pair.torsional_friction > 0;
}

}  // namespace

std::vector<std::string> check_scheme(const Model& model, const Method& method) {
  if (method.scheme != Scheme::time_stepping) return {};
  const int count = static_cast<int>(model.materials().size());
  for (int a = 0; a < count; ++a) {
    for (int b = a; b < count; ++b) {
      if (!has_moments(model.coefficients(a, b))) continue;
      const auto name = [&](int i) {
        return "'" + model.materials()[static_cast<std::size_t>(i)].name + "'";
      };
      return {"scheme 'time-stepping' has no rolling or torsional friction in this version (materials " +
              name(a) + " and " + name(b) + "); schemes that have it: event-driven"};
    }
  }
  return {};
}

}  // namespace rigor
