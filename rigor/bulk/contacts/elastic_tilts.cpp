#include "rigor/bulk/contacts/elastic_tilts.hpp"

#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rigor {

namespace {

/// A body stands on another if the normal between them is no farther from the vertical than 60 degrees.
constexpr float least_upright = 0.5F;
/// Fewer points are no face.
constexpr int least_points = 3;
/// Points span a face if the determinant of their moments is at least this part of the cube of the trace:
/// that of a face of the breadth b and the length l is about (b/l)²/8.
constexpr float least_spread = 1e-4F;
/// Arms are turned back by so many times the tilts, so that the weight straightens what leans.
constexpr float overshoot = 2;
/// The tilts that count are those so many steps from now, which damps what they swing.
constexpr float steps_ahead = 3;
/// Bodies whose energy of rotation, m r² w², is this part of what lifts them by their radius r have half of
/// their tilts: what moves faster does not stand.
constexpr double standing_part = 2e-5;

float dot3(const float* a, const float* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A symmetric matrix of floats.
struct Moments {
  float xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  void add(float weight, const FloatRow& a) {
    xx += weight * a[0] * a[0], yy += weight * a[1] * a[1], zz += weight * a[2] * a[2];
    xy += weight * a[0] * a[1], xz += weight * a[0] * a[2], yz += weight * a[1] * a[2];
  }
  float trace() const { return xx + yy + zz; }
};

float determinant_of(const Moments& m) {
  return m.xx * (m.yy * m.zz - m.yz * m.yz) + m.xy * (m.xz * m.yz - m.xy * m.zz) +
         m.xz * (m.xy * m.yz - m.xz * m.yy);
}

/// The solution of M x = b by Cramer's rule, times the determinant of M.
FloatRow solve_moments(const Moments& m, const FloatRow& b) {
  const FloatRow x = {m.yy * m.zz - m.yz * m.yz, m.xz * m.yz - m.xy * m.zz, m.xy * m.yz - m.xz * m.yy, 0};
  const FloatRow y = {x[1], m.xx * m.zz - m.xz * m.xz, m.xy * m.xz - m.xx * m.yz, 0};
  const FloatRow z = {x[2], y[2], m.xx * m.yy - m.xy * m.xy, 0};
  return b[0] * x + b[1] * y + b[2] * z;
}

/// The rotation of B against A by the overlaps of the points, and their sum: the slope of the plane through
/// them by least squares. Zero if the points span no face or do not overlap.
TiltRow tilt_of(const ManifoldView& manifold) {
  // The means of the points and of their overlaps; those that are apart overlap by nothing.
  const float per_count = 1 / static_cast<float>(manifold.point_count);
  FloatRow centre = {};
  float overlap = 0;
  for (int k = 0; k < manifold.point_count; ++k) {
    const ManifoldPoint& point = manifold.points[k];
    centre += per_count * FloatRow{point.p[0], point.p[1], point.p[2], 0};
    overlap -= std::min(point.gap, 0.0F);
  }
  if (!(overlap > 0)) return {};

  // A rotation θ opens the gap at p by θ · a, a = p × n: the least squares are Σ a aᵀ θ = Σ a gap. All a are
  // perpendicular to n, and so is θ; n nᵀ makes the matrix regular.
  const FloatRow n = {manifold.normal[0], manifold.normal[1], manifold.normal[2], 0};
  Moments moments;
  FloatRow sum = {};
  for (int k = 0; k < manifold.point_count; ++k) {
    const ManifoldPoint& point = manifold.points[k];
    const FloatRow a = cross(FloatRow{point.p[0], point.p[1], point.p[2], 0} - centre, n);
    moments.add(1, a);
    sum += (std::min(point.gap, 0.0F) + per_count * overlap) * a;
  }
  moments.add(moments.trace(), n);
  const float trace = moments.trace(), determinant = determinant_of(moments);
  if (!(determinant > least_spread * trace * trace * trace)) return {};
  FloatRow tilt = solve_moments(moments, sum) / determinant;
  tilt[3] = overlap;
  TiltRow row;
  store_row(tilt, row.data());
  return row;
}

}  // namespace

ElasticTilts::ElasticTilts(const Model& model) {
  set_gravity(model);
}

void ElasticTilts::set_gravity(const Model& model) {
  gravity_ = model.g_W().norm();
  slow_.clear();
  if (!(gravity_ > 0)) return;
  for (int k = 0; k < 3; ++k) up_[at(k)] = static_cast<float>(-model.g_W()[k] / gravity_);
  slow_.resize(model.bodies().size());
  for (int i = 0; i < model.body_count(); ++i) set_body(model, i);
}

void ElasticTilts::set_body(const Model& model, int body) {
  if (slow_.empty()) return;
  // What is not dynamic never leans; a half-space has no radius.
  const Body& own = model.body(body);
  const double radius = own.motion == MotionType::dynamic ? own.bounding_radius : 0;
  slow_[at(body)] = static_cast<float>(radius / (standing_part * gravity_));
}

void ElasticTilts::find(const StepManifolds& manifolds, double h, const Executor& executor,
                        BulkBodies& bodies) {
  bodies.tilts.clear();
  if (slow_.empty()) return;
  // Balls lean on nothing, however many they are.
  bool may_support = false;
  for (std::size_t i = 0; i < manifolds.size() && !may_support; ++i)
    may_support = manifolds.point_count(i) >= least_points;
  if (!may_support) return;
  renew(manifolds.size(), supports_);
  const float ahead = steps_ahead * static_cast<float>(h);
  executor.for_ranges(static_cast<int>(manifolds.size()), 256, [&](int begin, int end) {
    for (std::size_t i = at(begin); i < at(end); ++i) supports_[i] = support_of(manifolds, i, ahead, bodies);
  });
  if (!list_by_lower(bodies.x.size())) return;
  bodies.tilts.assign(bodies.x.size(), {});
  add_up(bodies.tilts);
  for (std::size_t i = 0; i < bodies.tilts.size(); ++i) {
    const float* const w = bodies.motion[i].w;
    const FloatRow tilt = load_row(bodies.tilts[i].data());
    store_row(overshoot / (1 + slow_[i] * dot3(w, w)) * tilt, bodies.tilts[i].data());
  }
}

/// The support that a manifold is; ahead [s]: how far from now.
ElasticTilts::Support ElasticTilts::support_of(const StepManifolds& manifolds, std::size_t i, float ahead,
                                               const BulkBodies& bodies) const {
  Support support;
  if (manifolds.point_count(i) < least_points) return support;
  const ManifoldView manifold = manifolds.view(i);
  const float upright = dot3(manifold.normal, up_.data());
  if (!(std::abs(upright) > least_upright)) return support;
  const int a = manifolds.body_A(i), b = manifolds.body_B(i);
  support.upper = upright > 0 ? b : a;
  support.lower = upright > 0 ? a : b;
  if (!bodies.is_dynamic(support.upper)) return support;

  // The tilt of B against A, and how fast it grows: their rotation but for that about the normal.
  const TiltRow tilt = tilt_of(manifold);
  const FloatRow w = load_row(bodies.motion[at(b)].w) - load_row(bodies.motion[at(a)].w);
  const FloatRow n = {manifold.normal[0], manifold.normal[1], manifold.normal[2], 0};
  const float spin = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
  FloatRow turn = load_row(tilt.data()) + ahead * (w - spin * n);
  if (!(upright > 0)) turn = -turn;
  turn[3] = tilt[3];
  store_row(turn, support.turn.data());
  return support;
}

/// Lists the supports by their lower bodies; whether there are any.
bool ElasticTilts::list_by_lower(std::size_t body_count) {
  first_.assign(body_count + 1, 0);
  pending_.assign(body_count, 0);
  for (const Support& support : supports_) {
    if (!support.is_there()) continue;
    ++first_[at(support.lower)];
    ++pending_[at(support.upper)];
  }
  // Where the supports of each body end; they are put in from behind.
  for (std::size_t i = 0; i < body_count; ++i) first_[i + 1] += first_[i];
  above_.resize(at(first_[body_count]));
  for (std::size_t i = supports_.size(); i-- > 0;) {
    if (supports_[i].is_there()) above_[at(--first_[at(supports_[i].lower)])] = static_cast<int>(i);
  }
  return !above_.empty();
}

/// From the ground upwards (Kahn, Topological sorting of large networks, Comm. ACM 5(11), 1962): a body has
/// the mean of the tilts of what it stands on, and of its own there, by their overlaps. Bodies that stand on
/// each other in a ring have none.
void ElasticTilts::add_up(std::vector<TiltRow>& tilts) {
  known_.clear();
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (pending_[i] == 0) known_.push_back(static_cast<int>(i));
  }
  for (std::size_t k = 0; k < known_.size(); ++k) {
    // All supports of this body are known: the mean of what they gave it.
    const std::size_t lower = at(known_[k]);
    FloatRow tilt = load_row(tilts[lower].data());
    tilt = tilt[3] > 0 ? tilt / tilt[3] : FloatRow{};
    tilt[3] = 0;
    store_row(tilt, tilts[lower].data());
    // What stands on it.
    for (int j = first_[lower]; j < first_[lower + 1]; ++j) {
      const Support& support = supports_[at(above_[at(j)])];
      const FloatRow turn = load_row(support.turn.data());
      FloatRow share = turn[3] * (tilt + turn);
      share[3] = turn[3];
      float* const sum = tilts[at(support.upper)].data();
      store_row(load_row(sum) + share, sum);
      if (--pending_[at(support.upper)] == 0) known_.push_back(support.upper);
    }
  }
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (pending_[i] > 0) tilts[i] = {};
  }
}

}  // namespace rigor
