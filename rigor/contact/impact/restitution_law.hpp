#pragma once

#include <span>
#include <string_view>

namespace rigor {

/// When the restitution of an impact ends. Each law is a row of the table in restitution_law.cpp and a file
/// of its own (docs/extending.md tells how one is added).
enum class RestitutionLaw {
  newton,   ///< At u_n = -e u_n⁻. With friction it can add energy.
  poisson,  ///< When the normal impulse is (1 + e) times that of compression.
  stronge,  ///< When the work of the normal impulse is (1 - e²) times that of compression. Never adds energy.
  count,    ///< The number of laws, not a law.
};

/// What changes along an impact, in the words of ImpactState.
enum class ImpactQuantity { p, u_n, work };

/// What a law knows when it decides: the motion before the impact and its compression.
struct CompressionRecord {
  double u_n_before;  ///< u_n⁻, ≤ 0 [m/s].
  double p_before;    ///< p where the impact began [N s].
  double p;           ///< p of the first compression alone [N s].
  double work;        ///< Lowest W so far, ≤ 0: that of the deepest compression [J].
};

/// Restitution ends as soon as the quantity reaches this value from below. u_n and work count during
/// restitution only, where they grow; p, which always grows, also while the bodies are compressed again.
struct RestitutionEnd {
  ImpactQuantity quantity;  ///< The same for every impact of a law.
  double value;
};

/// One row of the table of laws.
struct RestitutionRule {
  RestitutionLaw law;
  std::string_view name;     ///< In scene files and on the command line: "newton".
  std::string_view title;    ///< In texts and figures: "Newton".
  std::string_view meaning;  ///< One line.
  std::string_view source;   ///< Where the law is from.
  /// Where restitution ends for a restitution e in [0, 1]. (A reference: a row without it does not compile.)
  RestitutionEnd (&end)(double e, const CompressionRecord& compression);
};

/// All laws, in the order of the enumerators.
std::span<const RestitutionRule> restitution_rules();
const RestitutionRule& rule_of(RestitutionLaw law);

// The laws themselves, each in its own file NAME_restitution.cpp.
RestitutionEnd newton_restitution(double e, const CompressionRecord& compression);
RestitutionEnd poisson_restitution(double e, const CompressionRecord& compression);
RestitutionEnd stronge_restitution(double e, const CompressionRecord& compression);

}  // namespace rigor
