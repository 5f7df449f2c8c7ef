#include "rigor/bulk/passing/passing_guard.hpp"

#include "rigor/bulk/passing/passing_limits.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/distance/thickness.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

/// Length of the vector that a row of a MotionRecord begins with.
float length_of(const float* a) {
  const FloatRow row = load_row(a), squares = row * row;
  return std::sqrt(squares[0] + squares[1] + squares[2]);
}

}  // namespace

PassingGuard::PassingGuard(const Model& model, int substeps)
    : model_(&model),
      substeps_(substeps),
      filter_(model),
      ranges_(at(model.body_count())),
      turning_(at(model.body_count()), 0),
      is_driven_(at(model.body_count()), 0),
      islands_(model),
      shares_(at(model.body_count()), 1.0),
      changes_(at(model.body_count()), 0) {
  std::optional<FloatHulls> hulls;
  for (int i = 0; i < model.body_count(); ++i) add_body(i, hulls);
  find_groups();
}

void PassingGuard::change(const ChangedBodies& changed) {
  std::optional<FloatHulls> hulls;
  for (const int body : changed.bodies) {
    set_filter(body);
    add_body(body, hulls);
  }
  islands_.change(*model_, changed);
  if (!changed.are_ties_new) return;
  filter_.set_excluded(*model_);
  find_groups();
}

/// Adds the shapes of a body. hulls: those of shapes that are new, made where they are needed.
void PassingGuard::add_body(int body, std::optional<FloatHulls>& hulls) {
  const Body& own = model_->body(body);
  ranges_.give(body, static_cast<int>(own.shapes.size()));
  facts_.resize(std::max(facts_.size(), ranges_.size()));
  // The thinnest solids and surfaces of all bodies decide whether any pair of a step can be far.
  double turning = 0;
  for (std::size_t s = 0; s < own.shapes.size(); ++s) {
    const ShapeFacts& facts = facts_of(own, s, hulls);
    facts_[at(ranges_.begin(body)) + s] = facts;
    turning = std::max(turning, facts.turning);
    if (facts.ball_inside < 0) {
      ++surfaces_;
      thinnest_surface_ = std::min(thinnest_surface_, facts.thickness);
    } else {
      least_thickness_ = std::min({least_thickness_, facts.thickness, facts.ball_inside});
    }
  }
  if (surfaces_ > 1) least_thickness_ = std::min(least_thickness_, thinnest_surface_);
  // The box about all of them.
  std::optional<Aabb> box_B;
  for (const BodyShape& shape : own.shapes) {
    const Aabb of_shape = axis_aligned_box(shape.shape, shape.X_BS);
    box_B = box_B ? box_B->united(of_shape) : of_shape;
  }
  boxes_.set_body(body, box_B);
  // A body that is replaced may have begun or ceased to be moved from outside.
  turning_[at(body)] = turning;
  driven_ -= is_driven_[at(body)];
  is_driven_[at(body)] = own.motion == MotionType::kinematic ? 1 : 0;
  driven_ += is_driven_[at(body)];
  may_need_parts_ = may_need_parts_ || has_driven();
}

/// How thick the shape is, and how far from the body's centre a rotation moves points.
const PassingGuard::ShapeFacts& PassingGuard::facts_of(const Body& body, std::size_t s,
                                                       std::optional<FloatHulls>& hulls) {
  const BodyShape& shape = body.shapes[s];
  const auto [known, is_new] = known_.try_emplace(&shape, KnownShape{.owner = body.shapes});
  ShapeFacts& facts = known->second.facts;
  if (!is_new) return facts;
  // Equal facts of a shape are found once, since its thickness is the dear part.
  facts.thickness = thickness_of(shape.shape);
  facts.turning = turning_radius(shape.shape, shape.X_BS, shape.radius);
  if (is_surface(shape.shape)) return facts;
  if (!hulls) hulls.emplace();
  // The ball inside is where the lanes hold the shape on its side of a surface; without a hull it is the
  // shape's thickness.
  const BulkShape bulk = make_bulk_shape(shape, *hulls);
  facts.ball_inside = bulk.hull ? static_cast<double>(bulk.inner_radius()) : facts.thickness;
  const Vec3 center_S = bulk.hull ? Vec3(bulk.hull->center.cast<double>()) : Vec3(Vec3::Zero());
  facts.ball_offset = (shape.X_BS * center_S).norm();
  return facts;
}

void PassingGuard::find_groups() {
  has_jointed_ = !model_->joints().empty();
  may_need_parts_ = has_driven() || has_jointed_;
  // Bodies that joints connect move together.
  jointed_.find(*model_);
}

