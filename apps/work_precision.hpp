#pragma once

#include "apps/compare_run.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// Observed order of each run with respect to the previous one that differs in run.step alone:
///
///   p = ln(e / e') / ln(h / h'),
///
/// with the position errors e and the steps h. Nothing for runs without such a neighbour or with the same
/// step, and where an error is not well above that of the reference, or is of the size of rounding: below a
/// billionth of the bound of a good motion.
std::vector<std::optional<double>> observed_orders(const Comparison& comparison);

/// CPU time of each run relative to the one that all are compared with; nothing if that one is refused, or
/// took no measurable time.
std::vector<std::optional<double>> cpu_ratios(const Comparison& comparison);

/// Runs that differ in run.step alone, as one curve of a work-precision plot.
struct PrecisionCurve {
  std::string label;              ///< Label of the other values; empty if nothing else is varied.
  std::vector<std::size_t> runs;  ///< Indices, in the order of the comparison.
};
std::vector<PrecisionCurve> precision_curves(const Comparison& comparison);

/// The comparison as JSON for its page (docs/page.md, block `precision`); empty if no run has an error.
std::string precision_json(const Comparison& comparison);

}  // namespace rigor
