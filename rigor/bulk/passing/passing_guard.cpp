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
#include <numeric>
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
    const ShapeFacts& facts = facts_of(own.shapes[s], hulls);
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
  // A body that is replaced may have begun or ceased to be moved from outside.
  turning_[at(body)] = turning;
  driven_ -= is_driven_[at(body)];
  is_driven_[at(body)] = own.motion == MotionType::kinematic ? 1 : 0;
  driven_ += is_driven_[at(body)];
  may_need_parts_ = may_need_parts_ || has_driven();
}

/// How thick the shape is, and how far from the body's centre a rotation moves points.
const PassingGuard::ShapeFacts& PassingGuard::facts_of(const BodyShape& shape,
                                                       std::optional<FloatHulls>& hulls) {
  const auto [known, is_new] = known_.emplace(&shape, ShapeFacts{});
  ShapeFacts& facts = known->second;
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
  is_jointed_.assign(turning_.size(), 0);
  group_.resize(turning_.size());
  std::iota(group_.begin(), group_.end(), 0);
  const auto root_of = [&](int body) {
    while (group_[at(body)] != body) body = group_[at(body)];
    return body;
  };
  for (int j = 0; j < static_cast<int>(model_->joints().size()); ++j) {
    int first = -1;
    for (const int body : model_->bodies_of_joint(j)) {
      if (model_->body(body).motion != MotionType::dynamic) continue;
      is_jointed_[at(body)] = 1;
      // The lower root stands for both groups, so that the numbers do not depend on the order of joints.
      if (first < 0) first = body;
      const int a = root_of(first), b = root_of(body);
      group_[at(std::max(a, b))] = std::min(a, b);
    }
  }
  // From now on each body knows its root itself.
  for (int i = 0; i < model_->body_count(); ++i) group_[at(i)] = root_of(i);
}

void PassingGuard::begin(const BulkBodies& bodies, double h) {
  if (has_jointed_) paths_.begin(bodies.x.size(), substeps_);
  expected_.resize(bodies.x.size());
  for (int i = 0; i < bodies.count(); ++i) {
    const MotionRecord& m = bodies.motion[at(i)];
    expected_[at(i)] = static_cast<float>(h) * reach(i, m.v, m.w);
  }
}

/// How far a displacement and a rotation vector take points of the body [m], or velocities in a second.
float PassingGuard::reach(int body, const float* linear, const float* angular) const {
  const double turning = turning_[at(body)];
  return length_of(linear) + (turning > 0 ? static_cast<float>(turning) * length_of(angular) : 0);
}

/// How thick a pair is: the thinner of two solids; what touches a surface, however thin that is, since it is
/// held on the side on which the ball inside it is.
double PassingGuard::thinner(const ShapePair& pair) const {
  const double ball_A = facts(pair.body_A, pair.shape_A).ball_inside,
               ball_B = facts(pair.body_B, pair.shape_B).ball_inside;
  if ((ball_A < 0) != (ball_B < 0)) return std::max(ball_A, ball_B);
  return std::min(thickness(pair.body_A, pair.shape_A), thickness(pair.body_B, pair.shape_B));
}

/// Whether the middle of a ball inside one of the shapes goes nowhere near the other, a surface that does not
/// turn: then it is on the same side in the end.
bool PassingGuard::keeps_off_surface(const ShapePair& pair, const BulkBodies& bodies) const {
  const ShapeFacts &a = facts(pair.body_A, pair.shape_A), &b = facts(pair.body_B, pair.shape_B);
  const bool is_A = a.ball_inside < 0;
  if (is_A == (b.ball_inside < 0)) return false;
  const int ground = is_A ? pair.body_A : pair.body_B, other = is_A ? pair.body_B : pair.body_A;
  const MotionRecord &of_ground = bodies.motion[at(ground)], &of_other = bodies.motion[at(other)];
  if (!vector_of(of_ground.dr).isZero(0)) return false;
  // The way of the ball's centre in the frame of the surface; it turns about that of the body.
  const BodyShape& surface = model_->body(ground).shapes[at(is_A ? pair.shape_A : pair.shape_B)];
  const Mesh& mesh = std::get<Mesh>(surface.shape);
  const Pose X_OM = Pose{bodies.q[at(ground)].toRotationMatrix(), Vec3::Zero()} * surface.X_BS;
  const Vec3 from = X_OM.R.transpose() * (bodies.x[at(other)] - bodies.x[at(ground)] - X_OM.p),
             to = from + X_OM.R.transpose() * (vector_of(of_other.dp) - vector_of(of_ground.dp));
  const ShapeFacts& ball = is_A ? b : a;
  const Aabb path{from.cwiseMin(to), from.cwiseMax(to)};
  return mesh.tree->overlapping(path.grown(near_share * ball.ball_inside + ball.ball_offset)).empty();
}

