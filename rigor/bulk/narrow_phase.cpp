#include "rigor/bulk/narrow_phase.hpp"

#include "rigor/bulk/bulk_shape.hpp"
#include "rigor/bulk/collide_boxes.hpp"
#include "rigor/bulk/collide_exactly.hpp"
#include "rigor/bulk/collide_polytopes.hpp"
#include "rigor/bulk/collide_round.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

using Kind = BulkShape::Kind;

constexpr int kBlock = 256;        ///< Pairs that one thread takes at a time.
constexpr int kBoxBlock = 128;     ///< Pairs of which those of boxes are put into lanes.
constexpr int kPlaceGrain = 1024;  ///< Shapes.
constexpr float kRounding = kCollisionRounding;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// The box pairs of a block in lanes.
struct BoxBlock {
  int count = 0;
  std::array<int, kBoxBlock> pairs;  ///< Their numbers.
  std::array<BoxPairs, kBoxBlock / kLaneCount> lanes;
  std::array<BoxContacts, kBoxBlock / kLaneCount> contacts;
};

}  // namespace

struct NarrowPhase::Tables {
  explicit Tables(const Model& model);

  int index(int body, int shape) const { return first_shape[at(body)] + shape; }
  void place(const BulkBodies& bodies, const Executor& executor);
  /// Of the pairs [begin, end), added in their order.
  void find(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, int begin, int end,
            std::vector<PairManifold>& manifolds) const;
  void collide_block(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, int begin, int end,
                     BoxBlock& boxes) const;
  /// Of a pair of boxes; false if lanes do not tell.
  bool add_box_manifold(const BoxBlock& boxes, int place, int number,
                        std::vector<PairManifold>& manifolds) const;
  void find_pair(const BulkBodies& bodies, const ShapePair& pair, int number, PolytopeScratch& scratch,
                 std::vector<PairManifold>& manifolds) const;

  FloatHulls hulls;
  std::vector<int> first_shape;  ///< Of each body.
  std::vector<int> body_of;      ///< Of each shape.
  std::vector<BulkShape> shapes;
  std::vector<PlacedShape> placed;
  std::vector<std::vector<PairManifold>> blocks;
};

NarrowPhase::Tables::Tables(const Model& model) {
  for (int i = 0; i < model.body_count(); ++i) {
    first_shape.push_back(static_cast<int>(shapes.size()));
    for (const BodyShape& shape : model.body(i).shapes) {
      shapes.push_back(make_bulk_shape(shape, hulls));
      body_of.push_back(i);
    }
  }
  placed.resize(shapes.size());
}

void NarrowPhase::Tables::place(const BulkBodies& bodies, const Executor& executor) {
  executor.for_ranges(static_cast<int>(shapes.size()), kPlaceGrain, [&](int begin, int end) {
    for (int k = begin; k < end; ++k)
      placed[at(k)] = place_shape(shapes[at(k)], bodies.q[at(body_of[at(k)])]);
  });
}

namespace {

Pose pose_of(const BulkShape& shape, const Quat& q_WB, const Vec3& p_OB) {
  return Pose{q_WB.toRotationMatrix(), p_OB} * shape.X_BS;
}

/// The manifold of a core and a plane; `plane_is_A` tells which is which.
void add_plane_manifold(const BulkShape& plane, const Pose& X_OP, const BulkShape& core,
                        const PlacedShape& placed, const Vec3& p_OB, bool plane_is_A, const ShapePair& pair,
                        int number, std::vector<ManifoldCandidate>& candidates,
                        std::vector<PairManifold>& manifolds) {
  const PlaneView view =
      view_plane(std::get<HalfSpace>(*plane.shape), X_OP, plane_is_A ? p_OB : Vec3::Zero());
  find_plane_candidates(view, core, placed, pair.margin, candidates);
  if (candidates.empty()) return;
  if (plane_is_A)
    for (ManifoldCandidate& candidate : candidates) candidate.p += p_OB.cast<float>();
  const float rounding = kRounding * (std::abs(view.height) + core.extent + core.radius);
  const Vec3f n = plane_is_A ? view.n : Vec3f(-view.n);
  manifolds.push_back({number, 0, make_manifold(n, rounding, candidates)});
}

}  // namespace

