#include "rigor/bulk/narrow_phase/collide_mesh.hpp"

#include "rigor/bulk/narrow_phase/collide_boxes.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

Eigen::Map<const Eigen::ArrayXf> column(const float* first, std::size_t count) {
  return {first, static_cast<Eigen::Index>(count)};
}

}  // namespace

Vec3f MeshMeeting::point(const MeshView& view, int vertex) const {
  return (view.mesh->vertices[at(vertex)] - view.c_M).cast<float>();
}

/// What a face may be worse than an edge, so that it is still taken: it has more points.
float MeshMeeting::preference(float gap) const {
  return kFacePreferenceOfOverlap * std::max(-gap, 0.0f) + kFacePreferenceOfSize * thinnest_;
}

void MeshMeeting::place_core(const MeshView& view, const BulkShape& core, const PlacedShape& placed) {
  const Mat3f R = view.R_MW * placed.rotation();
  const Vec3f p = view.R_MW * placed.position();
  if (core.hull != nullptr) {
    smooth_.reset();
    place_polytope(core, {R * core.scale.asDiagonal(), R, p}, pair_.b);
    center_ = pair_.b.center = middle_of(pair_.b);
    thinnest_ = core.inner_radius();
  } else {
    PlacedShape placed_M = placed;
    Eigen::Map<Mat3f>(placed_M.R) = R;
    for (int k = 0; k < 3; ++k) placed_M.p[k] = p[k];
    smooth_.emplace().place(core, placed_M, Vec3f::Zero());
    center_ = smooth_->middle();
    thinnest_ = smooth_->inner_radius();
  }
  radius_ = core.radius;
  extent_ = core.extent + (center_ - p).norm();
  reach_ = p.norm() + core.extent;
  rounding_ = kCollisionRounding * (core.extent + reach_);
  equal_depth_ = rounding_ + kEqualDepthOfSize * thinnest_;
}

/// The box about the core without its radius.
void MeshMeeting::find_box(Vec3f& lower, Vec3f& upper) const {
  if (smooth_) {
    for (int k = 0; k < 3; ++k) {
      lower[k] = smooth_->farthest(-Vec3f::Unit(k))[k];
      upper[k] = smooth_->farthest(Vec3f::Unit(k))[k];
    }
    return;
  }
  const LaneColumns v = pair_.b.vertices();
  const auto x = column(v.x, v.count), y = column(v.y, v.count), z = column(v.z, v.count);
  lower = Vec3f(x.minCoeff(), y.minCoeff(), z.minCoeff());
  upper = Vec3f(x.maxCoeff(), y.maxCoeff(), z.maxCoeff());
}

/// The core's lowest point over the facet, which is so far against its normal.
float MeshMeeting::find_lowest(Facet& facet) const {
  if (smooth_) {
    facet.lowest_point = smooth_->farthest(-facet.n);
    return -facet.n.dot(facet.lowest_point);
  }
  const Support support = find_support(pair_.b.vertices(), -facet.n, best_lane_target());
  facet.lowest = support.index;
  facet.lowest_point = pair_.b.vertex(facet.lowest);
  return support.height;
}

/// The triangles whose boxes meet that of the core, with the core's heights over them.
void MeshMeeting::list_facets(const MeshView& view) {
  // The box of the core, as the tree has its boxes: from the mesh's origin. What is rounded is added.
  Vec3f lower, upper;
  find_box(lower, upper);
  const Vec3f center = view.c_M.cast<float>();
  const float grown = limit_ + 4 * kCollisionRounding * (reach_ + center.lpNorm<1>());
  lower = center + (lower - Vec3f::Constant(grown));
  upper = center + (upper + Vec3f::Constant(grown));
  view.mesh->list_near(lower, upper, stack_, near_);
  facets_.clear();
  may_be_inside_ = near_.empty() && view.mesh->is_closed;
  for (const int t : near_) {
    const FloatMesh::Triangle& triangle = view.mesh->triangles[at(t)];
    // Heights over the plane are counted in 64 bits at the centre of the body.
    const Vec3f n = triangle.n.cast<float>();
    const float height = static_cast<float>(triangle.n.dot(view.c_M) - triangle.offset);
    const bool is_behind = height + n.dot(center_) < 0;
    const bool is_turned = is_behind && !view.mesh->is_closed;
    may_be_inside_ |= is_behind && view.mesh->is_closed;
    // Sheets have two sides, so that a triangle of an open mesh faces the core; one of a closed mesh turns
    // its back to it.
    Facet facet{t, is_behind && !is_turned, is_turned ? Vec3f(-n) : n, {}, 0, 0, Vec3f::Zero(), kFar};
    for (std::size_t k = 0; k < 3; ++k) facet.corners[k] = point(view, triangle.vertices[k]);
    // The lowest point of the core over the plane tells by how much the plane separates.
    facet.separation = (is_turned ? -height : height) - find_lowest(facet);
    facets_.push_back(facet);
  }
}

int MeshMeeting::facet_of(int triangle) const {
  for (std::size_t k = 0; k < facets_.size(); ++k)
    if (facets_[k].triangle == triangle) return static_cast<int>(k);
  return -1;
}

