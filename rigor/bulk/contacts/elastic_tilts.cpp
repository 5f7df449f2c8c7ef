#include "rigor/bulk/contacts/elastic_tilts.hpp"

#include "rigor/bulk/contacts/tilt_kernels.hpp"
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
    find_supports(manifolds, at(begin), at(end), ahead, bodies);
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

/// Who stands on whom by the manifolds [begin, end), and their turns, eight at a time; ahead [s]: how far
/// from now.
void ElasticTilts::find_supports(const StepManifolds& manifolds, std::size_t begin, std::size_t end,
                                 float ahead, const BulkBodies& bodies) {
  TiltLanes lanes;
  std::array<std::size_t, kLaneCount> numbers{};
  std::array<TiltRow, kLaneCount> turns;
  std::size_t count = 0;
  const auto find_turns_of_lanes = [&] {
    // Lanes left over repeat the first.
    for (std::size_t k = count; k < kLaneCount; ++k) {
      lanes.manifold[k] = lanes.manifold[0];
      lanes.w_A[k] = lanes.w_A[0], lanes.w_B[k] = lanes.w_B[0], lanes.sign[k] = lanes.sign[0];
    }
    target_ == LaneTarget::avx2 ? avx2_lanes::find_turns(lanes, ahead, turns)
                                : portable_lanes::find_turns(lanes, ahead, turns);
    for (std::size_t k = 0; k < count; ++k) supports_[numbers[k]].turn = turns[k];
    count = 0;
  };
  for (std::size_t i = begin; i < end; ++i) {
    Support& support = supports_[i] = {};
    if (manifolds.point_count(i) < least_points) continue;
    const ManifoldView manifold = manifolds.view(i);
    const float upright = dot3(manifold.normal, up_.data());
    if (!(std::abs(upright) > least_upright)) continue;
    const int a = manifolds.body_A(i), b = manifolds.body_B(i);
    support.upper = upright > 0 ? b : a;
    support.lower = upright > 0 ? a : b;
    if (!bodies.is_dynamic(support.upper)) continue;
    lanes.manifold[count] = manifold;
    lanes.w_A[count] = bodies.motion[at(a)].w;
    lanes.w_B[count] = bodies.motion[at(b)].w;
    lanes.sign[count] = upright > 0 ? 1 : -1;
    numbers[count++] = i;
    if (count == kLaneCount) find_turns_of_lanes();
  }
  if (count > 0) find_turns_of_lanes();
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
