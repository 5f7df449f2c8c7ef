#include "rigor/geometry/contacts/mesh_pair_contacts.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/contacts/contact_pair.hpp"
#include "rigor/geometry/distance/mesh_overlap.hpp"
#include "rigor/geometry/distance/mesh_pair.hpp"
#include "rigor/geometry/distance/mesh_side.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_pair.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace rigor {
namespace {

constexpr double kBorderSlack = 1e-12;  ///< Of sizes: this far outside a border still counts as on it.

using TrianglePairs = std::vector<std::array<int, 2>>;

SurfaceCurvature curvature_of(int flat_count, const Vec3& flat = Vec3::Zero()) {
  SurfaceCurvature curvature;
  curvature.flat_count = flat_count;
  curvature.flat_W = flat;
  return curvature;
}

/// Collects the contacts of two meshes; sides 0 and 1 are A and B.
class MeshPairContacts {
 public:
  MeshPairContacts(const Mesh& a, const Pose& X_OA, const Mesh& b, const Pose& X_OB, double tolerance,
                   double reach)
      : a_(a),
        b_(b),
        X_OA_(X_OA),
        X_OB_(X_OB),
        tolerance_(tolerance),
        reach_(reach),
        sides_{MeshSide(a, X_OA, 2 * reach), MeshSide(b, X_OB, 2 * reach)},
        strict_{MeshSide(a, X_OA, 2 * tolerance), MeshSide(b, X_OB, 2 * tolerance)},
        slack_(kBorderSlack * (a.tree->size + b.tree->size)) {}

  std::vector<ContactPoint> find() {
    const Pose X_AB = relative_pose(X_OA_, X_OB_);
    const TrianglePairs pairs = find_near_triangles(a_, b_, X_AB, reach_ + slack_);
    if (pairs.empty()) return {};
    // Surfaces that cross may overlap by as much as the way out is long; nothing deeper is a contact.
    depth_ = tolerance_;
    if (surfaces_meet(a_, b_, X_AB)) depth_ -= overlap_distance(a_, X_OA_, b_, X_OB_).distance;
    // Corners over faces, both ways, and crossing edges; then what several features hold, and what none does.
    for (const auto& [t, u] : pairs) {
      add_corners(0, t, u);
      add_corners(1, u, t);
      add_edges(t, u);
    }
    join_sharp_contacts();
    add_witnesses(pairs);
    sort_and_merge({.tolerance = reach_, .tie = 0, .slack = 0, .merge = merge()}, contacts_);
    return std::move(contacts_);
  }

 private:
  /// Features this near to a place may all hold what touches there.
  double sharp_reach() const { return 4 * tolerance_ + slack_; }
  double merge() const { return std::max(slack_, 1e-9 * (a_.tree->size + b_.tree->size)); }
  bool is_within(double gap) const { return gap <= reach_ && gap >= -depth_; }

  /// The corners of triangle t of one side over triangle u of the other.
  void add_corners(int side, int t, int u) {
    for (int k = 0; k < 3; ++k) {
      const int v = sides_[at(side)].vertex_of(t, k);
      if (!sides_[at(side)].is_corner(v) || !seen_corners_.insert({side, v, u}).second) continue;
      add_corner(side, v, u);
    }
  }

  void add_corner(int side, int v, int u) {
    const MeshSide &mine = sides_[at(side)], &other = sides_[at(1 - side)];
    const Vec3 n = other.normal(u), p = mine.vertex(v);
    const double gap = n.dot(p - other.corner(u, 0));
    if (!is_within(gap)) return;
    // Over the triangle: inside each of its sides as seen along the normal.
    bool is_on_border = false;
    for (int k = 0; k < 3; ++k) {
      const Vec3 start = other.corner(u, k), along = other.corner(u, k + 1) - start;
      const double inside = n.cross(along).normalized().dot(p - start);
      if (inside < -slack_) return;
      is_on_border |= inside <= sharp_reach() && other.is_edge(u, k);
    }
    // The surface around the corner has to fall away from the face.
    if (!mine.falls_away_at_vertex(v, -n)) return;
    const Feature corner{Feature::Kind::vertex, v}, face{Feature::Kind::face, other.topology(u).patch};
    ContactPoint point = side == 0 ? on_face(p, p - gap * n, -n, gap, 1) : on_face(p - gap * n, p, n, gap, 0);
    point.feature = side == 0 ? feature_pair(corner, face) : feature_pair(face, corner);
    (is_on_border ? sharp_ : contacts_).push_back(point);
  }

