#include "rigor/bulk/narrow_phase/narrow_phase.hpp"

#include "rigor/bulk/narrow_phase/collide_balls.hpp"
#include "rigor/bulk/narrow_phase/collide_boxes.hpp"
#include "rigor/bulk/narrow_phase/collide_exactly.hpp"
#include "rigor/bulk/narrow_phase/collide_mesh.hpp"
#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/bulk/narrow_phase/collide_round.hpp"
#include "rigor/bulk/narrow_phase/ellipsoid_pairs.hpp"
#include "rigor/bulk/narrow_phase/mesh_inside.hpp"
#include "rigor/bulk/narrow_phase/pair_hints.hpp"
#include "rigor/bulk/narrow_phase/placed_forms.hpp"
#include "rigor/bulk/narrow_phase/plane_manifolds.hpp"
#include "rigor/bulk/narrow_phase/ring_pairs.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace rigor {

namespace {

using Kind = BulkShape::Kind;

constexpr int kBlock = PairHints::block;  ///< Pairs that are put into lanes together.
constexpr int kPartGrain = 256;           ///< Pairs of a part, which has its own lists.
constexpr float kRounding = kCollisionRounding;

/// A pair of shapes, placed.
struct PairPlace {
  PlacedForm a, b;
  Vec3f d;                   ///< From the centre of body A to that of body B [m].
  PairHint* hint = nullptr;  ///< If it has one.
};

/// The pairs of a block that are of one kind, in lanes.
template <class Pairs, class Contacts>
struct LaneList {
  int count = 0;
  std::array<int, kBlock> pairs;  ///< Their numbers.
  std::array<Pairs, kBlock / kLaneCount> lanes;
  std::array<Contacts, kBlock / kLaneCount> contacts;

  int block_count() const { return (count + kLaneCount - 1) / kLaneCount; }
  bool is_next(int place, int pair) const { return place < count && pairs[at(place)] == pair; }
};

/// The working memory of one thread, for one block of pairs at a time.
struct BlockScratch {
  std::array<PairPlace, kBlock> places;
  std::array<bool, kBlock> is_parted;
  LaneList<BoxPairs, BoxContacts> boxes;
  LaneList<BallPairs, BallContacts> balls;
  PlacedPolytopes polytopes;
  MeshMeeting mesh;
  RingMeeting rings;
  EllipsoidMeeting ellipsoids;
};

/// A part of the pairs, and the manifolds found in it.
struct alignas(64) Part {
  BlockScratch scratch;
  ManifoldList manifolds;
  std::size_t begin = 0, begin_of_points = 0;  ///< Index of the first of these among all.
};

/// Whether one of two shapes is a solid of revolution, and the other has a core or is one too.
bool are_ring_pair(const PlacedForm& a, const PlacedForm& b) {
  return bool(a.has_rings | b.has_rings) & bool(a.has_core | a.has_rings) & bool(b.has_core | b.has_rings);
}
/// Whether one of two shapes is an ellipsoid, and the other has a core or is one too, or a solid of
/// revolution.
bool are_ellipsoid_pair(const PlacedForm& a, const PlacedForm& b) {
  const bool has_A = bool(a.is_ellipsoid | a.has_core | a.has_rings),
             has_B = bool(b.is_ellipsoid | b.has_core | b.has_rings);
  return bool(a.is_ellipsoid | b.is_ellipsoid) & has_A & has_B;
}
/// Whether one of two shapes is a mesh, and the other is treated against it in 32 bits.
bool is_on_mesh(const PlacedForm& a, const PlacedForm& b) {
  return (a.kind == Kind::mesh && b.is_convex()) || (b.kind == Kind::mesh && a.is_convex());
}
SupportCore core_of(const BulkShape& shape, const PlacedShape& placed) {
  return {shape.hull ? shape.hull->vertices() : LaneColumns{}, &placed, shape.scale};
}

}  // namespace

struct NarrowPhase::Tables {
  explicit Tables(const Model& model) : shapes(model) {}

