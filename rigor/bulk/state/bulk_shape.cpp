#include "rigor/bulk/state/bulk_shape.hpp"

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

void pad(std::vector<float>& column) {
  while (!column.empty() && column.size() % kLaneCount != 0) column.push_back(column.back());
}

void add_vertex(const Vec3& v, FloatHull& hull) {
  hull.x.push_back(static_cast<float>(v.x()));
  hull.y.push_back(static_cast<float>(v.y()));
  hull.z.push_back(static_cast<float>(v.z()));
  hull.extent = std::max(hull.extent, static_cast<float>(v.norm()));
  ++hull.vertex_count;
}

void pad_columns(FloatHull& hull) {
  for (std::vector<float>* column : {&hull.x, &hull.y, &hull.z, &hull.nx, &hull.ny, &hull.nz, &hull.offset})
    pad(*column);
}

void add_edges_around(FloatHull& hull) {
  hull.around_begin.clear();
  hull.around.clear();
  for (int v = 0; v < hull.vertex_count; ++v) {
    hull.around_begin.push_back(static_cast<int>(hull.around.size()));
    for (std::size_t e = 0; e < hull.edges.size(); ++e)
      if (hull.edges[e].v0 == v || hull.edges[e].v1 == v) hull.around.push_back(static_cast<int>(e));
  }
  hull.around_begin.push_back(static_cast<int>(hull.around.size()));
}

/// A hull without faces and with one edge between its first and its last vertex.
FloatHull make_line(const std::vector<Vec3>& vertices) {
  FloatHull hull;
  for (const Vec3& v : vertices) add_vertex(v, hull);
  hull.edges.push_back({0, hull.vertex_count - 1, -1, -1});
  hull.loop_begin.push_back(0);
  hull.fan_begin.assign(vertices.size() + 1, 0);
  add_edges_around(hull);
  pad_columns(hull);
  return hull;
}

/// Adds the faces with their loops; edges are in the order of the half-edges that come first.
void add_faces(const FeatureGraph& graph, FloatHull& hull) {
  std::vector<int> edge_of(graph.half_edges.size(), -1);
  for (std::size_t h = 0; h < graph.half_edges.size(); ++h) {
    const FeatureGraph::HalfEdge& half = graph.half_edges[h];
    // Of two half-edges, the first makes the edge.
    if (edge_of[at(half.twin)] >= 0) {
      edge_of[h] = edge_of[at(half.twin)];
    } else {
      edge_of[h] = static_cast<int>(hull.edges.size());
      const int face = graph.half_edge(half.twin).face;
      const float cosine = static_cast<float>(graph.normal(half.face).dot(graph.normal(face)));
      if (cosine < 0) hull.sharp_edges.push_back(static_cast<int>(hull.edges.size()));
      hull.edges.push_back({half.from, half.to, half.face, face, cosine});
    }
    hull.loop.push_back(half.from);
    hull.loop_edges.push_back(edge_of[h]);
  }
  hull.loop_begin = graph.face_begin;
  hull.face_count = graph.face_count();
}

void add_fans(FloatHull& hull) {
  // The faces around each vertex, in ascending order.
  std::vector<std::vector<int>> faces(at(hull.vertex_count));
  for (int f = 0; f < hull.face_count; ++f)
    for (int k = hull.loop_begin[at(f)]; k < hull.loop_begin[at(f + 1)]; ++k)
      faces[at(hull.loop[at(k)])].push_back(f);
  for (const std::vector<int>& fan : faces) {
    hull.fan_begin.push_back(static_cast<int>(hull.fan.size()));
    hull.fan.insert(hull.fan.end(), fan.begin(), fan.end());
  }
  hull.fan_begin.push_back(static_cast<int>(hull.fan.size()));
}

void add_arcs(FloatHull& hull) {
  // An arc has what the test on the Gauss map needs of its edge, in two rows of lanes.
  hull.arcs.clear();
  for (const FloatHull::Edge& edge : hull.edges) {
    FloatHull::ArcRecord& arc = hull.arcs.emplace_back();
    const Vec3f from = hull.vertex(edge.v0), along = hull.vertex(edge.v1) - from;
    for (int k = 0; k < 3; ++k) {
      arc.along[k] = along[k];
      arc.normal_0[k] = hull.normal(edge.f0)[k];
      arc.normal_1[k] = hull.normal(edge.f1)[k];
      arc.point[k] = from[k];
    }
  }
}

void find_lone_faces(FloatHull& hull) {
  const float cosine = std::cos(0.02f);
  hull.is_lone.assign(at(hull.face_count), 1);
  for (int f = 0; f < hull.face_count; ++f)
    for (int g = 0; g < f; ++g)
      if (hull.normal(f).dot(hull.normal(g)) > cosine) hull.is_lone[at(f)] = hull.is_lone[at(g)] = 0;
}