void PassingGuard::begin(const BulkBodies& bodies, double h) {
  // Without joints nothing is noted, and what was of bodies that joints have held is forgotten.
  paths_.begin(has_jointed_ ? bodies.x.size() : 0, substeps_);
  planned_.resize(bodies.x.size());
  dynamic_ = 0;
  for (int i = 0; i < bodies.count(); ++i) {
    dynamic_ += bodies.is_dynamic(i) ? 1 : 0;
    const MotionRecord& m = bodies.motion[at(i)];
    store_row(static_cast<float>(h) * load_row(m.v), planned_[at(i)].dp);
    store_row(static_cast<float>(h) * load_row(m.w), planned_[at(i)].dr);
  }
}

/// How far a displacement and a rotation vector take points of the body [m], or velocities in a second.
float PassingGuard::reach(int body, const float* linear, const float* angular) const {
  const double turning = turning_[at(body)];
  return length_of(linear) + (turning > 0 ? static_cast<float>(turning) * length_of(angular) : 0);
}

/// Whether the body has gone on an arc that is not near to its chord.
bool PassingGuard::bends(int body, const BulkBodies& bodies) const {
  return paths_.has(body) && norm_of(bodies.motion[at(body)].dr) > most_turn;
}

/// Where the body is after the part t of what it may go of its way.
BodyDisplacement PassingGuard::point_at(int body, double t, const BulkBodies& bodies) const {
  const MotionRecord& m = bodies.motion[at(body)];
  const double share = bodies.is_dynamic(body) ? shares_[at(jointed_.groups()[at(body)])] : 1;
  if (bends(body, bodies)) return paths_.point(body, share * t);
  return {share * t * vector_of(m.dp), rotation_exp(share * t * vector_of(m.dr))};
}

/// A leg of its way.
ShapePath PassingGuard::path_between(int body, int shape, double from, double to,
                                     const BulkBodies& bodies) const {
  const BodyDisplacement a = point_at(body, from, bodies), b = point_at(body, to, bodies);
  return {&model_->body(body).shapes[at(shape)],
          {(a.turn * bodies.q[at(body)]).toRotationMatrix(), bodies.x[at(body)] + a.dp},
          b.dp - a.dp,
          rotation_log(b.turn * a.turn.conjugate()),
          turning_[at(body)],
          thickness(body, shape)};
}