  const BulkShape& form(const PlacedForm& shape) const { return shapes.form(shape); }
  const PlacedShape& place_of(const PlacedForm& shape) const { return shapes.place_of(shape); }
  /// Whether the search for the pair's contacts begins where the last one ended.
  bool needs_hint(const ShapePair& pair) const;
  /// Adds the manifolds of the pairs [begin, end) in their order.
  void find(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, int begin, int end,
            BlockScratch& scratch, ManifoldList& manifolds);
  void sort_block(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, int begin, int end,
                  BlockScratch& scratch);
  /// Whether the direction of the pair's hint still separates the shapes.
  bool is_parted(const PairPlace& place, float margin) const;
  void add_boxes(const PairPlace& place, int number, float margin,
                 LaneList<BoxPairs, BoxContacts>& boxes) const;
  void add_balls(const PairPlace& place, int number, LaneList<BallPairs, BallContacts>& balls) const;
  void find_boxes(const PairPlace& place, int lane_place, int number, float margin, BlockScratch& scratch,
                  ManifoldList& manifolds);
  void find_pair(const BulkBodies& bodies, const ShapePair& pair, const PairPlace& place, int number,
                 BlockScratch& scratch, ManifoldList& manifolds);
  void find_mesh(const BulkBodies& bodies, const ShapePair& pair, const PairPlace& place, int number,
                 MeshMeeting& meeting, ManifoldList& manifolds);
  void find_polytopes(const PairPlace& place, int number, float margin, PlacedPolytopes& polytopes,
                      ManifoldList& manifolds);

  PlacedForms shapes;
  PairHints hints;
  std::vector<std::unique_ptr<Part>> parts;
};

bool NarrowPhase::Tables::needs_hint(const ShapePair& pair) const {
  const PlacedForm &a = shapes.of(pair.body_A, pair.shape_A), &b = shapes.of(pair.body_B, pair.shape_B);
  return ((a.has_faces | b.has_faces) & a.has_core & b.has_core) || is_on_mesh(a, b) || are_ring_pair(a, b) ||
         are_ellipsoid_pair(a, b);
}

namespace {

Pose pose_of(const BulkShape& shape, const Quat& q_WB, const Vec3& p_OB) {
  return Pose{q_WB.toRotationMatrix(), p_OB} * shape.X_BS;
}

/// Adds the manifold of the candidates; false if there are none.
bool add_manifold(const std::optional<Vec3f>& n, int number, PlacedPolytopes& pair, ManifoldList& manifolds,
                  int part = 0) {
  if (!n || pair.candidates.empty()) return false;
  manifolds.push_back({number, part, make_manifold(*n, pair.equal_depth, pair.candidates)});
  return true;
}

/// What is as near as this touches [m]: more than rounding, and less than soft contacts overlap.
float touching(const BulkShape& a, const BulkShape& b) {
  constexpr float share = 1e-3f;
  return share * std::min(a.size, b.size);
}

}  // namespace

/// Any two shapes that are not collided in lanes.
void NarrowPhase::Tables::find_pair(const BulkBodies& bodies, const ShapePair& pair, const PairPlace& place,
                                    int number, BlockScratch& scratch, ManifoldList& manifolds) {
  PlacedPolytopes& polytopes = scratch.polytopes;
  const BulkShape &a = form(place.a), &b = form(place.b);
  const PlacedShape &placed_A = place_of(place.a), &placed_B = place_of(place.b);
  const auto is_exact = [](Kind kind) { return kind == Kind::other || kind == Kind::mesh; };
  if (is_on_mesh(place.a, place.b)) return find_mesh(bodies, pair, place, number, scratch.mesh, manifolds);
  const bool is_other = is_exact(a.kind) || is_exact(b.kind);
  const bool has_plane = a.kind == Kind::plane || b.kind == Kind::plane;
  const bool is_ring_pair = are_ring_pair(place.a, place.b),
             is_ellipsoid_pair = are_ellipsoid_pair(place.a, place.b);
  const RingPair round{a, placed_A, b, placed_B, place.d, pair.margin};
  polytopes.candidates.clear();
  // Rings and ellipsoids, where it is clear how they touch.
  if (is_ring_pair && scratch.rings.find(round, number, *place.hint, manifolds)) return;
  if (is_ellipsoid_pair && scratch.ellipsoids.find(round, number, *place.hint, manifolds)) return;
  // Planes and shapes without a core need the poses in 64 bits.
  if (is_other || has_plane || is_ring_pair || is_ellipsoid_pair) {
    const Vec3 p_OB = bodies.x[at(pair.body_B)] - bodies.x[at(pair.body_A)];
    const Pose X_OA = pose_of(a, bodies.q[at(pair.body_A)], Vec3::Zero());
    const Pose X_OB = pose_of(b, bodies.q[at(pair.body_B)], p_OB);
    if (is_other || is_ring_pair || is_ellipsoid_pair)
      add_exact_manifolds(*a.shape, X_OA, *b.shape, X_OB, touching(a, b), pair.margin, number, manifolds);
    else if (a.kind == Kind::plane)
      add_plane_manifold({a, X_OA, b, placed_B, p_OB, true, pair.margin}, number, polytopes.candidates,
                         manifolds);
    else
      add_plane_manifold({b, X_OB, a, placed_A, p_OB, false, pair.margin}, number, polytopes.candidates,
                         manifolds);
    return;
  }
  // Cores with faces are searched for the axis of largest separation; spheres and capsules are segments.
  if (a.kind != Kind::round || b.kind != Kind::round)
    return find_polytopes(place, number, pair.margin, polytopes, manifolds);
  const std::optional<Vec3f> n =
      find_round_candidates({a, placed_A}, {b, placed_B}, place.d, pair.margin, polytopes.candidates);
  polytopes.equal_depth = kRounding * (a.extent + b.extent + place.d.norm());
  add_manifold(n, number, polytopes, manifolds);
}

