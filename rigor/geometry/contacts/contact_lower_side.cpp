#include "rigor/core/index.hpp"
#include "rigor/geometry/contacts/contact_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// Sides whose normals are closer than this to square with the direction do not count as facing it.
constexpr double kSteep = 1e-3;
/// A cap or a side counts as facing a plane below 45°.
constexpr double kFacing = 0.70710678;

/// Distance of the farthest point of a face from its centre [m].
double extent_of(const FlatFace& face) {
  if (face.kind == FlatFace::Kind::plane) return std::numeric_limits<double>::infinity();
  double extent = face.radius;
  for (const FaceCorner& corner : face.corners) extent = std::max(extent, (corner.p - face.center).norm());
  return extent;
}

}  // namespace

LowerSide ContactShape::lower_side(const FlatFace& face, double reach) const {
  return is_polyhedron() ? polyhedron_lower_side(face.normal, face.center, reach)
                         : round_lower_side(face, reach);
}

LowerSide ContactShape::polyhedron_lower_side(const Vec3& n, const Vec3& p_plane, double reach) const {
  const Vec3 n_S = direction_in_S(n);
  const Vec3 origin_S = in_S(p_plane);
  const std::vector<Vec3>& vertices = vertices_S();
  std::vector<double> heights;
  heights.reserve(vertices.size());
  for (const Vec3& v : vertices) heights.push_back(n_S.dot(v - origin_S));
  const double lowest = *std::min_element(heights.begin(), heights.end());

  // A vertex can be touched from below if it is the lowest or belongs to a face that looks down.
  std::vector<bool> looks_down(topology_->faces.size()), is_lower(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) is_lower[v] = heights[v] - lowest <= 1e-12 * size_;
  for (std::size_t f = 0; f < topology_->faces.size(); ++f) {
    looks_down[f] = face_normal_S(static_cast<int>(f)).dot(n_S) < -kSteep;
    if (!looks_down[f]) continue;
    for (const int v : topology_->faces[f]) is_lower[at(v)] = true;
  }

  // Those vertices within reach, and the edges between faces that look down or vertices that can be touched.
  LowerSide side;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const int index = static_cast<int>(v);
    if (!is_lower[v] || heights[v] > reach) continue;
    side.points.push_back({in_O(vertices[v]), vertex_feature(index), vertex_is_real(index)});
  }
  for (std::size_t e = 0; e < topology_->edges.size(); ++e) {
    const ConvexHull::Edge& edge = topology_->edges[e];
    const bool is_near = std::min(heights[at(edge.v0)], heights[at(edge.v1)]) <= reach;
    const bool can_touch = looks_down[at(edge.f0)] || looks_down[at(edge.f1)] ||
                           (is_lower[at(edge.v0)] && is_lower[at(edge.v1)]);
    if (is_near && can_touch) side.lines.push_back(edge_line(static_cast<int>(e)));
  }
  return side;
}

/// Whether a cap lies flat on a face: its whole disk is within reach, or what of it lies over the face, or it
/// is flat to rounding. Over a small face a wide disk lies flat though its far rim is higher.
bool ContactShape::is_flat_over(const FlatFace& face, const FlatFace& disk, double reach) const {
  const double cosine = -disk.normal.dot(face.normal), sine = disk.normal.cross(face.normal).norm();
  if (cosine < kFacing) return false;
  const double at_center = face.normal.dot(disk.center - face.center);
  const double over_face = (face.center - disk.center).dot(disk.normal) / cosine;
  return sine <= 1e-12 || at_center + disk.radius * sine <= reach ||
         over_face + extent_of(face) * sine / cosine <= reach;
}

LowerSide ContactShape::round_lower_side(const FlatFace& face, double reach) const {
  LowerSide side;
  const Vec3 &n = face.normal, &p_plane = face.center, m = -n;
  const auto height = [&](const Vec3& p) { return n.dot(p - p_plane); };

  // A cap that lies flat stands on four points of its rim.
  for (const int index : {0, 1}) {
    const std::optional<FlatFace> disk = cap(index);
    if (!disk || !is_flat_over(face, *disk, reach)) continue;
    for (int k = 0; k < 4; ++k) {
      const double sign = k < 2 ? 1 : -1;
      const Vec3 p = disk->center + sign * disk->radius * X_OS_.R.col(k % 2);
      side.points.push_back({p, {Feature::Kind::vertex, 4 * index + k}});
    }
    side.disk = disk;
    return side;
  }

  // A surface that shows no straight line touches at its lowest point.
  const std::vector<SurfaceLine> lines = facing_rulings(n, p_plane, reach);
  if (lines.empty()) {
    const Vec3 lowest = support(m);
    side.points.push_back({lowest, classify(lowest, m)});
    return side;
  }
  // The ends of the lines, each once; at the lower end of a capsule the lowest point of its cap.
  Vec3 a = lines.front().a, b = lines.front().b;
  if (core_.kind == ConvexCore::Kind::segment) {
    const bool a_is_lower = height(a) <= height(b);
    const double sign = a_is_lower ? -1 : 1;
    (a_is_lower ? a : b) = X_OS_.p + sign * core_.size.z() * axis() + core_.radius * m;
  }
  side.points.push_back({a, lines.front().feature_a});
  side.points.push_back({b, lines.front().feature_b});
  for (std::size_t i = 1; i < lines.size(); ++i) side.points.push_back({lines[i].b, lines[i].feature_b});
  side.lines = lines;
  return side;
}

