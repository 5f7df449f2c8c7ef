// The contacts of a core without vertices over one triangle of a mesh, and at one edge between two.

#include "rigor/bulk/narrow_phase/collide_mesh.hpp"
#include "rigor/bulk/narrow_phase/mesh_names.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// What a feature of contact_region.hpp is made of, and the two numbers of a crossing.
int kind_of(std::uint32_t feature) {
  return static_cast<int>(feature >> 30);
}
int number_of(std::uint32_t feature) {
  return static_cast<int>(feature & ((1u << 30) - 1));
}
int first_of(int crossing) {
  return crossing / static_cast<int>(kMaxHullEdges);
}
int second_of(int crossing) {
  return crossing % static_cast<int>(kMaxHullEdges);
}
constexpr int kCrossing = 0, kVertexOfA = 1, kVertexOfB = 2;

}  // namespace

/// Points of what the core shows to the triangle that lie over it, and of the triangle under it.
void MeshMeeting::find_smooth_region(const MeshView& view, const FloatMesh::Triangle& triangle,
                                     const Facet& facet) {
  const Vec3f& n = facet.n;
  found_.clear();
  const TriangleOutline own(facet.corners, n.dot(triangle.n.cast<float>()) < 0);
  const float slack = 4 * (rounding_ + kCollisionRounding * own.size());
  ShownSide face, shown;
  face.kind = ShownSide::Kind::polygon;
  face.m = n;
  face.points = own.outline().points;
  face.corners = own.corners;
  face.edges = own.sides;
  // An ellipsoid shows its lowest point.
  if (const RingCore* const ring = smooth_->ring()) {
    shown = ring->shown_side(-n, true);
  } else {
    shown.lowest = facet.lowest_point;
  }
  rigor::find_region(face, shown, n, {slack, margin_ + slack, 0, 0}, found_);
  // Corners and crossings count where they are corners and edges of the surface, by their names there.
  std::erase_if(found_, [&](ManifoldCandidate& candidate) {
    const int number = number_of(candidate.feature);
    if (kind_of(candidate.feature) == kVertexOfA) {
      const std::size_t k = own.order[at(number)];
      candidate.feature = vertex_A_feature(triangle.vertices[k]);
      return !triangle.is_corner[k];
    }
    if (kind_of(candidate.feature) == kCrossing) {
      const int side = first_of(number);
      candidate.feature = name_of_two(edge_number(*view.mesh, facet.triangle, side), second_of(number));
      return triangle.side[at(side)] == MeshEdgeKind::flat;
    }
    return false;
  });
  // Heights over the plane are relative to that of the lowest point, which is known to more digits.
  for (ManifoldCandidate& candidate : found_) {
    const Vec3f p = candidate.p + 0.5f * candidate.gap * n;
    candidate.gap = facet.separation + n.dot(p - facet.lowest_point);
    candidate.p = p - 0.5f * candidate.gap * n;
  }
  std::erase_if(found_, [&](const ManifoldCandidate& candidate) { return candidate.gap > margin_; });
}

/// The directions between the normals of the two faces at an edge, if the surface falls away from the edge
/// along these. At the border of a sheet they go half around.
std::optional<NormalArc> MeshMeeting::normals_about(const EdgePart& edge, const Ridge& ridge) const {
  const Facet& own = facets_[at(ridge.first)];
  // The corner of a facet that is farthest from the edge's line.
  const Vec3f along = edge.u.normalized();
  const auto corner_beside = [&](const Facet& facet) {
    Vec3f farthest = Vec3f::Zero();
    for (const Vec3f& corner : facet.corners) {
      const Vec3f to = corner - edge.p, beside = to - along.dot(to) * along;
      if (beside.squaredNorm() > farthest.squaredNorm()) farthest = beside;
    }
    return farthest;
  };
  const Vec3f within = corner_beside(own);
  const Vec3f across = along.cross(own.n), outward = across.dot(within) > 0 ? Vec3f(-across) : across;
  if (ridge.second < 0) return NormalArc{edge.p, own.n, -own.n, outward};
  const Facet& other = facets_[at(ridge.second)];
  if (own.n.dot(corner_beside(other)) > 0) return std::nullopt;
  // Sheets have two sides: the one from which the first facet falls away.
  const Vec3f last = other.n.dot(within) > 0 ? Vec3f(-other.n) : other.n;
  return NormalArc{edge.p, own.n, last, outward};
}

