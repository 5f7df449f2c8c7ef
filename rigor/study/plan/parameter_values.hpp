#pragma once

#include "rigor/study/formula/formula.hpp"
#include "rigor/study/plan/study_plan.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace rigor {

/// Gives the parameters of a run their values, on one thread.
class ParameterValues {
 public:
  /// plan must outlive this object.
  explicit ParameterValues(const StudyPlan& plan);

  /// The values of all columns of the plan at a point: for each parameter's coordinates a number in [0, 1],
  /// or the index of a value of its list.
  std::vector<double> at(std::span<const double> point) const;
  /// Gives the parameters that are formulas their values anew, from the values of the others.
  void derive(std::vector<double>& values) const;

 private:
  struct Derived {
    Formula formula;
    std::vector<std::size_t> columns;  ///< Of its names.
    std::size_t column;                ///< Its own.
  };
  const StudyPlan& plan_;
  std::vector<Derived> formulas_;  ///< Of the parameters that are formulas, in order.
};

/// Columns of the plan (or indices in `names`) of the names of a formula.
std::vector<std::size_t> columns_of(const Formula& formula, const std::vector<std::string>& names);

/// A quaternion w, x, y, z, uniform on SO(3) if the three numbers are uniform in [0, 1].
///
/// Source: Shoemake, Uniform random rotations, Graphics Gems III, 1992.
std::array<double, 4> uniform_rotation(double u1, double u2, double u3);

}  // namespace rigor
