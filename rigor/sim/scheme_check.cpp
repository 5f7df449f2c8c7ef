#include "rigor/sim/scheme_check.hpp"

#include "rigor/core/range.hpp"

#include <cmath>

namespace rigor {

namespace {

bool has_moments(const PairCoefficients& pair) {
  return pair.rolling_friction > 0 || pair.torsional_friction > 0;
}

/// What the many-body path cannot do.
std::vector<std::string> check_substep(const Model& model, const Method& method) {
  std::vector<std::string> messages;
  if (!model.joints().empty())
    messages.push_back("solver 'substep' has no joints in this version (joint '" + model.joint(0).name +
                       "'); solvers that have them: exact");
  constexpr double most_substeps = 1000;
  if (method.substeps > most_substeps || method.substeps != std::floor(method.substeps))
    messages.push_back("substeps is " + number_text(method.substeps) +
                       ", must be a whole number up to 1000 with solver 'substep'");
  return messages;
}

}  // namespace

std::vector<std::string> check_scheme(const Model& model, const Method& method) {
  if (method.scheme != Scheme::time_stepping) return {};
  if (method.solver == SolverMethod::substep) return check_substep(model, method);
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
