#include "rigor/geometry/contacts/contact_shape.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/aabb.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {
namespace {

/// Vertices, edges and faces of all boxes, whatever their size.
const ConvexHull& box_topology() {
  static const ConvexHull topology = make_box_hull(Vec3::Ones());
  return topology;
}

/// A polygon as a polyhedron with a front and a back. Edge k runs from corner k to the next.
ConvexHull make_polygon_topology(int count) {
  ConvexHull topology;
  topology.vertices.assign(at(count), Vec3::Zero());
  topology.face_normals = {Vec3::UnitZ(), -Vec3::UnitZ()};
  topology.faces.resize(2);
  for (int k = 0; k < count; ++k) {
    topology.faces[0].push_back(k);
    topology.faces[1].push_back((count - k) % count);
    topology.edges.push_back({k, (k + 1) % count, 0, 1});
  }
  return topology;
}

const ConvexHull& triangle_topology() {
  static const ConvexHull topology = make_polygon_topology(3);
  return topology;
}

double longest_side(const std::vector<Vec3>& points) {
  Vec3 lower = points.front(), upper = points.front();
  for (const Vec3& p : points) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  return (upper - lower).maxCoeff();
}

double polygon_area(const std::vector<FaceCorner>& corners, const Vec3& normal) {
  Vec3 twice = Vec3::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k) {
    twice += (corners[k - 1].p - corners[0].p).cross(corners[k].p - corners[0].p);
  }
  return 0.5 * twice.dot(normal);
}

/// 2 bits for the kind, 1 for the part, 29 for the index.
std::uint64_t code(const Feature& feature) {
  return static_cast<std::uint64_t>(feature.kind) << 30 | static_cast<std::uint64_t>(feature.part & 1) << 29 |
         (static_cast<std::uint64_t>(feature.index) & 0x1fffffff);
}

Feature decoded(std::uint64_t code) {
  return {static_cast<Feature::Kind>(code >> 30 & 3), static_cast<int>(code & 0x1fffffff),
          static_cast<int>(code >> 29 & 1)};
}

}  // namespace

std::uint64_t feature_pair(const Feature& a, const Feature& b) {
  return code(a) << 32 | code(b);
}

Feature first_feature(std::uint64_t pair) {
  return decoded(pair >> 32);
}

Feature second_feature(std::uint64_t pair) {
  return decoded(pair & 0xffffffff);
}

ContactShape::ContactShape(const Shape& shape, const Pose& X_OS) : shape_(&shape), X_OS_(X_OS) {
  RIGOR_ASSERT(!std::holds_alternative<Mesh>(shape));
  if (is_plane()) return;
  core_ = make_core(shape);
  const Aabb box = axis_aligned_box(shape, Pose{});
  size_ = (box.upper - box.lower).maxCoeff();
  if (const Box* s = std::get_if<Box>(&shape)) {
    topology_ = &box_topology();
    own_vertices_S_.reserve(topology_->vertices.size());
    for (const Vec3& signs : topology_->vertices)
      own_vertices_S_.push_back(signs.cwiseProduct(s->half_extents));
  }
  if (const Convex* s = std::get_if<Convex>(&shape)) topology_ = s->hull.get();
}

ContactShape::ContactShape(const MeshFacet& facet, const Pose& X_OM) : facet_(facet) {
  // A frame at the first corner keeps the digits of small facets far from the origin of the mesh.
  X_OS_ = {X_OM.R, X_OM * facet.corners[0]};
  for (const Vec3& p_M : facet.corners) own_vertices_S_.push_back(p_M - facet.corners[0]);
  core_ = make_points_core(own_vertices_S_);
  size_ = longest_side(own_vertices_S_);
  if (facet.corners.size() > 3) own_topology_ = make_polygon_topology(static_cast<int>(facet.corners.size()));
  topology_ = own_topology_ ? &*own_topology_ : &triangle_topology();
}

const std::vector<Vec3>& ContactShape::vertices_S() const {
  return own_vertices_S_.empty() ? topology_->vertices : own_vertices_S_;
}

Vec3 ContactShape::face_normal_S(int face) const {
  if (facet_) return face == 0 ? facet_->normal : (-facet_->normal).eval();
  return topology_->face_normals[at(face)];
}