/// How far the facet reaches above the plane through p across n [m]; 0 if it lies behind it.
float MeshMeeting::height_above(const Facet& facet, const Vec3f& n, const Vec3f& p) const {
  const float highest =
      std::max({n.dot(facet.corners[0]), n.dot(facet.corners[1]), n.dot(facet.corners[2])}) - n.dot(p);
  return highest <= 4 * rounding_ ? 0 : highest;
}

/// Whether a triangle near the core of the facet's flat patch has a vertex for which `meets` holds.
template <class Meets>
bool MeshMeeting::patch_meets(const MeshView& view, const Facet& facet, const Meets& meets) const {
  const int patch = view.mesh->triangles[at(facet.triangle)].patch;
  return std::any_of(facets_.begin(), facets_.end(), [&](const Facet& other) {
    const FloatMesh::Triangle& triangle = view.mesh->triangles[at(other.triangle)];
    return triangle.patch == patch && std::any_of(triangle.vertices.begin(), triangle.vertices.end(), meets);
  });
}

/// What the triangle's own normal, those of the neighbours of its patch, and the edges that are touched
/// separate the core from it by at most. What reaches no higher than a plane is separated by that too, and
/// what reaches above it by that much less: moved along the plane's normal by as much as is left, the core
/// leaves the triangle, of whatever part of the mesh the plane is. Edges are touched, so that they hold the
/// core if the triangle does not. The plane of a face may be touched nowhere: with an overlap only those of
/// neighbours count.
float MeshMeeting::bound_of(const MeshView& view, const Facet& facet) const {
  float bound = facet.separation;
  for (const Facet& other : facets_) {
    if (other.separation <= bound) continue;
    const float separation = other.separation - height_above(facet, other.n, other.corners[0]);
    if (separation <= bound) continue;
    const auto& vertices = view.mesh->triangles[at(other.triangle)].vertices;
    const auto is_of_other = [&](int v) { return v == vertices[0] || v == vertices[1] || v == vertices[2]; };
    if (other.separation > 0 || patch_meets(view, facet, is_of_other)) bound = separation;
  }
  // The same of edges, which count with the core's own radius.
  for (std::size_t k = 0; k < ridge_count_; ++k) {
    const Ridge& ridge = ridges_[k];
    bound = std::max(bound, ridge.gap + radius_ - height_above(facet, ridge.n, ridge.top));
  }
  return bound;
}

/// Whether the surface falls away from the ridge's normal: both triangles, or all at the corner of it that is
/// touched. (The face of a core that nearly lies on an edge is preferred to the edge: its normal may be a
/// little off.)
bool MeshMeeting::is_normal(const MeshView& view, const Ridge& ridge, int vertex) const {
  constexpr float slack = 0.05f;  // [rad]
  const auto rises = [&](const Vec3f& along) { return ridge.n.dot(along) > slack * along.norm(); };
  if (vertex < 0) {
    for (const int f : {ridge.first, ridge.second}) {
      if (f < 0) continue;
      for (const Vec3f& q : facets_[at(f)].corners)
        if (rises(q - ridge.from)) return false;
    }
    return true;
  }
  // At a corner all triangles about it have to fall away.
  const Vec3f p = point(view, vertex);
  for (const int t : view.mesh->topology->vertex_triangles[at(vertex)]) {
    for (const int v : view.mesh->triangles[at(t)].vertices)
      if (rises(point(view, v) - p)) return false;
  }
  return true;
}

MeshMeeting::Ridge& MeshMeeting::next_ridge() {
  if (ridge_count_ == ridges_.size()) ridges_.emplace_back();
  Ridge& ridge = ridges_[ridge_count_];
  ridge.candidates.clear();
  return ridge;
}

void MeshMeeting::add_ridges(const MeshView& view) {
  ridge_count_ = 0;
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    const Facet& facet = facets_[i];
    if (facet.is_back || facet.separation > limit_) continue;
    const FloatMesh::Triangle& triangle = view.mesh->triangles[at(facet.triangle)];
    for (int k = 0; k < 3; ++k) {
      // Edges that bend inwards are left out on closed meshes; sheets have two sides.
      const MeshEdgeKind kind = triangle.side[at(k)];
      if (kind == MeshEdgeKind::flat || (kind == MeshEdgeKind::concave && view.mesh->is_closed)) continue;
      const int across = triangle.neighbour[at(k)];
      const int j = across < 0 ? -1 : facet_of(across);
      // Each edge once. One whose other triangle is not near is not near either.
      if (across >= 0 && (j < 0 || (j < static_cast<int>(i) && !facets_[at(j)].is_back))) continue;
      try_ridge(view, i, k, j);
    }
  }
}

