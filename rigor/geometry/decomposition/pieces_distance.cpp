#include "rigor/geometry/decomposition/pieces_distance.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/decomposition/mesh_solid.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <algorithm>

namespace rigor {
namespace {

/// Directions along which a way out is looked for: the normals of this many overlapping pairs, the deepest
/// first.
constexpr std::size_t kMostDirections = 4;
/// Normals that differ by less are one direction.
constexpr double kSameDirection = 1e-6;

/// Lower bound of the signed distance of the contents of two boxes: that of the boxes themselves [m].
double signed_box_distance(const Aabb& a, const Aabb& b) {
  const Vec3 gap = (b.lower - a.upper).cwiseMax(a.lower - b.upper);
  return gap.maxCoeff() < 0 ? gap.maxCoeff() : gap.cwiseMax(0.0).norm();
}

/// Two pieces, with a lower bound of their signed distance.
struct PiecePair {
  double bound;
  std::size_t i, k;
  bool operator<(const PiecePair& other) const { return bound > other.bound; }  // nearest on top of a heap
};

/// Rounding of the box distances relative to the distances of pieces [m].
double box_rounding(const PlacedPieces& a, const PlacedPieces& b) {
  double largest = 0;
  for (const PlacedPieces* pieces : {&a, &b}) {
    for (const Aabb& box : pieces->boxes_W)
      largest = std::max({largest, box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff()});
  }
  return 64 * kEpsilon * largest;
}

Aabb whole_box(const PlacedPieces& pieces) {
  Aabb box = pieces.boxes_W.front();
  for (const Aabb& other : pieces.boxes_W) box = box.united(other);
  return box;
}

/// All pairs that may be as near as the one that seems nearest: the piece of A nearest to the box about B
/// with the piece of B nearest to that.
std::vector<PiecePair> near_pairs(const PlacedPieces& a, const PlacedPieces& b, double rounding) {
  const auto nearest = [](const PlacedPieces& pieces, const Aabb& box) {
    const auto bound = [&](const Aabb& piece) { return signed_box_distance(piece, box); };
    return static_cast<std::size_t>(std::ranges::min_element(pieces.boxes_W, {}, bound) -
                                    pieces.boxes_W.begin());
  };
  const Aabb box_A = whole_box(a), box_B = whole_box(b);
  const std::size_t i0 = nearest(a, box_B), k0 = nearest(b, a.boxes_W[i0]);
  const double limit = piece_distance(a, i0, b, k0).distance + rounding;
  std::vector<std::size_t> of_b;
  for (std::size_t k = 0; k < b.boxes_W.size(); ++k) {
    if (signed_box_distance(b.boxes_W[k], box_A) - rounding <= limit) of_b.push_back(k);
  }
  std::vector<PiecePair> pairs;
  for (std::size_t i = 0; i < a.boxes_W.size(); ++i) {
    if (signed_box_distance(a.boxes_W[i], box_B) - rounding > limit) continue;
    for (const std::size_t k : of_b) {
      const double bound = signed_box_distance(a.boxes_W[i], b.boxes_W[k]);
      if (bound - rounding <= limit) pairs.push_back({bound, i, k});
    }
  }
  return pairs;
}

/// Looks for a translation of B that parts the solids.
class TranslationSearch {
 public:
  TranslationSearch(const PlacedPieces& a, const PlacedPieces& b, double rounding)
      : a_(a), b_(b), rounding_(rounding), box_B_(whole_box(b)) {}

  /// Length of a translation of B along n after which no piece of it overlaps one of A; `limit` if none
  /// shorter than that was found [m].
  double length(const Vec3& n, double limit) const {
    double t = 0;
    for (bool is_apart = false; !is_apart;) {
      is_apart = true;
      const auto part = [&](std::size_t i, std::size_t k, const DistanceResult& d) {
        // Along n the pair is parted, for good, by what parts it along its own normal, or once the lowest
        // point of B's piece is past the highest of A's. That may bring others together.
        const double along = n.dot(d.n_W);
        const double past = highest(a_, i, n) + highest(b_, k, -n) - t;
        const double advance = along > kLeastCosine ? std::min(past, -d.distance / along) : past;
        t += advance + rounding_;
        is_apart = false;
        return t < limit;
      };
      if (!for_overlapping([&] { return Vec3(t * n); }, part)) return limit;
    }
    return t;
  }

  /// A translation that parts the pairs one after another, the deepest first: the direction out of a corner.
  /// What it has come to after a few, if they do not end.
  Vec3 step_by_step() const {
    Vec3 shift = Vec3::Zero();
    for (int step = 0; step < kMostSteps; ++step) {
      DistanceResult deepest{.distance = 0};
      for_overlapping([&] { return shift; },
                      [&](std::size_t, std::size_t, const DistanceResult& d) {
                        if (d.distance < deepest.distance) deepest = d;
                        return true;
                      });
      if (deepest.distance == 0) break;
      shift -= deepest.distance * deepest.n_W;
    }
    return shift;
  }

 private:
  static constexpr int kMostSteps = 12;
  /// Directions more square to each other than this do not part a pair.
  static constexpr double kLeastCosine = 1e-3;

