#pragma once

#include <array>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace rigor {

/// A number that depends on the time: constant, a sine, a table or a formula.
class TimeFunction {
 public:
  /// mean + amplitude sin(2π frequency t + phase).
  struct Sine {
    double mean = 0, amplitude = 0;
    double frequency = 0;  ///< [Hz].
    double phase = 0;      ///< [rad].
  };
  /// Straight lines between points (time [s], value), whose times do not descend: two points of one time are
  /// a jump. Before the first and after the last point the value stays.
  struct Table {
    std::vector<std::array<double, 2>> points;
  };
  /// Any function of the time [s]. The text stands for it where two scenes are compared. Several threads may
  /// call it at once.
  struct Formula {
    std::string text;
    std::function<double(double t)> value;
  };

  TimeFunction(double constant = 0) : law_(constant) {}
  TimeFunction(Sine sine) : law_(sine) {}
  TimeFunction(Table table) : law_(std::move(table)) {}
  TimeFunction(Formula formula) : law_(std::move(formula)) {}

  double value(double t) const;
  /// The mean from t_begin to t_end [s]; the value at t_begin if that is all. Exact but for a formula, whose
  /// integral is Gauss's with three points: of fifth degree.
  double mean(double t_begin, double t_end) const;
  bool is_constant() const { return std::holds_alternative<double>(law_); }
  /// What is wrong with it, as "has no points"; empty if nothing is.
  std::string defect() const;

  using Law = std::variant<double, Sine, Table, Formula>;
  const Law& law() const { return law_; }

 private:
  Law law_;
};

}  // namespace rigor