/// Whether a direction between the normals of a facet and of the one across its edge may separate the core
/// from the edge by more than the facet's does. `outward` is along the facet, across the edge, away from it.
///
/// The lowest point v lies within the facet by w. Along the direction at the angle θ from the normal it is
/// at s cos θ - w sin θ over the edge, which is no more than s if s >= 0, or else if tan(θ/2) <= w / |s|.
bool MeshMeeting::may_part_better(const Facet& own, const Facet* other, const Vec3f& from,
                                  const Vec3f& outward) const {
  const float inside = -outward.dot(own.lowest_point - from) / outward.norm();
  const float tangent = other == nullptr ? 1 : own.n.cross(other->n).norm() / (1 + own.n.dot(other->n));
  return !(inside >= std::max(-own.separation, 0.0f) * tangent + 4 * rounding_);
}

void MeshMeeting::try_ridge(const MeshView& view, std::size_t first, int side, int second) {
  const Facet& facet = facets_[first];
  const Facet* const other = second < 0 ? nullptr : &facets_[at(second)];
  const Vec3f &from = facet.corners[side], &to = facet.corners[(side + 1) % 3];
  const Vec3f along = to - from;
  const auto outward = [&](const Facet& own) {
    return Vec3f(along.cross(view.mesh->triangles[at(own.triangle)].n.cast<float>()));
  };
  // Where one of the faces is nearer all along it, the edge is not touched.
  if (!may_part_better(facet, other, from, outward(facet))) return;
  if (other != nullptr &&
      (other->separation > limit_ || !may_part_better(*other, &facet, from, -outward(*other))))
    return;
  Ridge& ridge = next_ridge();
  ridge.first = static_cast<int>(first);
  ridge.second = second;
  ridge.from = from;
  // Contacts at the ends of an edge are named by the mesh's vertices, which other edges share.
  const auto& vertices = view.mesh->triangles[at(facet.triangle)].vertices;
  ridge.ends[0] = vertices[at(side)];
  ridge.ends[1] = vertices[at((side + 1) % 3)];
  if (find_on_segment(view, to, facet.triangle, side, ridge)) ++ridge_count_;
}

/// The triangles that the core touches over their faces, or that are held by a neighbour or an edge.
void MeshMeeting::find(const MeshView& view, const BulkShape& core, const PlacedShape& placed, float margin,
                       const FloatHull& segment) {
  margin_ = margin;
  limit_ = margin + core.radius;
  segment_ = &segment;
  group_count_ = 0;
  is_clear_ = true;
  blocked_ = 0;
  place_core(view, core, placed);
  list_facets(view);
  if (facets_.empty()) return;
  add_ridges(view);
  for (Facet& facet : facets_)
    if (!facet.is_back && facet.separation <= limit_) add_face(view, facet);
  add_explained_ridges();
  // A vertex or an edge of the surface may be deeper in the core than all contacts say.
  if (blocked_ < 0) {
    float least = 0;
    for (std::size_t k = 0; k < group_count_; ++k)
      for (const ManifoldCandidate& candidate : groups_[k].candidates) least = std::min(least, candidate.gap);
    is_clear_ &= least <= blocked_ + preference(blocked_);
  }
  // Nor is it clear that a core without vertices touches nothing, if nothing parts it from some triangle.
  if (smooth_ && group_count_ == 0)
    is_clear_ &= std::none_of(facets_.begin(), facets_.end(), [&](const Facet& facet) {
      const Vec3f middle = (facet.corners[0] + facet.corners[1] + facet.corners[2]) / 3;
      return !facet.is_back && facet.separation < -4 * rounding_ &&
             smooth_->separation_from(facet.corners, middle) < -4 * rounding_;
    });
  // Manifolds are matched by their part of the mesh, so that their order must not depend on the order of
  // facets.
  std::sort(groups_.begin(), groups_.begin() + static_cast<std::ptrdiff_t>(group_count_),
            [](const MeshContacts& a, const MeshContacts& b) { return a.part < b.part; });
}

/// Edges, except where one of their faces holds the core as well.
void MeshMeeting::add_explained_ridges() {
  for (std::size_t k = 0; k < ridge_count_; ++k) {
    const Ridge& ridge = ridges_[k];
    const auto is_held = [&](int f) { return f >= 0 && facets_[at(f)].least <= ridge.gap + equal_depth_; };
    if (!is_held(ridge.first) && !is_held(ridge.second)) add(ridge.n, ridge.part, ridge.candidates);
  }
}

/// Adds contacts to those of the same normal.
void MeshMeeting::add(const Vec3f& n, int part, const std::vector<ManifoldCandidate>& candidates) {
  constexpr float square_of_angle = 1e-6f;
  if (candidates.empty()) return;
  std::size_t k = 0;
  // A group whose normal is the same to a milliradian takes the contacts up.
  while (k < group_count_ && (groups_[k].n_M - n).squaredNorm() >= square_of_angle) ++k;
  if (k == group_count_) {
    if (++group_count_ > groups_.size()) groups_.emplace_back();
    groups_[k].part = part;
    groups_[k].n_M = n;
    groups_[k].candidates.clear();
  }
  MeshContacts& group = groups_[k];
  group.part = std::min(group.part, part);
  group.candidates.insert(group.candidates.end(), candidates.begin(), candidates.end());
}

}  // namespace rigor