  static double highest(const PlacedPieces& pieces, std::size_t i, const Vec3& n) {
    return n.dot(pieces.X_WS.p) + support_value(pieces.shapes[i], pieces.X_WS.R.transpose() * n);
  }
  static Aabb shifted(const Aabb& box, const Vec3& by) { return {box.lower + by, box.upper + by}; }

  /// Calls visit(i, k, distance) for the pairs of pieces that overlap after the translation of B that shift()
  /// is at that moment; ends with false when visit returns false.
  bool for_overlapping(const auto& shift, const auto& visit) const {
    for (std::size_t i = 0; i < a_.shapes.size(); ++i) {
      if (!a_.boxes_W[i].overlaps(shifted(box_B_, shift()))) continue;
      for (std::size_t k = 0; k < b_.shapes.size(); ++k) {
        const Vec3 by = shift();
        if (!a_.boxes_W[i].overlaps(shifted(b_.boxes_W[k], by))) continue;
        const Pose X_WB{b_.X_WS.R, b_.X_WS.p + by};
        const DistanceResult d =
            convex_distance(make_core(a_.shapes[i]), a_.X_WS, make_core(b_.shapes[k]), X_WB);
        if (d.distance < -rounding_ && !visit(i, k, d)) return false;
      }
    }
    return true;
  }

  const PlacedPieces& a_;
  const PlacedPieces& b_;
  const double rounding_;
  const Aabb box_B_;
};

/// Directions of the deepest pairs, each once.
std::vector<Vec3> distinct_normals(std::vector<DistanceResult> overlaps) {
  std::ranges::stable_sort(overlaps, {}, &DistanceResult::distance);
  std::vector<Vec3> normals;
  for (const DistanceResult& d : overlaps) {
    const bool is_known =
        std::ranges::any_of(normals, [&](const Vec3& n) { return (n - d.n_W).norm() <= kSameDirection; });
    if (!is_known) normals.push_back(d.n_W);
    if (normals.size() == kMostDirections) break;
  }
  return normals;
}

}  // namespace

PlacedPieces placed_pieces(const Shape& shape, const Pose& X_WS) {
  PlacedPieces result{.X_WS = X_WS};
  if (const Mesh* const mesh = std::get_if<Mesh>(&shape)) {
    RIGOR_ASSERT(mesh->tree != nullptr && mesh->tree->is_closed);
    const std::shared_ptr<const MeshSolid> solid = solid_of(*mesh);
    result.shapes.assign(solid->pieces().begin(), solid->pieces().end());
    result.touching = solid->touching_pieces();
  } else {
    result.shapes = {shape};
  }
  for (const Shape& piece : result.shapes) result.boxes_W.push_back(axis_aligned_box(piece, X_WS));
  return result;
}

DistanceResult piece_distance(const PlacedPieces& a, std::size_t i, const PlacedPieces& b, std::size_t k) {
  return convex_distance(make_core(a.shapes[i]), a.X_WS, make_core(b.shapes[k]), b.X_WS);
}

DistanceResult pieces_distance(const PlacedPieces& a, const PlacedPieces& b, const DistanceResult* known) {
  RIGOR_ASSERT(!a.empty() && !b.empty());
  // The pair of boxes with the least distance comes first; the search ends when no pair that is left can be
  // nearer, so most pairs are never measured.
  const double rounding = box_rounding(a, b);
  std::vector<PiecePair> pairs = near_pairs(a, b, rounding);
  std::make_heap(pairs.begin(), pairs.end());
  DistanceResult best{kInfinity, kInfinity, kInfinity, a.X_WS.p, b.X_WS.p, Vec3::UnitZ()};
  std::vector<DistanceResult> overlaps;
  while (!pairs.empty() && pairs.front().bound - rounding <= best.distance) {
    std::pop_heap(pairs.begin(), pairs.end());
    const PiecePair pair = pairs.back();
    pairs.pop_back();
    const DistanceResult d = piece_distance(a, pair.i, b, pair.k);
    if (d.distance < 0) overlaps.push_back(d);
    const double lower = std::min(best.lower, d.lower), upper = std::min(best.upper, d.upper);
    if (d.distance < best.distance) best = d;
    best.lower = lower;
    best.upper = upper;
  }
  // Pairs that were left out may be nearer by the rounding of the boxes.
  best.lower = std::min(best.lower, best.distance - 2 * rounding);
  if (overlaps.empty() || a.shapes.size() * b.shapes.size() == 1) return best;

  // Several pieces that overlap may take more to part than the deepest of them alone.
  const TranslationSearch search(a, b, rounding);
  std::vector<Vec3> directions = distinct_normals(std::move(overlaps));
  directions.push_back(search.step_by_step().stableNormalized());
  if (known != nullptr) directions.push_back(known->n_W);
  double shortest = kInfinity;
  for (const Vec3& n : directions) {
    if (n.squaredNorm() > 0.5) shortest = search.length(n, shortest);
  }
  // A deeper overlap that is known stands.
  if (known != nullptr && known->upper < best.distance) best = *known;
  best.lower = std::min(best.lower, -shortest - 2 * rounding);
  return best;
}

}  // namespace rigor