/// A mesh, and a convex shape.
void NarrowPhase::Tables::find_mesh(const BulkBodies& bodies, const ShapePair& pair, const PairPlace& place,
                                    int number, MeshMeeting& meeting, ManifoldList& manifolds) {
  const bool mesh_is_A = place.a.kind == Kind::mesh;
  const int mesh_body = mesh_is_A ? pair.body_A : pair.body_B,
            core_body = mesh_is_A ? pair.body_B : pair.body_A;
  const BulkShape &mesh = form(mesh_is_A ? place.a : place.b), &core = form(mesh_is_A ? place.b : place.a);
  const PlacedShape& placed_core = place_of(mesh_is_A ? place.b : place.a);
  // Where the core's body is in the frame of the mesh, in 64 bits.
  const Pose X_OM = pose_of(mesh, bodies.q[at(mesh_body)], Vec3::Zero());
  const Vec3 d = bodies.x[at(core_body)] - bodies.x[at(mesh_body)];
  const MeshView view{mesh.mesh.get(), X_OM.R.transpose().cast<float>(), X_OM.R.transpose() * (d - X_OM.p)};
  meeting.find(view, core, placed_core, pair.margin, *shapes.hulls().segment);
  const BulkShape &a = form(place.a), &b = form(place.b);
  const Vec3 p_OB = bodies.x[at(pair.body_B)] - bodies.x[at(pair.body_A)];
  const auto add_exactly = [&] {
    add_exact_manifolds(*a.shape, pose_of(a, bodies.q[at(pair.body_A)], Vec3::Zero()), *b.shape,
                        pose_of(b, bodies.q[at(pair.body_B)], p_OB), touching(a, b), pair.margin, number,
                        manifolds);
  };
  if (!meeting.is_clear()) return add_exactly();
  // From the frame of the mesh to W's axes, relative to body A.
  const Mat3f R_WM = view.R_MW.transpose();
  const Vec3f shift = mesh_is_A ? d.cast<float>() : Vec3f(Vec3f::Zero());
  for (std::size_t k = 0; k < meeting.count(); ++k) {
    MeshContacts& contacts = meeting.contacts(k);
    for (ManifoldCandidate& candidate : contacts.candidates) candidate.p = R_WM * candidate.p + shift;
    const Vec3f n = R_WM * contacts.n_M;
    manifolds.push_back(
        {number, static_cast<int>(k),
         make_manifold(mesh_is_A ? n : Vec3f(-n), meeting.equal_depth(), contacts.candidates)});
  }
  // What is inside a closed mesh is shown the way out.
  if (meeting.count() > 0 || !meeting.may_be_inside() ||
      !is_inside(std::get<Mesh>(*mesh.shape), view.c_M, *place.hint))
    return;
  add_exactly();
}