void NarrowPhase::Tables::find_pair(const BulkBodies& bodies, const ShapePair& pair, int number,
                                    PolytopeScratch& scratch, std::vector<PairManifold>& manifolds) const {
  const int i = index(pair.body_A, pair.shape_A), j = index(pair.body_B, pair.shape_B);
  const BulkShape &a = shapes[at(i)], &b = shapes[at(j)];
  const Vec3 p_OB = bodies.x[at(pair.body_B)] - bodies.x[at(pair.body_A)];
  const bool is_other = a.kind == Kind::other || b.kind == Kind::other;
  const bool has_plane = a.kind == Kind::plane || b.kind == Kind::plane;
  scratch.candidates.clear();
  if (is_other || has_plane) {
    const Pose X_OA = pose_of(a, bodies.q[at(pair.body_A)], Vec3::Zero());
    const Pose X_OB = pose_of(b, bodies.q[at(pair.body_B)], p_OB);
    if (is_other)
      add_exact_manifolds(*a.shape, X_OA, *b.shape, X_OB, pair.margin, number, manifolds);
    else if (a.kind == Kind::plane)
      add_plane_manifold(a, X_OA, b, placed[at(j)], p_OB, true, pair, number, scratch.candidates, manifolds);
    else
      add_plane_manifold(b, X_OB, a, placed[at(i)], p_OB, false, pair, number, scratch.candidates, manifolds);
    return;
  }
  const Vec3f d = p_OB.cast<float>();
  const float rounding = kRounding * (a.extent + b.extent + d.norm());
  std::optional<Vec3f> n;
  if (a.kind == Kind::round && b.kind == Kind::round) {
    n = find_round_candidates(a, placed[at(i)], b, placed[at(j)], d, pair.margin, scratch.candidates);
  } else {
    place_vertices(a, placed[at(i)], Vec3f::Zero(), scratch.a);
    place_vertices(b, placed[at(j)], d, scratch.b);
    if (are_soon_parted(scratch, pair.margin + a.radius + b.radius)) return;
    place_faces(a, placed[at(i)], Vec3f::Zero(), scratch.a);
    place_faces(b, placed[at(j)], d, scratch.b);
    n = find_polytope_candidates(scratch, pair.margin, rounding);
  }
  if (n && !scratch.candidates.empty())
    manifolds.push_back({number, 0, make_manifold(*n, rounding, scratch.candidates)});
}

void NarrowPhase::Tables::collide_block(const BulkBodies& bodies, const std::vector<ShapePair>& pairs,
                                        int begin, int end, BoxBlock& boxes) const {
  boxes.count = 0;
  for (int k = begin; k < end; ++k) {
    const ShapePair& pair = pairs[at(k)];
    const int i = index(pair.body_A, pair.shape_A), j = index(pair.body_B, pair.shape_B);
    if (shapes[at(i)].kind != Kind::box || shapes[at(j)].kind != Kind::box) continue;
    const int lane = boxes.count % kLaneCount;
    BoxPairs& lanes = boxes.lanes[at(boxes.count / kLaneCount)];
    lanes.a[lane] = &placed[at(i)];
    lanes.b[lane] = &placed[at(j)];
    const Vec3 p_OB = bodies.x[at(pair.body_B)] - bodies.x[at(pair.body_A)];
    for (int c = 0; c < 3; ++c) lanes.d[c][lane] = static_cast<float>(p_OB[c]);
    lanes.margin[lane] = pair.margin;
    boxes.pairs[at(boxes.count++)] = k;
  }
  // Lanes that are left over repeat the last pair.
  for (int k = boxes.count; k % kLaneCount != 0; ++k) {
    BoxPairs& lanes = boxes.lanes[at(k / kLaneCount)];
    const int lane = k % kLaneCount;
    lanes.a[lane] = lanes.a[lane - 1];
    lanes.b[lane] = lanes.b[lane - 1];
    for (int c = 0; c < 3; ++c) lanes.d[c][lane] = lanes.d[c][lane - 1];
    lanes.margin[lane] = lanes.margin[lane - 1];
  }
  for (int k = 0; k < boxes.count; k += kLaneCount)
    collide_boxes(boxes.lanes[at(k / kLaneCount)], best_lane_target(), boxes.contacts[at(k / kLaneCount)]);
}