std::vector<SurfaceLine> ContactShape::facing_rulings(const Vec3& n, const Vec3& p_plane,
                                                      double reach) const {
  // Of a capsule or cylinder that stands, the higher end is not seen from below.
  const Vec3 m = -n;
  const bool is_straight =
      !has_rings() || (last_ring() == 1 && ring_of(core_, 0).radius == ring_of(core_, 1).radius);
  if (is_straight && !(std::abs(axis().dot(m)) < kFacing)) return {};
  std::vector<SurfaceLine> lines = rulings(m);
  if (lines.size() <= 1) return lines;

  // Of several sides those that face the plane: the neighbours of the lowest ring, and what is within reach.
  const int lowest = core_support(core_, direction_in_S(m)).piece;
  std::erase_if(lines, [&](const SurfaceLine& line) {
    const int i = line.feature.index;
    const std::optional<Vec3> normal = surface_normal(line.feature, 0.5 * (line.a + line.b));
    const double lower_end = std::min(n.dot(line.a - p_plane), n.dot(line.b - p_plane));
    return normal->dot(m) < kFacing || !(i == lowest || i + 1 == lowest || lower_end <= reach);
  });
  return lines;
}

SurfaceLine ContactShape::edge_line(int index) const {
  const ConvexHull::Edge& edge = topology_->edges[at(index)];
  return {in_O(vertices_S()[at(edge.v0)]),
          in_O(vertices_S()[at(edge.v1)]),
          {Feature::Kind::edge, facet_ ? facet_->edges[at(index)] : index},
          vertex_feature(edge.v0),
          vertex_feature(edge.v1),
          edge_is_real(index)};
}

std::vector<SurfaceLine> ContactShape::rulings(const Vec3& m) const {
  if (!has_rings() && core_.kind != ConvexCore::Kind::segment) return {};
  const Vec3 radial = m - m.dot(axis()) * axis();
  const double length = radial.norm();
  if (!(length > 0)) return {};
  const auto outward = [&](double radius) -> Vec3 { return radius / length * radial; };
  if (!has_rings()) return {capsule_ruling(outward(core_.radius))};

  std::vector<SurfaceLine> lines;
  for (int i = 0; i < last_ring(); ++i) {
    const Ring lower = ring_of(core_, i), upper = ring_of(core_, i + 1);
    lines.push_back({X_OS_.p + lower.z * axis() + outward(lower.radius),
                     X_OS_.p + upper.z * axis() + outward(upper.radius),
                     {Feature::Kind::side, i},
                     ring_feature(i),
                     ring_feature(i + 1)});
  }
  return lines;
}

SurfaceLine ContactShape::capsule_ruling(const Vec3& outward) const {
  const Vec3 along = core_.size.z() * axis();
  return {X_OS_.p - along + outward,
          X_OS_.p + along + outward,
          {Feature::Kind::side, 0},
          {Feature::Kind::side, 1},
          {Feature::Kind::side, 2}};
}

Feature ContactShape::ring_feature(int ring) const {
  if (ring_of(core_, ring).radius > 0) return {Feature::Kind::edge, ring};
  return {Feature::Kind::vertex, ring == 0 ? 0 : 4};
}

std::optional<double> ContactShape::height_above(const Vec3& p, const Vec3& n,
                                                 const std::optional<FlatFace>& disk, double slack) const {
  if (disk) {
    const double t = (disk->center - p).dot(disk->normal) / n.dot(disk->normal);
    const bool hits = (p + t * n - disk->center).norm() <= disk->radius + slack;
    return hits ? std::optional<double>(t) : std::nullopt;
  }
  if (!is_polyhedron()) return {};
  // The line enters a convex body where the last of the faces that look down is crossed.
  const Vec3 p_S = in_S(p), n_S = direction_in_S(n);
  const auto depth_below = [&](std::size_t f, const Vec3& q_S) {
    return face_normal_S(static_cast<int>(f)).dot(vertices_S()[at(topology_->faces[f].front())] - q_S);
  };
  double t = -std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < topology_->faces.size(); ++f) {
    const double slope = face_normal_S(static_cast<int>(f)).dot(n_S);
    if (slope < -kSteep) t = std::max(t, depth_below(f, p_S) / slope);
  }
  if (!std::isfinite(t)) return {};
  // A facet has no side faces: there its edges decide.
  const Vec3 q_S = p_S + t * n_S;
  if (facet_) {
    const std::size_t count = own_vertices_S_.size();
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 inward =
          facet_->normal.cross(own_vertices_S_[(k + 1) % count] - own_vertices_S_[k]).normalized();
      if (inward.dot(q_S - own_vertices_S_[k]) < -slack) return {};
    }
    return t;
  }
  for (std::size_t f = 0; f < topology_->faces.size(); ++f) {
    if (depth_below(f, q_S) < -slack) return {};
  }
  return t;
}