void NarrowPhase::Tables::find_polytopes(const PairPlace& place, int number, float margin,
                                         PlacedPolytopes& polytopes, ManifoldList& manifolds) {
  const BulkShape &a = form(place.a), &b = form(place.b);
  PairHint& hint = *place.hint;
  place_polytopes(a, place_of(place.a), b, place_of(place.b), place.d, polytopes);
  // Apart: a direction that separated the pair in the step before is tried first.
  AxisGuess guess{hint.n, hint.axis};
  if (guess.n.isZero(0)) guess.n = polytopes.b.center - polytopes.a.center;
  const float limit = margin + a.radius + b.radius + parting_slack(polytopes.rounding);
  if (guess.axis == 0 && find_parting_direction(polytopes, limit, guess.n)) {
    hint.n = guess.n;
    return;
  }
  // The search begins at the axis of the step before, and what it finds is the hint for the next.
  SeparatingAxis axis;
  const std::optional<Vec3f> n = find_polytope_candidates(polytopes, margin, guess, axis);
  const bool is_touching = add_manifold(n, number, polytopes, manifolds);
  if (is_touching) add_manifold(find_contacts_beside(polytopes, margin), number, polytopes, manifolds, 1);
  hint = {axis.n, is_touching ? code_of(axis) : 0};
}

bool NarrowPhase::Tables::is_parted(const PairPlace& place, float margin) const {
  if (!place.hint || place.hint->axis != 0 || place.hint->n.isZero(0)) return false;
  if (place.a.kind == Kind::mesh || place.b.kind == Kind::mesh) return false;
  const BulkShape &a = form(place.a), &b = form(place.b);
  // Pairs are passed over only where the separation exceeds the margin by far more than the rounding, so that
  // they have no points by any computation.
  const float rounding = kRounding * (a.extent + b.extent + place.d.lpNorm<1>());
  if (place.a.has_rings | place.b.has_rings | place.a.is_ellipsoid | place.b.is_ellipsoid)
    return separation_of({a, place_of(place.a), b, place_of(place.b), place.d, margin}, place.hint->n) >
           margin + parting_slack(rounding);
  const Vec3f d = place.d + place_of(place.b).position() - place_of(place.a).position();
  return find_separation(core_of(a, place_of(place.a)), core_of(b, place_of(place.b)), d, place.hint->n,
                         best_lane_target()) > margin + a.radius + b.radius + parting_slack(rounding);
}

void NarrowPhase::Tables::add_boxes(const PairPlace& place, int number, float margin,
                                    LaneList<BoxPairs, BoxContacts>& boxes) const {
  boxes.lanes[at(boxes.count / kLaneCount)].pair[boxes.count % kLaneCount] = {
      &place_of(place.a), &place_of(place.b), {place.d.x(), place.d.y(), place.d.z()}, margin};
  boxes.pairs[at(boxes.count++)] = number;
}

void NarrowPhase::Tables::add_balls(const PairPlace& place, int number,
                                    LaneList<BallPairs, BallContacts>& balls) const {
  const int lane = balls.count % kLaneCount;
  BallPairs& lanes = balls.lanes[at(balls.count / kLaneCount)];
  balls.pairs[at(balls.count++)] = number;
  const PlacedShape &a = place_of(place.a), &b = place_of(place.b);
  // The first pair of a block fills all of its lanes, so that lanes left over hold numbers.
  for (int k = lane; k < (lane == 0 ? kLaneCount : lane + 1); ++k) {
    for (int c = 0; c < 3; ++c) {
      lanes.p[c][k] = a.p[c];
      lanes.d[c][k] = place.d[c] + b.p[c] - a.p[c];
    }
    lanes.radius_A[k] = form(place.a).radius;
    lanes.radius_B[k] = form(place.b).radius;
  }
}