Feature ContactShape::vertex_feature(int vertex) const {
  return {Feature::Kind::vertex, facet_ ? facet_->vertices[at(vertex)] : vertex};
}

Feature ContactShape::face_feature(int face) const {
  return {Feature::Kind::face, facet_ ? facet_->patch : face};
}

bool ContactShape::vertex_is_real(int vertex) const {
  return !facet_ || facet_->corner_is_real[at(vertex)];
}

bool ContactShape::edge_is_real(int edge) const {
  return !facet_ || facet_->edge_is_real[at(edge)];
}

Feature ContactShape::edge_feature(int v0, int v1) const {
  for (std::size_t e = 0; e < topology_->edges.size(); ++e) {
    const ConvexHull::Edge& edge = topology_->edges[e];
    const bool matches = (edge.v0 == v0 && edge.v1 == v1) || (edge.v0 == v1 && edge.v1 == v0);
    if (matches) return {Feature::Kind::edge, facet_ ? facet_->edges[e] : static_cast<int>(e)};
  }
  const bool is_edge = false;  // Every two neighbours in the loop of a face share one.
  RIGOR_ASSERT(is_edge);
  return {};
}

Vec3 ContactShape::support(const Vec3& m) const {
  const Vec3 m_S = direction_in_S(m);
  return in_O(core_support(core_, m_S).p) + core_.radius * m;
}

FlatFace ContactShape::polygon(int face) const {
  FlatFace result{.feature = face_feature(face),
                  .normal = X_OS_.R * face_normal_S(face),
                  .center = in_O(vertices_S()[at(topology_->faces[at(face)].front())])};
  const std::vector<int>& loop = topology_->faces[at(face)];
  result.corners.reserve(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k) {
    FaceCorner corner{in_O(vertices_S()[at(loop[k])]), loop[k]};
    if (facet_) {
      // In the loop of the back, 0 n-1 n-2 ... 1, the edges follow each other from the last to the first.
      const int edge = static_cast<int>(face == 0 ? k : loop.size() - 1 - k);
      corner.is_real = vertex_is_real(loop[k]);
      corner.edge_is_real = edge_is_real(edge);
    }
    result.corners.push_back(corner);
  }
  // On a tie between two faces the larger one gives the normal; a face of a mesh stands for its whole patch.
  result.area = facet_ ? facet_->patch_area : polygon_area(result.corners, result.normal);
  return result;
}

std::optional<FlatFace> ContactShape::cap(int index) const {
  if (!has_rings()) return {};
  const Ring end = ring_of(core_, index == 0 ? 0 : last_ring());
  if (end.radius == 0) return {};
  const double sign = index == 0 ? -1 : 1;
  return FlatFace{.kind = FlatFace::Kind::disk,
                  .feature = {Feature::Kind::face, index},
                  .normal = sign * axis(),
                  .center = X_OS_.p + end.z * axis(),
                  .radius = end.radius,
                  .area = std::numbers::pi * end.radius * end.radius};
}

std::vector<FlatFace> ContactShape::faces_near(const Vec3& p, double reach) const {
  std::vector<FlatFace> faces;
  if (is_polyhedron()) {
    const Vec3 p_S = in_S(p);
    for (int f = 0; f < static_cast<int>(topology_->faces.size()); ++f) {
      const Vec3& corner = vertices_S()[at(topology_->faces[at(f)].front())];
      if (std::abs(face_normal_S(f).dot(p_S - corner)) <= reach) faces.push_back(polygon(f));
    }
  }
  for (const int index : {0, 1}) {
    const std::optional<FlatFace> disk = cap(index);
    if (disk && std::abs(disk->normal.dot(p - disk->center)) <= reach) faces.push_back(*disk);
  }
  return faces;
}