  /// A contact whose normal rotates with the face of one side.
  static ContactPoint on_face(const Vec3& p_A, const Vec3& p_B, const Vec3& n, double gap, int side_of_face) {
    return {.p_WA = p_A,
            .p_WB = p_B,
            .n_W = n,
            .gap = gap,
            .feature = 0,
            .curvature_A = curvature_of(side_of_face == 0 ? 2 : 0),
            .curvature_B = curvature_of(side_of_face == 1 ? 2 : 0)};
  }

  /// Where a corner meets an edge or a corner, several faces and edges may hold it, within the tolerance of
  /// one place and each with its own normal. One contact with the mean normal stands for them all; what holds
  /// it alone is an ordinary contact.
  void join_sharp_contacts() {
    std::vector<bool> is_joined(sharp_.size(), false);
    for (std::size_t i = 0; i < sharp_.size(); ++i) {
      if (is_joined[i]) continue;
      ContactPoint joined = sharp_[i];
      std::vector<Vec3> normals = {joined.n_W};
      for (std::size_t k = i + 1; k < sharp_.size(); ++k) {
        if ((sharp_[k].p_WA - sharp_[i].p_WA).norm() > sharp_reach()) continue;
        is_joined[k] = true;
        const bool is_known =
            std::ranges::any_of(normals, [&](const Vec3& n) { return (n - sharp_[k].n_W).norm() <= 1e-9; });
        if (!is_known) normals.push_back(sharp_[k].n_W);
      }
      if (normals.size() > 1) {
        const Vec3 sum = std::accumulate(normals.begin(), normals.end(), Vec3(Vec3::Zero()));
        if (sum.norm() > 1e-3) joined.n_W = sum.normalized();
        const Vec3 p = joined.p_WA;
        const double gap = joined.n_W.dot(joined.p_WB - p);
        const std::uint64_t feature = joined.feature;
        joined = on_face(p, p + gap * joined.n_W, joined.n_W, gap, 1);
        joined.feature = feature;
        joined.degenerate = true;
      }
      contacts_.push_back(joined);
    }
  }

  void add_edges(int t, int u) {
    for (int i = 0; i < 3; ++i) {
      if (!sides_[0].is_edge(t, i)) continue;
      const int edge_A = sides_[0].edge(t, i);
      for (int k = 0; k < 3; ++k) {
        if (!sides_[1].is_edge(u, k)) continue;
        const int edge_B = sides_[1].edge(u, k);
        if (seen_edges_.insert({edge_A, edge_B}).second) add_crossing(edge_A, edge_B);
      }
    }
  }

  /// A face of each mesh at the two edges, such that the two lie on each other within the tolerance.
  struct FacePair {
    int t, u;
  };
  std::optional<FacePair> facing_faces(int edge_A, int edge_B, double shorter) const {
    const double tilt = std::min(0.01, 4 * tolerance_ / shorter + 1e-9);
    for (const int t : sides_[0].triangles_at(edge_A)) {
      for (const int u : sides_[1].triangles_at(edge_B)) {
        if (t < 0 || u < 0) continue;
        const Vec3 n_A = sides_[0].normal(t), n_B = sides_[1].normal(u);
        if (n_A.dot(n_B) < 0 && n_A.cross(n_B).norm() <= tilt) return FacePair{t, u};
      }
    }
    return std::nullopt;
  }