/// Leaves out the pairs that are known to be apart, puts boxes and balls into lanes and collides them.
void NarrowPhase::Tables::sort_block(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, int begin,
                                     int end, BlockScratch& scratch) {
  // Hints are in the order of pairs: those of the block follow each other here and in the step before.
  int number = hints.first_of(begin / kBlock);
  const int last_number = hints.first_of(begin / kBlock + 1);
  std::size_t before = hints.find_before(pairs[at(begin)]);
  scratch.boxes.count = scratch.balls.count = 0;
  for (int k = begin; k < end; ++k) {
    const ShapePair& pair = pairs[at(k)];
    // Centres are subtracted in 64 bits; the rest is relative to the centre of body A.
    const Vec3 p_OB = bodies.x[at(pair.body_B)] - bodies.x[at(pair.body_A)];
    PairPlace& place = scratch.places[at(k - begin)];
    place = {shapes.of(pair.body_A, pair.shape_A), shapes.of(pair.body_B, pair.shape_B), p_OB.cast<float>(),
             nullptr};
    // The direction of the hint is tried first; most pairs that do not touch end here.
    if (number < last_number && needs_hint(pair)) place.hint = &hints.take_over(pair, number++, before);
    scratch.is_parted[at(k - begin)] = is_parted(place, pair.margin);
    if (scratch.is_parted[at(k - begin)]) continue;
    if (place.a.is_ball && place.b.is_ball) {
      add_balls(place, k, scratch.balls);
    } else if (place.a.kind == Kind::box && place.b.kind == Kind::box) {
      add_boxes(place, k, pair.margin, scratch.boxes);
    }
  }
  // Lanes left over hold the first pair of their block.
  for (int k = scratch.boxes.count; k % kLaneCount != 0; ++k) {
    BoxPairs& last = scratch.boxes.lanes[at(k / kLaneCount)];
    last.pair[k % kLaneCount] = last.pair[0];
  }
  for (int k = 0; k < scratch.boxes.block_count(); ++k)
    collide_boxes(scratch.boxes.lanes[at(k)], best_lane_target(), scratch.boxes.contacts[at(k)]);
  for (int k = 0; k < scratch.balls.block_count(); ++k)
    collide_balls(scratch.balls.lanes[at(k)], best_lane_target(), scratch.balls.contacts[at(k)]);
}

/// Adds the manifolds of a pair of boxes, whose contacts are at a place of the lanes.
void NarrowPhase::Tables::find_boxes(const PairPlace& place, int lane_place, int number, float margin,
                                     BlockScratch& scratch, ManifoldList& manifolds) {
  const BoxPairs& lanes = scratch.boxes.lanes[at(lane_place / kLaneCount)];
  const BoxContacts& contacts = scratch.boxes.contacts[at(lane_place / kLaneCount)];
  const int lane = lane_place % kLaneCount;
  PairHint& hint = *place.hint;
  // Apart: the axis is the hint.
  if (contacts.outcome[lane] == BoxContacts::apart) {
    hint = {box_axis(lanes, contacts, lane), 0};
    return;
  }
  // The point of two edges, the region over a face, or both.
  const std::int32_t outcome = contacts.outcome[lane];
  const bool has_crossing = outcome == BoxContacts::edges || outcome == BoxContacts::edges_and_region;
  const bool has_region = outcome == BoxContacts::region || outcome == BoxContacts::edges_and_region;
  const Manifold& region = contacts.over_face[lane];
  const std::size_t count = manifolds.size();
  bool crosses = false;
  if (has_crossing) {
    Manifold crossing;
    crosses = cross_box_edges(lanes, contacts, lane, crossing);
    if (crosses) manifolds.add(number, 0, crossing);
  }
  if (has_region && (crosses || !has_crossing) && region.point_count > 0)
    manifolds.add(number, crosses ? 1 : 0, region);
  if (manifolds.size() > count) {
    if (hint.axis == 0) hint.axis = 1;  // An unchanged hint is not written: its cache line stays clean.
    return;
  }
  if (outcome == BoxContacts::region) return;
  // The boxes are nearest at an edge or a corner of both: the nearest points of their edges are searched.
  PlacedPolytopes& polytopes = scratch.polytopes;
  const BulkShape &a = form(place.a), &b = form(place.b);
  place_polytopes(a, place_of(place.a), b, place_of(place.b), place.d, polytopes);
  polytopes.candidates.clear();
  hint = {box_axis(lanes, contacts, lane), 0};
  SeparatingAxis axis;
  const float separation = contacts.separation[lane];
  const std::optional<Vec3f> n = separation > 0
                                     ? join_nearest_edges(hint.n, separation, margin, polytopes)
                                     : find_polytope_candidates(polytopes, margin, {hint.n, 0}, axis);
  if (add_manifold(n, number, polytopes, manifolds)) hint.axis = 1;
}