namespace {

/// Unit vector across the axis, square to the outward normal m; zero where m lies along the axis.
Vec3 across(const Vec3& axis, const Vec3& m) {
  const Vec3 t = axis.cross(m);
  const double length = t.norm();
  return length > 0 ? (t / length).eval() : Vec3::Zero().eval();
}

Mat3 ball_radius(double radius, const Vec3& m) {
  return radius * (Mat3::Identity() - m * m.transpose());
}

/// Hessian of h(m) = |D m|, D = diag(radii): (D² - p pᵀ) / h with p = D² m / h.
Mat3 ellipsoid_radius(const Vec3& radii, const Mat3& R_OS, const Vec3& m) {
  const Vec3 m_S = R_OS.transpose() * m;
  const Vec3 squares = radii.cwiseAbs2();
  const double h = radii.cwiseProduct(m_S).norm();
  const Vec3 p = squares.cwiseProduct(m_S) / h;
  const Mat3 square_matrix = squares.asDiagonal();
  const Mat3 radius_S = (square_matrix - p * p.transpose()) / h;
  return R_OS * radius_S * R_OS.transpose();
}

/// A rim of radius R has h(m) = R |m_xy| + const: its Hessian is R / |m_xy| t tᵀ.
Mat3 rim_radius(double radius, const Vec3& axis, const Vec3& m) {
  const double sine = axis.cross(m).norm();
  const Vec3 t = across(axis, m);
  return sine > 0 ? (radius / sine * t * t.transpose()).eval() : Mat3::Zero().eval();
}

}  // namespace

std::optional<Vec3> ContactShape::surface_normal(const Feature& feature, const Vec3& p) const {
  if (feature.kind != Feature::Kind::side) return {};
  const Vec3 p_S = in_S(p);
  const double half_length = core_.size.z();
  Vec3 normal_S = p_S;  // Of a ball.
  switch (core_.kind) {
    case ConvexCore::Kind::ellipsoid:
      normal_S = p_S.cwiseQuotient(core_.size).cwiseQuotient(core_.size);
      break;
    case ConvexCore::Kind::segment:
      normal_S.z() -= std::clamp(p_S.z(), -half_length, half_length);
      break;
    case ConvexCore::Kind::rings: {
      // Square to the line between the two rings.
      const Ring lower = ring_of(core_, feature.index), upper = ring_of(core_, feature.index + 1);
      normal_S.z() = p_S.head<2>().norm() * (lower.radius - upper.radius) / (upper.z - lower.z);
      break;
    }
    case ConvexCore::Kind::point:
    case ConvexCore::Kind::points:
    case ConvexCore::Kind::box:
      break;
  }
  return X_OS_.R * normal_S.normalized();
}

SurfaceCurvature ContactShape::curvature(const Feature& feature, const Vec3& p, const Vec3& m) const {
  SurfaceCurvature result;
  // A face is flat in two directions; a vertex is all normals at one point.
  if (feature.kind == Feature::Kind::face) result.flat_count = 2;
  if (feature.kind == Feature::Kind::face || feature.kind == Feature::Kind::vertex) return result;
  if (is_polyhedron()) {
    int e = feature.index;
    if (facet_) e = static_cast<int>(std::ranges::find(facet_->edges, e) - facet_->edges.begin());
    const ConvexHull::Edge& edge = topology_->edges[at(e)];
    result.flat_count = 1;
    result.flat_W = X_OS_.R * (vertices_S()[at(edge.v1)] - vertices_S()[at(edge.v0)]).normalized();
    return result;
  }
  if (core_.kind == ConvexCore::Kind::ellipsoid) {
    result.radius_W = ellipsoid_radius(core_.size, X_OS_.R, m);
  } else if (feature.kind == Feature::Kind::edge) {
    result.radius_W = rim_radius(ring_of(core_, feature.index).radius, axis(), m);
  } else if (!has_rings() && (core_.kind == ConvexCore::Kind::point || feature.index > 0)) {
    result.radius_W = ball_radius(core_.radius, m);
  } else {
    // A ruled side: flat along the line, and across it the distance from the axis along the normal.
    const Vec3 t = across(axis(), m);
    const Vec3 from_axis = p - X_OS_.p - axis().dot(p - X_OS_.p) * axis();
    const double sine = axis().cross(m).norm();
    result.radius_W = from_axis.norm() / sine * t * t.transpose();
    result.flat_count = 1;
    result.flat_W = m.cross(t);
  }
  return result;
}

}  // namespace rigor
