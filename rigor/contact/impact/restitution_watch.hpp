#pragma once

#include "rigor/contact/impact/collision.hpp"
#include "rigor/contact/impact/impact_piece.hpp"

#include <optional>
#include <string>

namespace rigor {

/// Follows compression and restitution along the pieces of an impact, and finds where the law ends it.
///
/// Compression ends at u_n = 0. If u_n falls below zero again during restitution, a further compression
/// begins: the work of the record is then the lowest so far, its impulse stays that of the first compression
/// (docs/theory/impact.md).
class RestitutionWatch {
 public:
  RestitutionWatch(RestitutionLaw law, double e, const ImpactState& start)
      : rule_(rule_of(law)), e_(e), record_{start.u.z(), start.p, 0, 0} {}

  /// Follows the piece, on which u_n is monotone between a and b. Returns where the impact ends, if it does.
  std::optional<double> follow(const ImpactPiece& piece, PiecePoint a, const PiecePoint& b);
  /// Sets the normal velocity that the law names, without the rounding of the search.
  void set_end(ImpactState& state) const;
  /// Adds a letter to the phases (CollisionOutcome): S, K or U.
  void note(char phase);
  /// In the limit μ → ∞ the contact has come to rest without normal impulse and work. Returns whether the
  /// impact ends with it.
  bool leave_limit(ImpactState& state);

  const std::string& phases() const { return phases_; }
  /// At the end of the first compression.
  const CollisionPoint& compression() const { return compression_; }

 private:
  void begin_restitution(const ImpactPiece& piece, double z);
  std::optional<double> end_by_impulse(const ImpactPiece& piece, const PiecePoint& a,
                                       const PiecePoint& b) const;
  std::optional<double> end_by_motion(const ImpactPiece& piece, const PiecePoint& a,
                                      const PiecePoint& b) const;

  /// Where the law ends restitution, by the compression so far.
  RestitutionEnd end() const { return rule_.end(e_, record_); }

  const RestitutionRule& rule_;
  double e_;
  CompressionRecord record_;
  bool is_sliding_ = false;
  bool is_compressing_ = true;
  bool has_compression_ = false;
  CollisionPoint compression_;
  std::string phases_;
};

}  // namespace rigor