  void add_crossing(int edge_A, int edge_B) {
    const Vec3 a = sides_[0].corner(edge_A / 3, edge_A % 3), b = sides_[1].corner(edge_B / 3, edge_B % 3);
    const Vec3 along_A = sides_[0].corner(edge_A / 3, edge_A % 3 + 1) - a;
    const Vec3 along_B = sides_[1].corner(edge_B / 3, edge_B % 3 + 1) - b;
    const Vec3 across = along_A.cross(along_B);
    if (across.norm() <= 1e-6 * along_A.norm() * along_B.norm()) return;  // Their ends carry the contact.

    // The normal is that of a face at one of the edges if two faces lie on each other, else that of the two
    // edges.
    const auto faces = facing_faces(edge_A, edge_B, std::min(along_A.norm(), along_B.norm()));
    const bool face_is_of_A = faces && sides_[0].patch_area(faces->t) >= sides_[1].patch_area(faces->u);
    Vec3 n = across.normalized();
    if (faces) n = face_is_of_A ? sides_[0].normal(faces->t) : -sides_[1].normal(faces->u);
    // a + s along_A and b + t along_B, one above the other along n.
    const double det = across.dot(n);
    const double s = (b - a).cross(along_B).dot(n) / det, t = (b - a).cross(along_A).dot(n) / det;
    const double end_A = slack_ / along_A.norm(), end_B = slack_ / along_B.norm();
    if (!(s >= -end_A && s <= 1 + end_A && t >= -end_B && t <= 1 + end_B)) return;
    const Vec3 p = a + s * along_A, q = b + t * along_B;
    // The sense of the normal, the depth and the shape of both edges decide whether it is a contact.
    if (!faces && !find_outward(edge_A, edge_B, q - p, n)) return;
    const double gap = n.dot(q - p);
    if (!is_within(gap)) return;
    if (!falls_away(sides_, edge_A, edge_B, n)) return;

    ContactPoint point = on_face(p, p + gap * n, n, gap, face_is_of_A ? 0 : 1);
    if (!faces) {
      point.curvature_A = curvature_of(1, along_A.normalized());
      point.curvature_B = curvature_of(1, along_B.normalized());
    }
    point.feature = feature_pair({Feature::Kind::edge, edge_A}, {Feature::Kind::edge, edge_B});
    // Near its end an edge shares the place with other features.
    const double from_end_A = std::min(s, 1 - s) * along_A.norm();
    const double from_end_B = std::min(t, 1 - t) * along_B.norm();
    const bool is_sharp = !faces || std::min(from_end_A, from_end_B) <= sharp_reach();
    (is_sharp ? sharp_ : contacts_).push_back(point);
  }

  using Sides = std::array<MeshSide, 2>;
  static bool falls_away(const Sides& sides, int edge_A, int edge_B, const Vec3& n) {
    return sides[0].falls_away_at_edge(edge_A, n) && sides[1].falls_away_at_edge(edge_B, -n);
  }

  /// Turns n from A to B, by the surfaces within the tolerance or else within the reach; if they allow both,
  /// by the smaller gap.
  bool find_outward(int edge_A, int edge_B, const Vec3& between, Vec3& n) const {
    for (const Sides* sides : {&strict_, &sides_}) {
      const bool forward = falls_away(*sides, edge_A, edge_B, n);
      const bool backward = falls_away(*sides, edge_A, edge_B, -n);
      if (!forward && !backward) continue;
      if (!forward || (backward && n.dot(between) < 0)) n = -n;
      return true;
    }
    return false;
  }

  /// Parts of the surfaces that hang together and come near without a contact: a corner at a corner or at an
  /// edge. Each gives the witness points of its nearest triangles.
  void add_witnesses(const TrianglePairs& pairs) {
    const std::vector<std::size_t> part = connected_parts(pairs);
    std::map<std::size_t, std::size_t> nearest;  // Of each part, its nearest pair.
    std::set<std::size_t> is_held;
    std::vector<double> squared(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const TriangleCorners t = corners(0, pairs[i][0]), u = corners(1, pairs[i][1]);
      squared[i] = triangle_distance(t, u).squared;
      const auto [entry, is_new] = nearest.try_emplace(part[i], i);
      if (!is_new && squared[i] < squared[entry->second]) entry->second = i;
      if (std::ranges::any_of(contacts_, [&](const ContactPoint& c) { return touches(c, pairs[i]); }))
        is_held.insert(part[i]);
    }
    for (const auto& [key, pair] : nearest) {
      if (!is_held.contains(key)) add_witness(pairs[pair]);
    }
  }