/// Numbers the edges of a box by axis and then by their vertices: 4 axis + the sign bits without that of the
/// axis.
void number_box_edges(FloatHull& hull) {
  std::vector<int> order(hull.edges.size()), number(hull.edges.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int e) {
    const FloatHull::Edge& edge = hull.edges[at(e)];
    return std::pair(edge.v0 ^ edge.v1, std::min(edge.v0, edge.v1));
  };
  // The vertices of an edge differ in the bit of its axis.
  std::sort(order.begin(), order.end(), [&](int d, int e) { return key(d) < key(e); });
  std::vector<FloatHull::Edge> edges;
  for (const int e : order) {
    number[at(e)] = static_cast<int>(edges.size());
    edges.push_back(hull.edges[at(e)]);
  }
  // All lists that name edges take the new numbers.
  hull.edges = edges;
  for (int& e : hull.loop_edges) e = number[at(e)];
  for (int& e : hull.sharp_edges) e = number[at(e)];
  add_edges_around(hull);
  add_arcs(hull);
}

}  // namespace

FloatHull make_float_hull(const FeatureGraph& graph, const std::vector<Vec3>& vertices) {
  FloatHull hull;
  // The middle of the vertices, which is the centre of a ball inside.
  Vec3 center = Vec3::Zero();
  for (const Vec3& v : vertices) add_vertex(v, hull), center += v;
  center /= static_cast<double>(vertices.size());
  add_faces(graph, hull);
  add_fans(hull);
  add_edges_around(hull);
  // Planes of the faces; the ball reaches to the nearest of them.
  double inner = hull.extent;
  for (int f = 0; f < hull.face_count; ++f) {
    const Vec3& n = graph.normal(f);
    const double offset = n.dot(vertices[at(hull.loop[at(hull.loop_begin[at(f)])])]);
    hull.nx.push_back(static_cast<float>(n.x()));
    hull.ny.push_back(static_cast<float>(n.y()));
    hull.nz.push_back(static_cast<float>(n.z()));
    hull.offset.push_back(static_cast<float>(offset));
    inner = std::min(inner, offset - n.dot(center));
  }
  hull.center = center.cast<float>();
  find_lone_faces(hull);
  add_arcs(hull);
  // Rounding must not make the ball larger than it is.
  hull.inner = std::max(0.0f, static_cast<float>(inner) - 1e-5f * hull.extent);
  pad_columns(hull);
  return hull;
}

FloatRings make_float_rings(const Ring& lower, const Ring& upper) {
  const double height = upper.z - lower.z, inward = lower.radius - upper.radius;
  const double slant = std::hypot(height, inward);
  FloatRings rings{.z = {static_cast<float>(lower.z), static_cast<float>(upper.z)},
                   .r = {static_cast<float>(lower.radius), static_cast<float>(upper.radius)}};
  if (slant > 0) {
    rings.k = static_cast<float>(inward / slant);
    rings.square = static_cast<float>(height / slant);
  }
  // The ball between both caps, if the side is far enough there; else one that touches the larger cap and the
  // side: at the height x over the cap of the radius r, the side is at the distance (r h - x d) / slant.
  const double r = std::max(lower.radius, upper.radius), d = std::abs(inward);
  const double inner = std::min(0.5 * height, r * height / (slant + d));
  const double shift = inward == 0 ? 0.5 * height - inner : 0, up = inward >= 0 ? 1 : -1;
  rings.inner = static_cast<float>(inner * (1 - 1e-5));
  rings.ball = static_cast<float>(inward == 0 ? 0.5 * (lower.z + upper.z)
                                              : (inward > 0 ? lower.z : upper.z) + up * inner);
  rings.ball_shift = static_cast<float>(shift);
  rings.ball_across = static_cast<float>(inward == 0 ? r - inner : 0);
  return rings;
}

FloatHulls::FloatHulls() {
  const ConvexHull unit_box = make_box_hull(Vec3::Ones());
  FloatHull numbered = make_float_hull(unit_box.features, unit_box.vertices);
  number_box_edges(numbered);
  box = std::make_shared<const FloatHull>(numbered);
  segment = std::make_shared<const FloatHull>(make_line({-Vec3::UnitZ(), Vec3::UnitZ()}));
  point = std::make_shared<const FloatHull>(make_line({Vec3::Zero()}));
}

namespace {

/// Fills in the kind of a shape, and the core of those that the narrow phase treats in 32 bits.
struct FillCore {
  FloatHulls& hulls;
  BulkShape& bulk;

