#pragma once

#include "rigor/contact/impact/collision.hpp"
#include "rigor/contact/impact/impact_piece.hpp"

#include <optional>
#include <string>

namespace rigor {

/// Follows compression and restitution along the pieces of an impact, and finds where the law ends it.
///
/// Compression ends at u_n = 0. If u_n falls below zero again during restitution, compression begins anew;
/// Stronge's law then takes the lowest work so far, Poisson's and Newton's keep to the first compression
/// (docs/theory/impact.md).
class RestitutionWatch {
 public:
  RestitutionWatch(RestitutionLaw law, double e, const ImpactState& start)
      : law_(law), e_(e), u_n_target_(-e * start.u.z()), start_(start) {}

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

  RestitutionLaw law_;
  double e_;
  double u_n_target_;
  ImpactState start_;
  bool is_sliding_ = false;
  bool is_compressing_ = true;
  bool has_compression_ = false;
  CollisionPoint compression_;
  double p_compression_ = 0;  ///< p of the first compression.
  double lowest_work_ = 0;
  std::string phases_;
};

}  // namespace rigor
