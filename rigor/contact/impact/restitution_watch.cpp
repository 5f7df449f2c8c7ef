#include "rigor/contact/impact/restitution_watch.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

std::optional<double> RestitutionWatch::follow(const ImpactPiece& piece, PiecePoint a, const PiecePoint& b) {
  while (true) {
    if (const std::optional<double> end = end_by_impulse(piece, a, b)) return end;
    if (is_compressing_) {
      if (!(b.at.u_n >= 0)) return std::nullopt;
      const double z = piece.where(ImpactQuantity::u_n, 0, a, b);
      begin_restitution(piece, z);
      if (e_ == 0) return z;
      a = {z, piece.normal(z)};
      continue;
    }
    // Restitution ends, or u_n falls back to zero first.
    PiecePoint limit = b;
    const bool falls_back = b.at.u_n < 0;
    if (falls_back) {
      const double z = piece.where(ImpactQuantity::u_n, 0, a, b);
      limit = {z, piece.normal(z)};
    }
    if (const std::optional<double> end = end_by_motion(piece, a, limit)) return end;
    if (!falls_back) return std::nullopt;
    is_compressing_ = true;
    phases_ += 'r';
    a = limit;
  }
}

void RestitutionWatch::set_end(ImpactState& state) const {
  if (law_ == RestitutionLaw::newton || e_ == 0) state.u.z() = std::abs(u_n_target_);
}

void RestitutionWatch::note(char phase) {
  phases_ += phase;
  is_sliding_ = phase == 'S';
}

bool RestitutionWatch::leave_limit(ImpactState& state) {
  state.p = state.work = 0;
  compression_.work = lowest_work_ = 0;
  p_compression_ = 0;
  return !is_compressing_ && law_ != RestitutionLaw::newton;
}

void RestitutionWatch::begin_restitution(const ImpactPiece& piece, double z) {
  const ImpactState state = piece.state(z);
  if (!has_compression_) {
    has_compression_ = true;
    compression_ = {state.u, state.lambda, state.work};
    p_compression_ = state.p - start_.p;
    lowest_work_ = state.work;
  }
  // Compressed again: the lowest work counts.
  lowest_work_ = std::min(lowest_work_, state.work);
  is_compressing_ = false;
  phases_ += '|';
  if (is_sliding_ && e_ > 0) phases_ += 'S';
}

std::optional<double> RestitutionWatch::end_by_impulse(const ImpactPiece& piece, const PiecePoint& a,
                                                       const PiecePoint& b) const {
  if (law_ != RestitutionLaw::poisson || !has_compression_) return std::nullopt;
  const double target = start_.p + (1 + e_) * p_compression_;
  if (b.at.p < target) return std::nullopt;
  return piece.where(ImpactQuantity::p, target, a, b);
}

std::optional<double> RestitutionWatch::end_by_motion(const ImpactPiece& piece, const PiecePoint& a,
                                                      const PiecePoint& b) const {
  if (law_ == RestitutionLaw::poisson) return std::nullopt;
  const bool is_newton = law_ == RestitutionLaw::newton;
  const ImpactQuantity quantity = is_newton ? ImpactQuantity::u_n : ImpactQuantity::work;
  const double target = is_newton ? u_n_target_ : (1 - e_ * e_) * lowest_work_;
  if (value_of(b.at, quantity) < target) return std::nullopt;
  return piece.where(quantity, target, a, b);
}

}  // namespace rigor