/// From leg to leg of either way.
FreePath PassingGuard::free_share_of_bent(const FarPair& pair, const BulkBodies& bodies) const {
  // The bends of both ways: the ends of substeps, as parts of the way that the body may go.
  std::vector<double> times = {0, 1};
  for (const int body : {pair.body_A, pair.body_B}) {
    if (!bends(body, bodies)) continue;
    for (int k = 1; k < substeps_; ++k)
      times.push_back(k / (substeps_ * shares_[at(jointed_.groups()[at(body)])]));
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  // Between two of them both bodies go straight.
  std::vector<PathSegment> legs;
  for (std::size_t k = 0; times[k] < 1; ++k) {
    legs.push_back({path_between(pair.body_A, pair.shape_A, times[k], times[k + 1], bodies),
                    path_between(pair.body_B, pair.shape_B, times[k], times[k + 1], bodies)});
    // Relative to the first body, as far from the origin as near it.
    legs.back().A.X_WB.p -= bodies.x[at(pair.body_A)];
    legs.back().B.X_WB.p -= bodies.x[at(pair.body_A)];
  }
  // The number of free legs becomes a part of the step again.
  const FreePath gone = free_segments(legs, deep_share, pair.normal_W);
  const std::size_t last = std::min(static_cast<std::size_t>(gone.part), legs.size() - 1);
  const double into_last = gone.part - static_cast<double>(last);
  return {times[last] + into_last * (times[last + 1] - times[last]), gone.overlap};
}

FreePath PassingGuard::free_share(const FarPair& pair, const BulkBodies& bodies) const {
  if (!may_meet(pair.body_A, pair.body_B, bodies)) return {1};
  const auto shape_of = [&](int body, int shape) {
    const MotionRecord& m = bodies.motion[at(body)];
    const double share = bodies.is_dynamic(body) ? shares_[at(jointed_.groups()[at(body)])] : 1;
    return ShapePath{&model_->body(body).shapes[at(shape)],
                     {bodies.q[at(body)].toRotationMatrix(), bodies.x[at(body)] - bodies.x[at(pair.body_A)]},
                     share * vector_of(m.dp),
                     share * vector_of(m.dr),
                     turning_[at(body)],
                     thickness(body, shape)};
  };
  if (bends(pair.body_A, bodies) || bends(pair.body_B, bodies)) return free_share_of_bent(pair, bodies);
  return free_path(shape_of(pair.body_A, pair.shape_A), shape_of(pair.body_B, pair.shape_B), deep_share,
                   pair.normal_W);
}

/// Takes over how far a pair may go; returns whether that is less than before.
bool PassingGuard::shorten(const FarPair& pair, BulkBodies& bodies) {
  if (!(pair.share < 1)) return false;
  if (pair.overlaps) jams_.push_back({pair.body_A, pair.body_B, pair.share});
  for (const auto& [body, other] : {std::pair{pair.body_A, pair.body_B}, {pair.body_B, pair.body_A}}) {
    if (!bodies.is_dynamic(body)) continue;
    const std::size_t group = at(jointed_.groups()[at(body)]);
    ++changes_[group];
    if (is_taken_along(body, other, bodies)) {
      take_along(body, other, pair.share, bodies);
    } else {
      shares_[group] *= pair.share;
    }
  }
  return true;
}

/// Whether a body without joints goes on with a driven one that it meets.
bool PassingGuard::is_taken_along(int body, int driver, const BulkBodies& bodies) const {
  return bodies.is_dynamic(body) && !jointed_.contains(body) && !bodies.is_dynamic(driver) &&
         bodies.has_velocity(driver);
}

/// The body goes this share of its way, and the rest of the step with the driven body as one with it.
void PassingGuard::take_along(int body, int driver, double share, BulkBodies& bodies) {
  MotionRecord& own = bodies.motion[at(body)];
  const MotionRecord& of_driver = bodies.motion[at(driver)];
  double& own_share = shares_[at(jointed_.groups()[at(body)])];
  // Where they are when they meet, from where the body began.
  const Vec3 dp = share * own_share * vector_of(own.dp), dr = share * own_share * vector_of(own.dr);
  const Vec3 path = vector_of(of_driver.dp), turn = vector_of(of_driver.dr);
  const Vec3 arm = dp - (bodies.x[at(driver)] - bodies.x[at(body)] + share * path);
  const Quat rest = rotation_exp((1 - share) * turn);
  // The whole way of the body.
  const Vec3 end = dp + (1 - share) * path + rest * arm - arm, turned = rotation_log(rest * rotation_exp(dr));
  for (int k = 0; k < 3; ++k) {
    own.dp[k] = static_cast<float>(end[k]);
    own.dr[k] = static_cast<float>(turned[k]);
  }
  own_share = 1;
}

const std::vector<PassingGuard::Stopped>& PassingGuard::stop(const std::vector<ShapePair>& pairs,
                                                             const ManifoldList& manifolds, double margin,
                                                             const Executor& executor, BulkBodies& bodies) {
  constexpr int most_rounds = 8, most_rounds_of_rest = 64;
  stopped_.clear();
  jams_.clear();
  std::fill(shares_.begin(), shares_.end(), 1.0);
  find_far(pairs, manifolds, margin, bodies);
  if (far_.empty()) return stopped_;

  // A body that stops earlier may meet others: pairs are examined until none has to go less far. In the last
  // rounds bodies stop where they began: who goes nowhere meets nobody but those that follow.
  std::vector<int> before;
  for (int round = 0; round < most_rounds + most_rounds_of_rest; ++round) {
    const auto is_known = [&](const FarPair& pair) {
      const auto changed = [&](int body) {
        const std::size_t k = at(jointed_.groups()[at(body)]);
        return !before.empty() && before[k] != changes_[k];
      };
      return pair.is_checked && !changed(pair.body_A) && !changed(pair.body_B);
    };
    executor.for_ranges(static_cast<int>(far_.size()), 1, [&](int begin, int end) {
      for (int k = begin; k < end; ++k) {
        FarPair& pair = far_[at(k)];
        const bool is_old = is_known(pair);
        const FreePath free = is_old ? FreePath{1} : free_share(pair, bodies);
        pair.share = free.part;
        pair.overlaps = free.overlap;
        pair.is_checked = true;
      }
    });
    before = changes_;
    bool is_done = true;
    for (FarPair& pair : far_) {
      if (round + 1 >= most_rounds && pair.share < 1) pair.share = 0;
      if (shorten(pair, bodies)) is_done = false;
    }
    if (is_done) break;
    add_followers(pairs, before, manifolds, bodies);
  }

  for (int i = 0; i < bodies.count(); ++i) {
    const double share = shares_[at(jointed_.groups()[at(i)])];
    if (!bodies.is_dynamic(i) || share == 1) continue;
    MotionRecord& motion = bodies.motion[at(i)];
    // Joints hold on the ways that the substeps have taken, and not on their chords.
    const BodyDisplacement end = paths_.has(i)
                                     ? paths_.point(i, share)
                                     : BodyDisplacement{share * vector_of(motion.dp), Quat::Identity()};
    const Vec3 turn = paths_.has(i) ? rotation_log(end.turn) : Vec3(share * vector_of(motion.dr));
    for (int k = 0; k < 3; ++k) {
      motion.dp[k] = static_cast<float>(end.dp[k]);
      motion.dr[k] = static_cast<float>(turn[k]);
    }
    stopped_.push_back({i, share});
  }
  return stopped_;
}

}  // namespace rigor
