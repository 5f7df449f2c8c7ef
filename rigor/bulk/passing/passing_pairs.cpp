// Which pairs the passing guard examines: those that have moved far against each other.

#include "rigor/bulk/passing/passing_guard.hpp"
#include "rigor/bulk/passing/passing_limits.hpp"
#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <tuple>

namespace rigor {

namespace {

constexpr auto shapes_in_order = [](const auto& a, const auto& b) {
  return std::tie(a.body_A, a.body_B, a.shape_A, a.shape_B) <
         std::tie(b.body_A, b.body_B, b.shape_A, b.shape_B);
};
constexpr auto are_same_shapes = [](const auto& a, const auto& b) {
  return std::tie(a.body_A, a.body_B, a.shape_A, a.shape_B) ==
         std::tie(b.body_A, b.body_B, b.shape_A, b.shape_B);
};

/// Erases those that are known; both lists are in order.
template <class Pair>
void erase_known(const std::vector<Pair>& known, std::vector<ShapePair>& found) {
  auto next = known.begin();
  std::erase_if(found, [&](const ShapePair& pair) {
    while (next != known.end() && shapes_in_order(*next, pair)) ++next;
    return next != known.end() && are_same_shapes(*next, pair);
  });
}

}  // namespace

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

/// Whether the bodies have moved by more than `least` [m] against each other.
bool PassingGuard::is_far(const ShapePair& pair, double least, const BulkBodies& bodies) const {
  const MotionRecord &A = bodies.motion[at(pair.body_A)], &B = bodies.motion[at(pair.body_B)];
  double path = (vector_of(A.dp) - vector_of(B.dp)).norm() + turning_[at(pair.body_A)] * norm_of(A.dr) +
                turning_[at(pair.body_B)] * norm_of(B.dr);
  if (!(path > least)) return false;
  // A half-space has no radius, and what follows is no number: the path stays.
  path = std::min(path, path_on(pair.body_A, pair.body_B, bodies));
  path = std::min(path, path_on(pair.body_B, pair.body_A, bodies));
  return path > least && !keeps_off_surface(pair, bodies);
}

/// How far a body may go now.
BodyBoxes::Way PassingGuard::way_of(int body, const BulkBodies& bodies) const {
  const MotionRecord& m = bodies.motion[at(body)];
  const double share = share_of(body, bodies);
  return {share * vector_of(m.dp), share * turning_[at(body)] * norm_of(m.dr)};
}

/// Whether the balls and the boxes about two bodies come to overlap as far as these may go now.
bool PassingGuard::may_meet(int a, int b, const BulkBodies& bodies) const {
  if (bends(a, bodies) || bends(b, bodies)) return true;
  const BodyBoxes::Way of_a = way_of(a, bodies), of_b = way_of(b, bodies);
  const Vec3 from = bodies.x[at(b)] - bodies.x[at(a)], path = of_b.dp_W - of_a.dp_W;
  const double squared = path.squaredNorm();
  const double nearest = squared > 0 ? std::clamp(-from.dot(path) / squared, 0.0, 1.0) : 0;
  const double radii = model_->body(a).bounding_radius + model_->body(b).bounding_radius;
  return (from + nearest * path).norm() <= radii && !boxes_.are_parted(bodies, a, b, of_a, of_b);
}

/// Finds how far points of each body have moved; returns the most of all [m].
float PassingGuard::find_reaches(const BulkBodies& bodies) {
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
  return most;
}

/// Finds where and how deep the pairs touched at the beginning; returns the deepest of all [m].
float PassingGuard::find_contacts(std::size_t pairs, const ManifoldList& manifolds) {
  depths_.assign(pairs, 0);
  contacts_.assign(pairs, -1);
  float deepest = 0;
  for (std::size_t k = 0; k < manifolds.size(); ++k) {
    const ManifoldView manifold = manifolds.view(k);
    contacts_[at(manifolds.pair(k))] = static_cast<int>(k);
    float& depth = depths_[at(manifolds.pair(k))];
    for (int i = 0; i < manifold.point_count; ++i) depth = std::max(depth, -manifold.points[i].gap);
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

/// Finds the islands that driven bodies touch which move.
void PassingGuard::find_pushed(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
                               const BulkBodies& bodies) {
  is_pushed_.clear();
  const auto moves = [&](int body) { return is_driven_[at(body)] != 0 && bodies.has_velocity(body); };
  bool is_any = false;
  for (int i = 0; i < bodies.count() && has_driven() && !is_any; ++i) is_any = moves(i);
  if (!is_any) return;
  // Bodies that touch each other, or that joints and springs hold together.
  struct Contacts {
    const std::vector<ShapePair>& pairs;
    const ManifoldList& manifolds;
    std::size_t size() const { return manifolds.size(); }
    int body_A(std::size_t i) const { return pairs[at(manifolds.pair(i))].body_A; }
    int body_B(std::size_t i) const { return pairs[at(manifolds.pair(i))].body_B; }
  };
  const Contacts contacts{pairs, manifolds};
  islands_.build(contacts);
  // What a driven body touches tells its island.
  is_pushed_.assign(bodies.x.size(), 0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const int a = contacts.body_A(i), b = contacts.body_B(i);
    if (moves(a) && bodies.is_dynamic(b)) is_pushed_[at(islands_.island_of(b))] = 1;
    if (moves(b) && bodies.is_dynamic(a)) is_pushed_[at(islands_.island_of(a))] = 1;
  }
}

/// Whether what moves as it must touches the island of a pair.
bool PassingGuard::is_pushed(const ShapePair& pair) const {
  if (is_pushed_.empty()) return false;
  const auto is_one = [&](int body) {
    const int island = islands_.island_of(body);
    return island >= 0 && is_pushed_[at(island)] != 0;
  };
  return is_one(pair.body_A) || is_one(pair.body_B);
}

void PassingGuard::find_far(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds, double margin,
                            const BulkBodies& bodies) {
  far_.clear();
  is_swept_ = false;
  const double most = static_cast<double>(find_reaches(bodies));
  // A motion that has become infinite has no boxes; whoever steps the world sees it and stops.
  if (!is_finite_) return;
  // Most steps end here: nothing moves far. No pair is far unless its reaches add up to `least`, less a
  // rounding in 32 bits.
  constexpr double rounding = 1e-5;
  const double thinnest = (1 - rounding) * least_thickness_;
  if (2 * most <= least_share * thinnest) return;

  // A pair that overlaps already may go less far unseen, so that it does not get deeper from step to step;
  // but what is stopped for that does not get out of the way of what drives its island.
  constexpr double share_of_depth = 2;
  const auto unseen = [&](double thickness, double depth) {
    return std::max(least_share * thickness, near_share * thickness - share_of_depth * depth);
  };
  const double deepest = static_cast<double>(find_contacts(pairs.size(), manifolds));
  if (2 * most > unseen(thinnest, deepest)) {
    find_pushed(pairs, manifolds, bodies);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const ShapePair& pair = pairs[k];
      const double depth = is_pushed(pair) ? 0 : static_cast<double>(depths_[k]),
                   reach_A = static_cast<double>(reach_[at(pair.body_A)]),
                   reach_B = static_cast<double>(reach_[at(pair.body_B)]);
      if (reach_A + reach_B <= unseen(thinnest, depth)) continue;
      if (is_far(pair, unseen(thinner(pair), depth), bodies))
        far_.push_back({pair.body_A, pair.body_B, pair.shape_A, pair.shape_B, normal_of(k, manifolds)});
    }
  }
  add_escaped(pairs, margin, most, bodies);
}

/// Adds the pairs of bodies that contacts and forces have taken beyond where pairs were looked for, `margin`
/// [m] around where both were to go. They have no contact that holds them.
void PassingGuard::add_escaped(const std::vector<ShapePair>& pairs, double margin, double most,
                               const BulkBodies& bodies) {
  // One of two bodies that meet unforeseen, and get as deep as matters, has left its path by half of that.
  // The thinnest of all bodies, also of those that are gone, decides only who is asked.
  const auto least_off = [&](double thickness) { return 0.5 * (margin + near_share * thickness); };
  const double least = deep_share * least_thickness_;
  if (2 * most <= least) return;
  for (int i = 0; i < bodies.count(); ++i) {
    if (!bodies.is_dynamic(i) || static_cast<double>(reach_[at(i)]) + most <= least) continue;
    const MotionRecord& m = bodies.motion[at(i)];
    Plan off;
    store_row(load_row(m.dp) - load_row(planned_[at(i)].dp), off.dp);
    store_row(load_row(m.dr) - load_row(planned_[at(i)].dr), off.dr);
    const double off_path = static_cast<double>(reach(i, off.dp, off.dr));
    if (off_path <= least_off(least_thickness_)) continue;
    sweep_boxes(bodies);
    for_near(i, [&](const ShapePair& pair) {
      if (off_path > least_off(thinner(pair)) && may_meet(pair.body_A, pair.body_B, bodies))
        found_.push_back(pair);
    });
  }
  sort_found();
  erase_known(pairs, found_);
  std::erase_if(found_,
                [&](const ShapePair& pair) { return !is_far(pair, deep_share * thinner(pair), bodies); });
  add_found([](const ShapePair&) -> Vec3 { return Vec3::Zero(); });
}

/// Adds the pairs of which one body has been stopped since `before` and the other goes on: contacts do not
/// know of it, so that what moves as fast as a body that is stopped would go into it, a little in each step.
void PassingGuard::add_followers(const std::vector<ShapePair>& pairs, const std::vector<int>& before,
                                 const ManifoldList& manifolds, const BulkBodies& bodies) {
  for (int i = 0; i < bodies.count(); ++i) {
    const std::size_t group = at(jointed_.groups()[at(i)]);
    if (!bodies.is_dynamic(i) || before[group] == changes_[group]) continue;
    sweep_boxes(bodies);
    for_near(i, [&](const ShapePair& pair) {
      const double share_A = share_of(pair.body_A, bodies), share_B = share_of(pair.body_B, bodies);
      if (share_A == share_B) return;
      // A driven body may turn about a place far away.
      const auto path_of = [&](int body, int other) -> Vec3 {
        const MotionRecord& m = bodies.motion[at(body)];
        if (is_driven_[at(body)] == 0) return share_of(body, bodies) * vector_of(m.dp);
        return vector_of(m.dp) + vector_of(m.dr).cross(bodies.x[at(other)] - bodies.x[at(body)]);
      };
      const Vec3 path = path_of(pair.body_A, pair.body_B) - path_of(pair.body_B, pair.body_A);
      if (path.norm() <= least_share * thinner(pair) || !may_meet(pair.body_A, pair.body_B, bodies)) return;
      // A driven body was to be met where pairs were looked for.
      const bool has_driven = is_driven_[at(pair.body_A)] + is_driven_[at(pair.body_B)] > 0;
      if (!has_driven || std::binary_search(pairs.begin(), pairs.end(), pair, shapes_in_order))
        found_.push_back(pair);
    });
  }
  sort_found();
  add_found([&](const ShapePair& pair) -> Vec3 {
    const auto known = std::lower_bound(pairs.begin(), pairs.end(), pair, shapes_in_order);
    const bool is_known = known != pairs.end() && are_same_shapes(*known, pair);
    return is_known ? normal_of(at(known - pairs.begin()), manifolds) : Vec3(Vec3::Zero());
  });
}

/// A pair may have been found by each of its bodies.
void PassingGuard::sort_found() {
  std::sort(found_.begin(), found_.end(), shapes_in_order);
  found_.erase(std::unique(found_.begin(), found_.end(), are_same_shapes), found_.end());
}

/// What is known of a pair that was found before stays. normal_of(pair): see FarPair::normal_W.
template <class NormalOf>
void PassingGuard::add_found(const NormalOf& normal_of) {
  erase_known(far_, found_);
  const std::ptrdiff_t known = std::ssize(far_);
  for (const ShapePair& pair : found_)
    far_.push_back({pair.body_A, pair.body_B, pair.shape_A, pair.shape_B, normal_of(pair)});
  std::inplace_merge(far_.begin(), far_.begin() + known, far_.end(), shapes_in_order);
  found_.clear();
}

/// Normal of the contact that a pair which was looked for had at the beginning; zero: it had none.
Vec3 PassingGuard::normal_of(std::size_t pair, const ManifoldList& manifolds) const {
  const int contact = contacts_[pair];
  return contact < 0 ? Vec3(Vec3::Zero()) : vector_of(manifolds.view(at(contact)).normal).normalized();
}

/// Boxes that bodies do not leave in the step: their centres go straight, and their points are no farther
/// from them than the bounding radius, nor from where they were than rotations move them. The tree is kept,
/// and made anew now and then: it gets worse the farther the boxes move.
void PassingGuard::sweep_boxes(const BulkBodies& bodies) {
  if (is_swept_) return;
  is_swept_ = true;
  constexpr int refits = 64;
  swept_.clear();
  swept_.reserve(bodies.x.size());
  // The origin is the position of a body that moves, so that a scene far away takes no longer.
  int first = 0;
  while (first + 1 < bodies.count() && !bodies.moves(first)) ++first;
  const Vec3 origin = bodies.x[at(first)];
  double size = 0;
  int bounded = 0;
  for (int i = 0; i < bodies.count(); ++i) {
    const MotionRecord& motion = bodies.motion[at(i)];
    const Vec3 &x = bodies.x[at(i)], y = x + vector_of(motion.dp);
    Aabb box{x.cwiseMin(y), x.cwiseMax(y)};
    if (bends(i, bodies)) box = {x + paths_.box(i).lower, x + paths_.box(i).upper};
    const double radius = model_->body(i).bounding_radius;
    box = box.grown(radius);
    if (radius > 0 && std::isfinite(radius)) size += 2 * radius, ++bounded;
    // Long bodies are far thinner than the balls about them.
    const std::optional<Aabb> tight =
        bends(i, bodies) ? std::nullopt
                         : boxes_.swept(bodies, i, {y - x, turning_[at(i)] * norm_of(motion.dr)});
    if (tight) box = {box.lower.cwiseMax(x + tight->lower), box.upper.cwiseMin(x + tight->upper)};
    swept_.push_back(enclosing_box(box, origin));
  }
  if (sweeps_++ % refits != 0) return swept_tree_.refit(swept_);
  swept_tree_.build(swept_, bounded > 0 ? static_cast<float>(size / bounded) : 1);
}

/// Calls visit(pair) for all shapes of a body and of those whose swept boxes overlap its own, where they may
/// touch.
template <class Visit>
void PassingGuard::for_near(int body, const Visit& visit) {
  near_.clear();
  swept_tree_.find_overlaps(swept_[at(body)], near_);
  for (const int other : near_) {
    if (other == body || !filter_.may_collide(body, other)) continue;
    const int a = std::min(body, other), b = std::max(body, other);
    if (may_touch_ && !may_touch_(a, b)) continue;
    for (int i = 0; i < static_cast<int>(model_->body(a).shapes.size()); ++i) {
      for (int k = 0; k < static_cast<int>(model_->body(b).shapes.size()); ++k)
        visit(ShapePair{a, b, i, k, 0});
    }
  }
}

}  // namespace rigor