/// Where a core without vertices touches an edge, or one of its ends, up to the margin; false if it does not.
bool MeshMeeting::touch_smooth(const MeshView& view, const EdgePart& edge, Ridge& ridge) {
  // Most edges are too far away.
  const float length = edge.u.norm();
  const float nearest = std::clamp(-edge.u.dot(edge.p - center_) / (length * length), 0.0f, 1.0f);
  if ((edge.p + nearest * edge.u - center_).norm() > extent_ + margin_) return false;
  const std::optional<NormalArc> normals = normals_about(edge, ridge);
  if (!normals) return false;
  std::optional<PartingTouch> touch = part_best_about_edge(*smooth_, *normals, rounding_);
  if (!touch || touch->separation > margin_) return false;
  const float along = edge.u.dot(touch->p - edge.p) / length;
  const bool is_before = (along < 0), is_beyond = (along > length);
  const int vertex = is_before ? edge.first : is_beyond ? edge.last : -1;
  if (is_before || is_beyond) {
    // An end, if it is one of the edge and not only of the part that is looked at.
    if (vertex < 0) return false;
    const Vec3f q = is_before ? edge.p : Vec3f(edge.p + edge.u);
    touch = smooth_->touch_point(q, touch->n);
    if (!touch) {
      is_clear_ = false;
      return false;
    }
    if (touch->separation > margin_) return false;
  } else if (touch->separation < 0) {
    // What the core parts from the edge better along a direction of its own is not held by the edge.
    const Vec3f end = edge.p + edge.u;
    const float parted =
        smooth_->separation_from({edge.p, end, end}, touch->p - touch->separation * touch->n);
    if (parted > touch->separation + preference(touch->separation)) {
      blocked_ = std::min(blocked_, parted);
      return false;
    }
  }
  ridge.n = touch->n;
  ridge.gap = touch->separation;
  if (vertex < 0 && smooth_->ring() != nullptr) {
    add_ring_candidates(view, edge, *smooth_->ring(), ridge);
  } else {
    const std::uint32_t feature = vertex < 0 ? name_of_two(edge.number, 0) : vertex_A_feature(vertex);
    ridge.candidates.push_back({touch->p - 0.5f * ridge.gap * ridge.n, ridge.gap, feature});
  }
  ridge.top = ridge.n.dot(edge.u) > 0 ? edge.p + edge.u : edge.p;
  if (!ridge.candidates.empty() && is_normal(view, ridge, vertex)) return true;
  // A vertex inside the core that leaves it along no normal of the surface: others have to hold it.
  if (vertex >= 0) blocked_ = std::min(blocked_, ridge.gap);
  return false;
}

/// The points of an edge and a solid of revolution, which parts from it along the ridge's normal: those of a
/// cap that parts them nearly as well, or one or two.
void MeshMeeting::add_ring_candidates(const MeshView& view, const EdgePart& edge, const RingCore& ring,
                                      Ridge& ridge) {
  const RegionScale scale{4 * rounding_, margin_, 0, 0};
  ShownSide line;
  line.kind = ShownSide::Kind::segment;
  line.lowest = line.center = line.ends[0] = edge.p;
  line.ends[1] = edge.p + edge.u;
  line.end_names[1] = 1;
  line.m = edge.u.normalized();
  line.is_straight = true;
  const ShownSide cap = ring.shown_side(-ridge.n, true);
  bool is_on_cap = false;
  if (cap.kind == ShownSide::Kind::disc) {
    Ridge tilted{.first = ridge.first, .second = ridge.second, .from = ridge.from, .n = -cap.m};
    const float least = rigor::find_region(line, cap, tilted.n, scale, ridge.candidates).least;
    is_on_cap =
        std::abs(least - ridge.gap) <= preference(ridge.gap) + 4 * rounding_ && is_normal(view, tilted, -1);
    if (is_on_cap) {
      ridge.n = tilted.n;
      ridge.gap = least;
    } else {
      ridge.candidates.clear();
    }
  }
  if (!is_on_cap)
    rigor::find_region(line, ring.shown_side(-ridge.n, false), ridge.n, scale, ridge.candidates);
  // By their names on the mesh; ends of the part that are none of the edge do not count.
  std::erase_if(ridge.candidates, [&](ManifoldCandidate& candidate) {
    const int number = number_of(candidate.feature);
    const int vertex = number == 0 ? edge.first : edge.last;
    switch (kind_of(candidate.feature)) {
      case kVertexOfA:
        candidate.feature = vertex_A_feature(vertex);
        return vertex < 0;
      case kVertexOfB:
        return false;
      default:
        candidate.feature = name_of_two(edge.number, number);
        return false;
    }
  });
}

}  // namespace rigor