  void operator()(const Sphere& s) const {
    bulk.kind = BulkShape::Kind::round;
    bulk.hull = hulls.point;
    bulk.radius = static_cast<float>(s.radius);
  }
  void operator()(const Capsule& s) const {
    bulk.kind = BulkShape::Kind::round;
    bulk.hull = hulls.segment;
    bulk.radius = static_cast<float>(s.radius);
    bulk.extent = static_cast<float>(s.half_length);
    bulk.scale.z() = bulk.extent;
    bulk.ball_shift.z() = bulk.extent;
    bulk.rings = make_float_rings({0, -s.half_length}, {0, s.half_length});
  }
  void operator()(const Box& s) const {
    bulk.kind = BulkShape::Kind::box;
    bulk.hull = hulls.box;
    bulk.scale = s.half_extents.cast<float>();
    bulk.extent = bulk.scale.norm();
    bulk.ball_shift = bulk.scale - Vec3f::Constant(bulk.hull->inner * bulk.scale.minCoeff());
  }
  void operator()(const HalfSpace&) const { bulk.kind = BulkShape::Kind::plane; }
  void operator()(const Convex& s) const {
    if (s.hull->edges.size() >= kMaxHullEdges) return;
    bulk.kind = BulkShape::Kind::hull;
    // Shapes that share a hull share its copy in 32 bits.
    const auto known = std::find_if(hulls.convex.begin(), hulls.convex.end(),
                                    [&](const auto& entry) { return entry.first == s.hull.get(); });
    if (known != hulls.convex.end()) {
      bulk.hull = known->second;
    } else {
      bulk.hull = std::make_shared<const FloatHull>(make_float_hull(s.hull->features, s.hull->vertices));
      hulls.convex.emplace_back(s.hull.get(), bulk.hull);
    }
    bulk.extent = bulk.hull->extent;
  }
  /// A mesh that bounds a convex solid is that solid.
  void operator()(const Mesh& s) const {
    if (s.tree->convex != nullptr) std::visit(*this, *s.tree->convex);
    if (bulk.kind != BulkShape::Kind::other) return;
    bulk.kind = BulkShape::Kind::mesh;
    const auto known = std::find_if(hulls.meshes.begin(), hulls.meshes.end(),
                                    [&](const auto& entry) { return entry.first == s.tree.get(); });
    if (known != hulls.meshes.end()) {
      bulk.mesh = known->second;
    } else {
      bulk.mesh = make_float_mesh(s);
      hulls.meshes.emplace_back(s.tree.get(), bulk.mesh);
    }
  }
  void operator()(const Ellipsoid& s) const {
    bulk.kind = BulkShape::Kind::ellipsoid;
    bulk.scale = s.radii.cast<float>();
    bulk.extent = bulk.scale.maxCoeff();
  }
  void operator()(const Cavity&) const {}  // Only treated in double precision.

  void operator()(const Cylinder& s) const {
    fill_rings({s.radius, -s.half_length}, {s.radius, s.half_length});
  }
  void operator()(const Cone& s) const { fill_rings({s.radius, -s.half_length}, {0, s.half_length}); }
  /// Of more than two rings: in double precision.
  void operator()(const Revolution& s) const {
    if (s.rings->size() == 2) fill_rings(s.rings->front(), s.rings->back());
  }
  void fill_rings(const Ring& lower, const Ring& upper) const {
    bulk.kind = BulkShape::Kind::rings;
    bulk.rings = make_float_rings(lower, upper);
    bulk.extent =
        static_cast<float>(std::max(std::hypot(lower.radius, lower.z), std::hypot(upper.radius, upper.z)));
  }
};

}  // namespace

BulkShape make_bulk_shape(const BodyShape& shape, FloatHulls& hulls) {
  BulkShape bulk{.shape = &shape.shape, .X_BS = shape.X_BS};
  bulk.is_body_frame = shape.X_BS.R.isIdentity(0) && shape.X_BS.p.isZero(0);
  std::visit(FillCore{hulls, bulk}, shape.shape);
  const Aabb box = axis_aligned_box(shape.shape, Pose{});
  bulk.size = static_cast<float>((box.upper - box.lower).maxCoeff());
  return bulk;
}

PlacedShape place_shape(const BulkShape& shape, const Quat& q_WB) {
  // The products are in 64 bits and rounded once.
  const Mat3 R_WB = q_WB.toRotationMatrix();
  const Mat3 R_WS = shape.is_body_frame ? R_WB : Mat3(R_WB * shape.X_BS.R);
  const Vec3 p = shape.is_body_frame ? Vec3(Vec3::Zero()) : Vec3(R_WB * shape.X_BS.p);
  PlacedShape placed;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) placed.R[3 * i + j] = static_cast<float>(R_WS(i, j));
    placed.p[i] = static_cast<float>(p[i]);
    placed.half[i] = shape.scale[i];
  }
  placed.extent = shape.extent;
  return placed;
}

}  // namespace rigor
