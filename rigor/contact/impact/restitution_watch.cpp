#include "rigor/contact/impact/restitution_watch.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

std::optional<double> RestitutionWatch::follow(const ImpactPiece& piece, PiecePoint a, const PiecePoint& b) {
  while (true) {
    // A law that counts impulse can end the impact at any time after the first compression.
    if (const std::optional<double> end = end_by_impulse(piece, a, b)) return end;

    // Compression lasts until u_n comes to zero; what is left of the piece is restitution.
    if (is_compressing_) {
      if (!(b.at.u_n >= 0)) return std::nullopt;
      const double z = piece.where(ImpactQuantity::u_n, 0, a, b);
      begin_restitution(piece, z);
      if (e_ == 0) return z;
      a = {z, piece.normal(z)};
      continue;
    }

    // Restitution ends where the law says, unless u_n falls back to zero first.
    PiecePoint limit = b;
    const bool falls_back = b.at.u_n < 0;
    if (falls_back) {
      const double z = piece.where(ImpactQuantity::u_n, 0, a, b);
      limit = {z, piece.normal(z)};
    }
    if (const std::optional<double> end = end_by_motion(piece, a, limit)) return end;
    if (!falls_back) return std::nullopt;

    // The bodies approach again: a further compression begins on the rest of the piece.
    is_compressing_ = true;
    phases_ += 'r';
    a = limit;
  }
}

void RestitutionWatch::set_end(ImpactState& state) const {
  if (e_ == 0)
    state.u.z() = 0;
  else if (end().quantity == ImpactQuantity::u_n)
    state.u.z() = std::abs(end().value);
}

void RestitutionWatch::note(char phase) {
  phases_ += phase;
  is_sliding_ = phase == 'S';
}

bool RestitutionWatch::leave_limit(ImpactState& state) {
  // All that happened so far took no normal impulse and did no work (docs/theory/impact.md): a law that
  // counts one of them has nothing to give back once compression is over.
  state.p = state.work = 0;
  compression_.work = record_.work = 0;
  record_.p = 0;
  return !is_compressing_ && end().quantity != ImpactQuantity::u_n;
}

void RestitutionWatch::begin_restitution(const ImpactPiece& piece, double z) {
  const ImpactState state = piece.state(z);
  if (!has_compression_) {
    has_compression_ = true;
    compression_ = {state.u, state.lambda, state.work};
    record_.p = state.p - record_.p_before;
    record_.work = state.work;
  }
  // After a further compression the lowest work counts.
  record_.work = std::min(record_.work, state.work);
  is_compressing_ = false;
  phases_ += '|';
  if (is_sliding_ && e_ > 0) phases_ += 'S';
}

std::optional<double> RestitutionWatch::end_by_impulse(const ImpactPiece& piece, const PiecePoint& a,
                                                       const PiecePoint& b) const {
  if (!has_compression_) return std::nullopt;
  const auto [quantity, target] = end();
  if (quantity != ImpactQuantity::p || b.at.p < target) return std::nullopt;
  return piece.where(quantity, target, a, b);
}

std::optional<double> RestitutionWatch::end_by_motion(const ImpactPiece& piece, const PiecePoint& a,
                                                      const PiecePoint& b) const {
  const auto [quantity, target] = end();
  if (quantity == ImpactQuantity::p || value_of(b.at, quantity) < target) return std::nullopt;
  return piece.where(quantity, target, a, b);
}

}  // namespace rigor