std::vector<SurfaceLine> ContactShape::lines_along(const Vec3& m, double reach) const {
  std::vector<SurfaceLine> lines;
  if (is_plane()) return lines;
  if (!is_polyhedron()) {
    const double top = m.dot(support(m));
    for (const SurfaceLine& line : rulings(m)) {
      if (std::min(m.dot(line.a), m.dot(line.b)) >= top - reach) lines.push_back(line);
    }
    return lines;
  }
  // Edges of a polyhedron with both ends within reach of the farthest vertex.
  const Vec3 m_S = direction_in_S(m);
  const std::vector<Vec3>& vertices = vertices_S();
  const double top = m_S.dot(core_support(core_, m_S).p);
  for (std::size_t e = 0; e < topology_->edges.size(); ++e) {
    const ConvexHull::Edge& edge = topology_->edges[e];
    const double lower_end = std::min(m_S.dot(vertices[at(edge.v0)]), m_S.dot(vertices[at(edge.v1)]));
    if (lower_end >= top - reach) lines.push_back(edge_line(static_cast<int>(e)));
  }
  return lines;
}

Feature ContactShape::classify(const Vec3& p, const Vec3& m) const {
  using Kind = Feature::Kind;
  if (is_plane()) return {Kind::face, 0};
  if (is_polyhedron()) return classify_on_polyhedron(p);
  const Vec3 p_S = in_S(p);
  if (has_rings()) return ring_feature_at(p_S, direction_in_S(m));
  const bool at_end = std::abs(p_S.z()) >= core_.size.z() - 1e-7 * size_;
  if (core_.kind == ConvexCore::Kind::segment && at_end) return {Kind::side, p_S.z() > 0 ? 2 : 1};
  return {Kind::side, 0};
}

Feature ContactShape::ring_feature_at(const Vec3& p_S, const Vec3& m_S) const {
  using Kind = Feature::Kind;
  // What is nearer to a rim, an apex or a cap's border than this is on it.
  const double near = 1e-7 * size_;
  const double z = p_S.z(), from_axis = p_S.head<2>().norm();

  // At the ends: an apex, the cap if the normal is its, else its rim.
  const Ring lowest = ring_of(core_, 0), highest = ring_of(core_, last_ring());
  const bool is_upper = z > 0.5 * (lowest.z + highest.z);
  const Ring& end = is_upper ? highest : lowest;
  if (is_upper ? z >= end.z - near : z <= end.z + near) {
    const bool is_inside = end.radius > 0 && from_axis < end.radius - near;
    if (is_inside && m_S.head<2>().norm() < 1e-6) return {Kind::face, is_upper ? 1 : 0};
    return ring_feature(is_upper ? last_ring() : 0);
  }

  // Between them a rim, or the side over the last ring below the point.
  int below = 0;
  for (int i = 1; i < last_ring(); ++i) {
    const Ring ring = ring_of(core_, i);
    if (std::hypot(from_axis - ring.radius, z - ring.z) <= near) return {Kind::edge, i};
    if (ring.z <= z) below = i;
  }
  return {Kind::side, below};
}

Feature ContactShape::classify_on_polyhedron(const Vec3& p) const {
  const double near = 1e-7 * size_;
  const Vec3 p_S = in_S(p);
  const std::vector<Vec3>& vertices = vertices_S();
  // The nearest vertex, if the point is on it.
  double best = std::numeric_limits<double>::infinity();
  Feature feature;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const double distance = (vertices[v] - p_S).norm();
    if (distance >= best) continue;
    best = distance;
    feature = vertex_feature(static_cast<int>(v));
  }
  if (best <= near) return feature;
  best = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < topology_->edges.size(); ++e) {
    const ConvexHull::Edge& edge = topology_->edges[e];
    const Vec3 along = vertices[at(edge.v1)] - vertices[at(edge.v0)];
    const Vec3 from = p_S - vertices[at(edge.v0)];
    const double place = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (from - place * along).norm();
    if (distance >= best) continue;
    best = distance;
    feature = {Feature::Kind::edge, facet_ ? facet_->edges[e] : static_cast<int>(e)};
  }
  if (best <= near) return feature;
  best = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < topology_->faces.size(); ++f) {
    const double distance =
        std::abs(face_normal_S(static_cast<int>(f)).dot(p_S - vertices[at(topology_->faces[f].front())]));
    if (distance >= best) continue;
    best = distance;
    feature = face_feature(static_cast<int>(f));
  }
  return feature;
}

}  // namespace rigor