/// How far points move against each other of a body that is wide and turns, and of another that is near a
/// place on it and may go along with it: where the other is, and about as far around as it reaches [m].
double PassingGuard::path_on(int body, int other, const BulkBodies& bodies) const {
  const MotionRecord &own = bodies.motion[at(body)], &of_other = bodies.motion[at(other)];
  const Vec3 r = bodies.x[at(other)] - bodies.x[at(body)], turn = vector_of(own.dr);
  const double angle = turn.norm();
  return (vector_of(own.dp) + turn.cross(r) - vector_of(of_other.dp)).norm() +
         angle * (model_->body(other).bounding_radius + 0.5 * angle * r.norm()) +
         turning_[at(other)] * norm_of(of_other.dr);
}

/// Whether the bodies have moved so far against each other that their contacts could not be foreseen.
bool PassingGuard::is_far(const ShapePair& pair, const BulkBodies& bodies) const {
  const MotionRecord &A = bodies.motion[at(pair.body_A)], &B = bodies.motion[at(pair.body_B)];
  double path = (vector_of(A.dp) - vector_of(B.dp)).norm() + turning_[at(pair.body_A)] * norm_of(A.dr) +
                turning_[at(pair.body_B)] * norm_of(B.dr);
  if (!(path > near_share * thinner(pair))) return false;
  // A half-space has no radius, and what follows is no number: the path stays.
  path = std::min(path, path_on(pair.body_A, pair.body_B, bodies));
  path = std::min(path, path_on(pair.body_B, pair.body_A, bodies));
  return path > near_share * thinner(pair) && !keeps_off_surface(pair, bodies);
}

void PassingGuard::find_far(const std::vector<ShapePair>& pairs, double margin, const BulkBodies& bodies) {
  far_.clear();
  // Most steps end here: nothing moves far. No pair is far unless its reaches add up to `least`, less a
  // rounding in 32 bits.
  constexpr double rounding = 1e-5;
  const double least = (1 - rounding) * near_share * least_thickness_;
  reach_.resize(bodies.x.size());
  is_finite_ = true;
  float most = 0;
  for (int i = 0; i < bodies.count(); ++i) {
    const MotionRecord& m = bodies.motion[at(i)];
    reach_[at(i)] = reach(i, m.dp, m.dr);
    if (paths_.has(i) && bends(i, bodies)) {
      const std::array<double, 2> lengths = paths_.lengths(i);
      const double path = lengths[0] + turning_[at(i)] * lengths[1];
      reach_[at(i)] = std::max(reach_[at(i)], static_cast<float>(path));
    }
    most = std::max(most, reach_[at(i)]);
    is_finite_ = is_finite_ && std::isfinite(reach_[at(i)]);
  }
  // A motion that has become infinite has no boxes; whoever steps the world sees it and stops.
  if (!is_finite_) return;
  if (2 * static_cast<double>(most) <= least) return;

  // Pairs that were looked for.
  is_examined_.assign(pairs.size(), 0);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const ShapePair& pair = pairs[k];
    if (static_cast<double>(reach_[at(pair.body_A)]) + static_cast<double>(reach_[at(pair.body_B)]) <= least)
      continue;
    if (!is_far(pair, bodies)) continue;
    far_.push_back({pair.body_A, pair.body_B, pair.shape_A, pair.shape_B});
    is_examined_[k] = 1;
  }
  // And those of bodies that contacts and forces have taken beyond where pairs were looked for.
  escaped_.clear();
  for (int i = 0; i < bodies.count(); ++i) {
    const double known = static_cast<double>(expected_[at(i)]) + margin,
                 path = static_cast<double>(reach_[at(i)]);
    if (path + static_cast<double>(most) > least && bodies.is_dynamic(i) && path > known * (1 + 1e-3))
      escaped_.push_back(i);
  }
  if (escaped_.empty()) return;
  sweep_boxes(bodies);
  for (const int body : escaped_) add_escaped(body, bodies);

  // A pair may have been found twice, by each of its bodies or before.
  const auto shapes = [](const FarPair& pair) {
    return std::tie(pair.body_A, pair.body_B, pair.shape_A, pair.shape_B);
  };
  std::sort(far_.begin(), far_.end(),
            [&](const FarPair& a, const FarPair& b) { return shapes(a) < shapes(b); });
  far_.erase(std::unique(far_.begin(), far_.end(),
                         [&](const FarPair& a, const FarPair& b) { return shapes(a) == shapes(b); }),
             far_.end());
}