void NarrowPhase::Tables::find(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, int begin,
                               int end, BlockScratch& scratch, ManifoldList& manifolds) {
  scratch.polytopes.shape_A = nullptr;  // No core is placed yet: bodies have moved since the last call.
  for (int first = begin; first < end; first += kBlock) {
    const int last = std::min(end, first + kBlock);
    sort_block(bodies, pairs, first, last, scratch);
    // Manifolds are added in the order of pairs, whether they come from lanes or not.
    int box = 0, ball = 0;
    for (int k = first; k < last; ++k) {
      const ShapePair& pair = pairs[at(k)];
      const PairPlace& place = scratch.places[at(k - first)];
      if (scratch.is_parted[at(k - first)]) continue;
      // The lanes hold the pairs of their kind in the same order.
      if (scratch.boxes.is_next(box, k)) {
        find_boxes(place, box++, k, pair.margin, scratch, manifolds);
      } else if (scratch.balls.is_next(ball, k)) {
        const BallContacts& contacts = scratch.balls.contacts[at(ball / kLaneCount)];
        const int lane = ball++ % kLaneCount;
        if (contacts.gap[lane] <= pair.margin) manifolds.add(k, 0, ball_manifold(contacts, lane));
      } else {
        find_pair(bodies, pair, place, k, scratch, manifolds);
      }
    }
  }
}

NarrowPhase::NarrowPhase(const Model& model) : tables_(std::make_unique<Tables>(model)) {}
NarrowPhase::~NarrowPhase() = default;

void NarrowPhase::set_bodies(const Model& model, std::span<const int> bodies) {
  std::vector<char> has_changed(at(model.body_count()), 0);
  for (const int body : bodies) {
    has_changed[at(body)] = 1;
    tables_->shapes.set_body(model, body);
  }
  tables_->hints.forget(has_changed);
}

void NarrowPhase::find_manifolds(const BulkBodies& bodies, const std::vector<ShapePair>& pairs,
                                 const Executor& executor, ManifoldList& manifolds) {
  // More parts than threads: pairs that touch take longer than others.
  constexpr int parts_of_a_thread = 8;
  Tables& tables = *tables_;
  tables.shapes.place(bodies, pairs, executor);
  const int count = static_cast<int>(pairs.size());
  tables.hints.begin(pairs, [&](const ShapePair& pair) { return tables.needs_hint(pair); });
  // The pairs in parts, each with its own list; a part is made of whole blocks, so that lanes do not depend
  // on the number of parts.
  const int most = executor.threads() == 1 ? 1 : parts_of_a_thread * executor.threads();
  const int part_count = std::clamp(count / kPartGrain, 1, most);
  while (tables.parts.size() < at(part_count)) tables.parts.push_back(std::make_unique<Part>());
  // Whole blocks.
  const int block_count = (count + kBlock - 1) / kBlock;
  const auto begin_of = [&](int k) {
    return std::min(count, kBlock * static_cast<int>(std::int64_t{block_count} * k / part_count));
  };
  if (part_count == 1) {
    manifolds.clear();
    tables.find(bodies, pairs, 0, count, tables.parts[0]->scratch, manifolds);
    return;
  }
  executor.for_ranges(part_count, 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      Part& part = *tables.parts[at(k)];
      part.manifolds.clear();
      tables.find(bodies, pairs, begin_of(k), begin_of(k + 1), part.scratch, part.manifolds);
    }
  });
  // One behind the other, the lists of the parts are in the order of pairs.
  std::size_t total = 0, total_points = 0;
  for (int k = 0; k < part_count; ++k) {
    Part& part = *tables.parts[at(k)];
    part.begin = total;
    part.begin_of_points = total_points;
    total += part.manifolds.size();
    total_points += part.manifolds.all_points();
  }
  manifolds.arrange(total, total_points);
  executor.for_ranges(part_count, 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const Part& part = *tables.parts[at(k)];
      manifolds.put(part.manifolds, part.begin, part.begin_of_points);
    }
  });
}

}  // namespace rigor
