#include "rigor/study/plan/parameter_values.hpp"

#include "rigor/core/assert.hpp"

#include <boost/math/special_functions/erf.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

/// The number below which a normal one lies with probability u: mean 0, deviation 1.
double normal_quantile(double u) {
  // Sobol's sequence begins with 0, whose quantile is infinite.
  constexpr double lowest = 0x1p-54;
  const double inside = std::clamp(u, lowest, 1 - 0x1p-53);
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * inside);
}

void add_box(const Parameter& parameter, const double* u, std::vector<double>& values) {
  for (int k = 0; k < 3; ++k)
    values.push_back(parameter.low_corner[k] + u[k] * (parameter.high_corner[k] - parameter.low_corner[k]));
}

/// Archimedes: the height of a uniform point on a sphere is uniform.
void add_sphere(const Parameter& parameter, const double* u, std::vector<double>& values) {
  const double z = 2 * u[0] - 1, across = std::sqrt(std::max(0.0, 1 - z * z)),
               angle = 2 * std::numbers::pi * u[1];
  const Vec3 direction(across * std::cos(angle), across * std::sin(angle), z);
  for (int k = 0; k < 3; ++k) values.push_back(parameter.center[k] + parameter.radius * direction[k]);
}

}  // namespace

std::array<double, 4> uniform_rotation(double u1, double u2, double u3) {
  const double a = std::sqrt(1 - u1), b = std::sqrt(u1);
  const double s = 2 * std::numbers::pi * u2, t = 2 * std::numbers::pi * u3;
  return {b * std::cos(t), a * std::sin(s), a * std::cos(s), b * std::sin(t)};
}

std::vector<std::size_t> columns_of(const Formula& formula, const std::vector<std::string>& names) {
  std::vector<std::size_t> columns;
  for (const std::string& name : formula.names()) {
    const auto found = std::find(names.begin(), names.end(), name);
    RIGOR_ASSERT(found != names.end());
    columns.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return columns;
}

ParameterValues::ParameterValues(const StudyPlan& plan) : plan_(plan) {
  const std::vector<std::string> names = plan.columns();
  std::size_t column = 0;
  for (const Parameter& parameter : plan.parameters) {
    if (parameter.kind == Parameter::Kind::formula) {
      Formula formula(parameter.formula);
      std::vector<std::size_t> columns = columns_of(formula, names);
      formulas_.push_back({std::move(formula), std::move(columns), column});
    }
    column += parameter.columns().size();
  }
}

std::vector<double> ParameterValues::at(std::span<const double> point) const {
  std::vector<double> values;
  const double* u = point.data();
  for (const Parameter& parameter : plan_.parameters) {
    switch (parameter.kind) {
      case Parameter::Kind::list:
        values.push_back(parameter.value_at(static_cast<std::uint64_t>(*u)));
        break;
      case Parameter::Kind::interval:
        values.push_back(parameter.value_between(*u));
        break;
      case Parameter::Kind::normal:
        values.push_back(parameter.mean + parameter.deviation * normal_quantile(*u));
        break;
      case Parameter::Kind::lognormal:
        values.push_back(std::exp(parameter.mean + parameter.deviation * normal_quantile(*u)));
        break;
      case Parameter::Kind::orientation:
        for (const double q : uniform_rotation(u[0], u[1], u[2])) values.push_back(q);
        break;
      case Parameter::Kind::box:
        add_box(parameter, u, values);
        break;
      case Parameter::Kind::sphere:
        add_sphere(parameter, u, values);
        break;
      case Parameter::Kind::formula:
        values.push_back(0);
        break;
    }
    u += parameter.coordinates();
  }
  derive(values);
  return values;
}

void ParameterValues::derive(std::vector<double>& values) const {
  std::vector<double> arguments;
  // A formula uses parameters above it only, so that one pass is enough.
  for (const Derived& derived : formulas_) {
    arguments.clear();
    for (const std::size_t column : derived.columns) arguments.push_back(values[column]);
    values[derived.column] = derived.formula.value(arguments);
  }
}

}  // namespace rigor