/// Boxes that bodies do not leave in the step: their centres go straight, and their points are no farther
/// from them than the bounding radius. The tree is kept, and made anew now and then: it gets worse the
/// farther the boxes move.
void PassingGuard::sweep_boxes(const BulkBodies& bodies) {
  constexpr int refits = 64;
  swept_.clear();
  for (int i = 0; i < bodies.count(); ++i) {
    const Vec3 &x = bodies.x[at(i)], y = x + vector_of(bodies.motion[at(i)].dp);
    Aabb box{x.cwiseMin(y), x.cwiseMax(y)};
    if (bends(i, bodies)) box = {x + paths_.box(i).lower, x + paths_.box(i).upper};
    swept_.push_back(box.grown(model_->body(i).bounding_radius));
  }
  if (sweeps_++ % refits != 0) return swept_tree_.refit(swept_);
  std::vector<BoxItem> items;
  items.reserve(swept_.size());
  for (int i = 0; i < bodies.count(); ++i) items.push_back({i, swept_[at(i)]});
  swept_tree_.build(items);
}

void PassingGuard::add_escaped(int body, const BulkBodies& bodies) {
  swept_tree_.overlapping(swept_[at(body)], near_);
  for (const int other : near_) {
    if (other == body || !filter_.may_collide(body, other)) continue;
    const int a = std::min(body, other), b = std::max(body, other);
    if (may_touch_ && !may_touch_(a, b)) continue;
    for (int i = 0; i < static_cast<int>(model_->body(a).shapes.size()); ++i) {
      for (int k = 0; k < static_cast<int>(model_->body(b).shapes.size()); ++k) {
        if (is_far({a, b, i, k, 0}, bodies)) far_.push_back({a, b, i, k});
      }
    }
  }
}

/// Whether the body has gone on an arc that is not near to its chord.
bool PassingGuard::bends(int body, const BulkBodies& bodies) const {
  return paths_.has(body) && norm_of(bodies.motion[at(body)].dr) > most_turn;
}