  TriangleCorners corners(int side, int t) const {
    return {sides_[at(side)].corner(t, 0), sides_[at(side)].corner(t, 1), sides_[at(side)].corner(t, 2)};
  }

  /// Does the contact belong to features of these triangles?
  bool touches(const ContactPoint& contact, const std::array<int, 2>& pair) const {
    return has_feature(0, first_feature(contact.feature), pair[0]) &&
           has_feature(1, second_feature(contact.feature), pair[1]);
  }
  bool has_feature(int side, const Feature& feature, int t) const {
    const MeshSide& mesh = sides_[at(side)];
    if (feature.kind == Feature::Kind::face) return mesh.topology(t).patch == feature.index;
    for (int k = 0; k < 3; ++k) {
      if (feature.kind == Feature::Kind::vertex && mesh.vertex_of(t, k) == feature.index) return true;
      if (feature.kind == Feature::Kind::edge && mesh.edge(t, k) == feature.index) return true;
    }
    return false;
  }

  /// For each pair the first one of those that hang together: of both meshes they share a vertex.
  std::vector<std::size_t> connected_parts(const TrianglePairs& pairs) const {
    // A forest of the pairs with path halving.
    std::vector<std::size_t> root(pairs.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto root_of = [&](std::size_t i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    // Two pairs that share a vertex of A and one of B hang together.
    std::map<std::pair<int, int>, std::size_t> first;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (int k = 0; k < 9; ++k) {
        const std::pair key(sides_[0].vertex_of(pairs[i][0], k / 3), sides_[1].vertex_of(pairs[i][1], k % 3));
        const std::size_t r = root_of(first.try_emplace(key, i).first->second), s = root_of(i);
        root[std::max(r, s)] = std::min(r, s);
      }
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) root[i] = root_of(i);
    return root;
  }

  void add_witness(const std::array<int, 2>& pair) {
    const TriangleCorners t = corners(0, pair[0]), u = corners(1, pair[1]);
    const TriangleDistance distance = triangle_distance(t, u);
    const auto [p, q] = nearest_points(t, u, distance.feature);
    // The line between the nearest points; where they touch, the mean of the normals of both surfaces.
    Vec3 n = q - p;
    if (!(n.norm() > slack_)) {
      n = X_OA_.R * nearest_mesh_point(a_, X_OA_.inverse() * p).normal_M.stableNormalized() -
          X_OB_.R * nearest_mesh_point(b_, X_OB_.inverse() * q).normal_M.stableNormalized();
    }
    n = n.stableNormalized();
    const double gap = n.dot(q - p);
    ContactPoint point = on_face(p, p + gap * n, n, gap, 1);
    point.feature = feature_pair({Feature::Kind::face, sides_[0].topology(pair[0]).patch},
                                 {Feature::Kind::face, sides_[1].topology(pair[1]).patch});
    point.degenerate = true;
    if (n.norm() > 0.5) contacts_.push_back(point);
  }

  const Mesh& a_;
  const Mesh& b_;
  const Pose& X_OA_;
  const Pose& X_OB_;
  const double tolerance_;
  const double reach_;
  const std::array<MeshSide, 2> sides_;   ///< What rises within the reach falls away,
  const std::array<MeshSide, 2> strict_;  ///< or within the tolerance alone.
  const double slack_;
  double depth_ = 0;  ///< Deepest gap that counts [m].
  std::set<std::array<int, 3>> seen_corners_;
  std::set<std::array<int, 2>> seen_edges_;
  std::vector<ContactPoint> sharp_;  ///< Of crossing edges, and of corners on a convex edge or a corner.
  std::vector<ContactPoint> contacts_;
};

}  // namespace

std::vector<ContactPoint> mesh_pair_contacts(const Mesh& a, const Pose& X_OA, const Mesh& b, const Pose& X_OB,
                                             double tolerance, double reach) {
  RIGOR_ASSERT(a.tree != nullptr && b.tree != nullptr);
  return MeshPairContacts(a, X_OA, b, X_OB, tolerance, reach).find();
}

}  // namespace rigor
