#include "rigor/sim/method/scheme_check.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/range.hpp"
#include "rigor/model/model.hpp"
#include "rigor/sim/method/method.hpp"

#include <cmath>
#include <functional>
#include <optional>

namespace rigor {

namespace {

bool has_moments(const PairCoefficients& pair) {
  return pair.rolling_friction > 0 || pair.torsional_friction > 0;
}

/// Settings that the many-body path does not take.
std::vector<std::string> check_substep(const Method& method) {
  constexpr double most_substeps = 1000;
  if (method.substeps <= most_substeps && method.substeps == std::floor(method.substeps)) return {};
  return {"substeps is " + number_text(method.substeps) +
          ", must be a whole number up to 1000 with solver 'substep'"};
}

bool has_static_friction(const PairCoefficients& pair) {
  return pair.sticking_friction() > pair.friction;
}

/// The first pair of materials of this kind: "materials 'a' and 'b'".
std::optional<std::string> find_pair(const Model& model,
                                     const std::function<bool(const PairCoefficients&)>& is_of_kind) {
  const int count = static_cast<int>(model.materials().size());
  for (int a = 0; a < count; ++a) {
    for (int b = a; b < count; ++b) {
      if (!is_of_kind(model.coefficients(a, b))) continue;
      const auto name = [&](int i) { return "'" + model.materials()[at(i)].name + "'"; };
      return "materials " + name(a) + " and " + name(b);
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> check_scheme(const Model& model, const Method& method) {
  std::vector<std::string> messages;
  if (method.scheme == Scheme::automatic) return messages;
  const std::string scheme = "scheme '" + method_choice(method, "scheme") + "'";
  if (method.scheme != Scheme::time_stepping) {
    if (const std::optional<std::string> pair = find_pair(model, has_static_friction))
      messages.push_back(scheme + " has one coefficient of friction, no static_friction above it (" + *pair +
                         "); schemes that have it: time-stepping");
    return messages;
  }
  if (method.solver == SolverMethod::substep) {
    messages = check_substep(method);
    if (const std::optional<std::string> pair = find_pair(model, has_static_friction))
      messages.push_back(scheme + " with solver 'substep' has no static_friction above friction (" + *pair +
                         "); solvers that have it: exact, pgs");
    return messages;
  }
  const bool is_exact = method.solver == SolverMethod::exact && method.cone == ConeMethod::exact;
  if (is_exact) return messages;
  if (const std::optional<std::string> pair = find_pair(model, has_moments)) {
    const std::string key = method.cone == ConeMethod::exact ? "solver" : "cone";
    messages.push_back(scheme + " with " + key + " '" + method_choice(method, key) +
                       "' has no rolling or torsional friction (" + *pair + "); " + key +
                       "s that have it: exact");
  }
  return messages;
}

}  // namespace rigor