bool NarrowPhase::Tables::add_box_manifold(const BoxBlock& boxes, int place, int number,
                                           std::vector<PairManifold>& manifolds) const {
  const BoxPairs& lanes = boxes.lanes[at(place / kLaneCount)];
  const BoxContacts& contacts = boxes.contacts[at(place / kLaneCount)];
  const int lane = place % kLaneCount;
  if (contacts.outcome[lane] == BoxContacts::apart) return true;
  if (contacts.outcome[lane] == BoxContacts::near_edge) return false;
  if (contacts.outcome[lane] != BoxContacts::region) {
    PairManifold& crossing = manifolds.emplace_back();
    crossing.pair = number;
    crossing.part = 0;
    if (!cross_box_edges(lanes, contacts, lane, crossing.manifold)) {
      manifolds.pop_back();
      return false;
    }
  }
  if (contacts.outcome[lane] != BoxContacts::edges) {
    PairManifold& region = manifolds.emplace_back();
    region.pair = number;
    region.part = contacts.outcome[lane] == BoxContacts::region ? 0 : 1;
    if (!read_box_region(contacts, lane, lanes.margin[lane], region.manifold)) manifolds.pop_back();
  }
  return true;
}

void NarrowPhase::Tables::find(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, int begin,
                               int end, std::vector<PairManifold>& manifolds) const {
  PolytopeScratch scratch;
  const std::unique_ptr<BoxBlock> boxes = std::make_unique<BoxBlock>();
  for (int first = begin; first < end; first += kBoxBlock) {
    const int last = std::min(end, first + kBoxBlock);
    collide_block(bodies, pairs, first, last, *boxes);
    int place = 0;
    for (int k = first; k < last; ++k) {
      const bool is_in_lanes = place < boxes->count && boxes->pairs[at(place)] == k;
      if (is_in_lanes && add_box_manifold(*boxes, place++, k, manifolds)) continue;
      find_pair(bodies, pairs[at(k)], k, scratch, manifolds);
    }
  }
}

NarrowPhase::NarrowPhase(const Model& model) : tables_(std::make_unique<Tables>(model)) {}
NarrowPhase::~NarrowPhase() = default;

void NarrowPhase::find_manifolds(const BulkBodies& bodies, const std::vector<ShapePair>& pairs,
                                 const Executor& executor, std::vector<PairManifold>& manifolds) {
  Tables& tables = *tables_;
  manifolds.clear();
  tables.place(bodies, executor);
  const int count = static_cast<int>(pairs.size());
  if (executor.threads() == 1) {
    tables.find(bodies, pairs, 0, count, manifolds);
    return;
  }
  // Each block of pairs has its own list; the lists are put one behind the other.
  const int block_count = (count + kBlock - 1) / kBlock;
  if (tables.blocks.size() < at(block_count)) tables.blocks.resize(at(block_count));
  executor.for_ranges(block_count, 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      tables.blocks[at(k)].clear();
      tables.find(bodies, pairs, k * kBlock, std::min(count, (k + 1) * kBlock), tables.blocks[at(k)]);
    }
  });
  for (int k = 0; k < block_count; ++k)
    manifolds.insert(manifolds.end(), tables.blocks[at(k)].begin(), tables.blocks[at(k)].end());
}

}  // namespace rigor
