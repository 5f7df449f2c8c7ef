#include "rigor/model/time_function.hpp"

#include "rigor/core/index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

using TimedPoints = std::vector<std::array<double, 2>>;

/// The point after which t lies on a line; the table has at least one point, and t is within it.
std::size_t line_of(const TimedPoints& points, double t) {
  const auto after = std::upper_bound(points.begin(), points.end(), t,
                                      [](double time, const auto& p) { return time < p[0]; });
  return at(std::clamp<long>(after - points.begin() - 1, 0,
                             std::max<long>(0, static_cast<long>(points.size()) - 2)));
}

double table_value(const TimedPoints& points, double t) {
  if (t < points.front()[0]) return points.front()[1];
  if (t >= points.back()[0]) return points.back()[1];
  const std::size_t i = line_of(points, t);
  const auto& [t_a, a] = points[i];
  const auto& [t_b, b] = points[i + 1];
  return a + (b - a) * ((t - t_a) / (t_b - t_a));
}

double table_mean(const TimedPoints& points, double t_begin, double t_end) {
  // What lies before and after the points.
  double integral = 0;
  if (t_begin < points.front()[0])
    integral += points.front()[1] * (std::min(t_end, points.front()[0]) - t_begin);
  if (t_end > points.back()[0]) integral += points.back()[1] * (t_end - std::max(t_begin, points.back()[0]));

  // Each line as far as it lies within.
  for (std::size_t i = line_of(points, t_begin); i + 1 < points.size() && points[i][0] < t_end; ++i) {
    const auto& [t_a, a] = points[i];
    const auto& [t_b, b] = points[i + 1];
    const double from = std::max(t_begin, t_a), to = std::min(t_end, t_b);
    if (to > from) integral += (a + (b - a) * ((0.5 * (from + to) - t_a) / (t_b - t_a))) * (to - from);
  }
  return integral / (t_end - t_begin);
}

double sine_mean(const TimeFunction::Sine& sine, double t_begin, double t_end) {
  const double rate = 2 * std::numbers::pi * sine.frequency;
  const double half = 0.5 * rate * (t_end - t_begin);
  const double share = half == 0 ? 1 : std::sin(half) / half;
  return sine.mean + sine.amplitude * share * std::sin(0.5 * rate * (t_begin + t_end) + sine.phase);
}

/// Gauss and Legendre's rule of three points.
double formula_mean(const TimeFunction::Formula& formula, double t_begin, double t_end) {
  const double middle = 0.5 * (t_begin + t_end), reach = 0.5 * (t_end - t_begin) * std::sqrt(0.6);
  return (5 * formula.value(middle - reach) + 8 * formula.value(middle) + 5 * formula.value(middle + reach)) /
         18;
}

std::string table_defect(const TimedPoints& points) {
  if (points.empty()) return "has no points";
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1]))
      return fmt::format("has at point {} a number that is not finite", i);
    if (i > 0 && points[i][0] < points[i - 1][0])
      return fmt::format("has at point {} the time {} s after {} s; times must not descend", i, points[i][0],
                         points[i - 1][0]);
  }
  return {};
}

}  // namespace

double TimeFunction::value(double t) const {
  if (const double* const constant = std::get_if<double>(&law_)) return *constant;
  if (const Table* const table = std::get_if<Table>(&law_)) return table_value(table->points, t);
  if (const Sine* const sine = std::get_if<Sine>(&law_)) return sine_mean(*sine, t, t);
  return std::get<Formula>(law_).value(t);
}

double TimeFunction::mean(double t_begin, double t_end) const {
  if (is_constant() || !(t_end > t_begin)) return value(t_begin);
  if (const Table* const table = std::get_if<Table>(&law_)) return table_mean(table->points, t_begin, t_end);
  if (const Sine* const sine = std::get_if<Sine>(&law_)) return sine_mean(*sine, t_begin, t_end);
  return formula_mean(std::get<Formula>(law_), t_begin, t_end);
}

std::string TimeFunction::defect() const {
  if (const Table* const table = std::get_if<Table>(&law_)) return table_defect(table->points);
  if (const Formula* const formula = std::get_if<Formula>(&law_); formula && !formula->value)
    return "has no function";
  if (const Sine* const sine = std::get_if<Sine>(&law_)) {
    for (const double number : {sine->mean, sine->amplitude, sine->frequency, sine->phase}) {
      if (!std::isfinite(number)) return "has a number that is not finite";
    }
  }
  const double first = value(0);
  return std::isfinite(first) ? std::string() : fmt::format("is {} at t = 0", first);
}

}  // namespace rigor