/// Where the body is after the part t of what it may go of its way.
BodyDisplacement PassingGuard::point_at(int body, double t, const BulkBodies& bodies) const {
  const MotionRecord& m = bodies.motion[at(body)];
  const double share = bodies.is_dynamic(body) ? shares_[at(group_[at(body)])] : 1;
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
FreePath PassingGuard::free_share_of_bent(const FarPair& pair, double deep_share,
                                          const BulkBodies& bodies) const {
  // The bends of both ways: the ends of substeps, as parts of the way that the body may go.
  std::vector<double> times = {0, 1};
  for (const int body : {pair.body_A, pair.body_B}) {
    if (!bends(body, bodies)) continue;
    for (int k = 1; k < substeps_; ++k) times.push_back(k / (substeps_ * shares_[at(group_[at(body)])]));
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
  const FreePath gone = free_segments(legs, deep_share);
  const std::size_t last = std::min(static_cast<std::size_t>(gone.part), legs.size() - 1);
  const double into_last = gone.part - static_cast<double>(last);
  return {times[last] + into_last * (times[last + 1] - times[last]), gone.overlap};
}

FreePath PassingGuard::free_share(const FarPair& pair, const BulkBodies& bodies) const {
  const auto shape_of = [&](int body, int shape) {
    const MotionRecord& m = bodies.motion[at(body)];
    const double share = bodies.is_dynamic(body) ? shares_[at(group_[at(body)])] : 1;
    return ShapePath{&model_->body(body).shapes[at(shape)],
                     {bodies.q[at(body)].toRotationMatrix(), bodies.x[at(body)] - bodies.x[at(pair.body_A)]},
                     share * vector_of(m.dp),
                     share * vector_of(m.dr),
                     turning_[at(body)],
                     thickness(body, shape)};
  };
  // A pair may go deeper by the springs of its contacts before it is out of what an audit allows.
  constexpr double deep_share = 0.15;
  if (bends(pair.body_A, bodies) || bends(pair.body_B, bodies))
    return free_share_of_bent(pair, deep_share, bodies);
  return free_path(shape_of(pair.body_A, pair.shape_A), shape_of(pair.body_B, pair.shape_B), deep_share);
}

/// Takes over how far a pair may go; returns whether that is less than before.
bool PassingGuard::shorten(const FarPair& pair, BulkBodies& bodies) {
  if (!(pair.share < 1)) return false;
  if (pair.overlaps) jams_.push_back({pair.body_A, pair.body_B, pair.share});
  for (const auto& [body, other] : {std::pair{pair.body_A, pair.body_B}, {pair.body_B, pair.body_A}}) {
    if (!bodies.is_dynamic(body)) continue;
    const std::size_t group = at(group_[at(body)]);
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
  return bodies.is_dynamic(body) && is_jointed_[at(body)] == 0 && !bodies.is_dynamic(driver) &&
         bodies.has_velocity(driver);
}

/// The body goes this share of its way, and the rest of the step with the driven body as one with it.
void PassingGuard::take_along(int body, int driver, double share, BulkBodies& bodies) {
  MotionRecord& own = bodies.motion[at(body)];
  const MotionRecord& of_driver = bodies.motion[at(driver)];
  double& own_share = shares_[at(group_[at(body)])];
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

/// Adds the pairs of which one body has been stopped since `before` and the other goes on: contacts do not
/// know of it, so that what moves as fast as a body that is stopped would go into it, a little in each step.
void PassingGuard::add_followers(const std::vector<ShapePair>& pairs, const std::vector<int>& before,
                                 const BulkBodies& bodies) {
  constexpr double share_of_thickness = 0.05;
  const auto is_new = [&](int body) {
    return before[at(group_[at(body)])] != changes_[at(group_[at(body)])];
  };
  const auto share_of = [&](int body) { return bodies.is_dynamic(body) ? shares_[at(group_[at(body)])] : 1; };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const ShapePair& pair = pairs[k];
    if (is_examined_[k] != 0 || !(is_new(pair.body_A) || is_new(pair.body_B))) continue;
    const double share_A = share_of(pair.body_A), share_B = share_of(pair.body_B);
    if (share_A == share_B) continue;
    const Vec3 path = share_A * vector_of(bodies.motion[at(pair.body_A)].dp) -
                      share_B * vector_of(bodies.motion[at(pair.body_B)].dp);
    if (path.norm() <= share_of_thickness * thinner(pair)) continue;
    far_.push_back({pair.body_A, pair.body_B, pair.shape_A, pair.shape_B});
    is_examined_[k] = 1;
  }
}

const std::vector<PassingGuard::Stopped>& PassingGuard::stop(const std::vector<ShapePair>& pairs,
                                                             double margin, const Executor& executor,
                                                             BulkBodies& bodies) {
  constexpr int most_rounds = 8, most_rounds_of_rest = 64;
  stopped_.clear();
  jams_.clear();
  find_far(pairs, margin, bodies);
  if (far_.empty()) return stopped_;

  // A body that stops earlier may meet others: pairs are examined until none has to go less far. In the last
  // rounds bodies stop where they began: who goes nowhere meets nobody but those that follow.
  std::fill(shares_.begin(), shares_.end(), 1.0);
  std::vector<int> before;
  for (int round = 0; round < most_rounds + most_rounds_of_rest; ++round) {
    const auto is_known = [&](const FarPair& pair) {
      const auto changed = [&](int body) {
        const std::size_t k = at(group_[at(body)]);
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
    add_followers(pairs, before, bodies);
  }

  for (int i = 0; i < bodies.count(); ++i) {
    const double share = shares_[at(group_[at(i)])];
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
