#include "rigor/bulk/collide_polytopes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// One core over a face of another.
struct FaceView {
  const PlacedPolytope& owner;  ///< Of the face.
  const PlacedPolytope& other;
  int face;
  bool is_of_A;
  Vec3f m;  ///< Outward normal of the face.

  float height(const Vec3f& p) const { return m.dot(p) - owner.offset[at(face)]; }
  int begin() const { return owner.hull->loop_begin[at(face)]; }
  int end() const { return owner.hull->loop_begin[at(face + 1)]; }
  Vec3f corner(int k) const { return owner.vertex(owner.hull->loop[at(k == end() ? begin() : k)]); }
};

/// The border of the face between two corners.
struct Border {
  Vec3f corner, along, inward;  ///< Unit vectors.
  float length;
};

Border border_of(const FaceView& view, int k) {
  const Vec3f corner = view.corner(k), side = view.corner(k + 1) - corner;
  const float length = side.norm();
  const Vec3f along = side / length;
  return {corner, along, view.m.cross(along), length};
}

/// Adds the point of the other core, which is `height` above its foot on the face.
float add_above(const FaceView& view, const Vec3f& p, float height, std::uint32_t feature, float margin,
                PolytopeScratch& pair) {
  const float gap = height - pair.a.radius - pair.b.radius;
  if (gap > margin) return gap;
  // The middle of the cores' points, moved to the middle of the surfaces'.
  const float shift = 0.5f * (pair.a.radius - pair.b.radius);
  const Vec3f middle = p - 0.5f * height * view.m + (view.is_of_A ? shift : -shift) * view.m;
  pair.candidates.push_back({middle, gap, feature});
  return gap;
}

int lowest_vertex(const FaceView& view) {
  int lowest = 0;
  float least = kInfinity;
  for (int v = 0; v < view.other.hull->vertex_count; ++v) {
    const float height = view.m.dot(view.other.vertex(v));
    if (height < least) least = height, lowest = v;
  }
  return lowest;
}

/// The face around the vertex that is turned to the view most; -1 if there are none.
int facing_face(const FaceView& view, int vertex) {
  const FloatHull& hull = *view.other.hull;
  int face = -1;
  float least = kInfinity;
  for (int k = hull.fan_begin[at(vertex)]; k < hull.fan_begin[at(vertex + 1)]; ++k) {
    const float along = view.m.dot(view.other.normal(hull.fan[at(k)]));
    if (along < least) least = along, face = hull.fan[at(k)];
  }
  return face;
}

std::uint32_t vertex_feature(bool is_of_A, int vertex) {
  return is_of_A ? vertex_A_feature(vertex) : vertex_B_feature(vertex);
}

bool lies_over_face(const FaceView& view, const Vec3f& p, float slack) {
  for (int k = view.begin(); k < view.end(); ++k) {
    const Border border = border_of(view, k);
    if (border.inward.dot(p - border.corner) < -slack) return false;
  }
  return true;
}

/// Where the edge of the other core crosses the border of the face; grazing does not count.
float add_crossings(const FaceView& view, int edge, float margin, float slack, PolytopeScratch& pair) {
  const FloatHull::Edge& line = view.other.edge(edge);
  const Vec3f p0 = view.other.vertex(line.v0), p1 = view.other.vertex(line.v1);
  float least = kInfinity;
  for (int k = view.begin(); k < view.end(); ++k) {
    const Border border = border_of(view, k);
    const float d0 = border.inward.dot(p0 - border.corner), d1 = border.inward.dot(p1 - border.corner);
    if (std::min(d0, d1) >= -slack || std::max(d0, d1) <= slack) continue;
    const Vec3f p = p0 + d0 / (d0 - d1) * (p1 - p0);
    const float along = border.along.dot(p - border.corner);
    if (along <= slack || along >= border.length - slack) continue;
    const int own = view.owner.hull->loop_edges[at(k)];
    const std::uint32_t feature = view.is_of_A ? crossing_feature(own, edge, view.other.hull->edges.size())
                                               : crossing_feature(edge, own, view.owner.hull->edges.size());
    least = std::min(least, add_above(view, p, view.height(p), feature, margin, pair));
  }
  return least;
}

/// Whether the face of the other core covers p, seen along the normal of the view.
bool is_covered(const FaceView& view, int face, const Vec3f& p, float slack) {
  const FloatHull& hull = *view.other.hull;
  const int begin = hull.loop_begin[at(face)], end = hull.loop_begin[at(face + 1)];
  for (int k = begin; k < end; ++k) {
    const Vec3f corner = view.other.vertex(hull.loop[at(k)]);
    const Vec3f next = view.other.vertex(hull.loop[at(k + 1 == end ? begin : k + 1)]);
    const Vec3f outward = view.m.cross(next - corner);
    if (outward.dot(p - corner) > slack * outward.norm()) return false;
  }
  return true;
}

/// Corners of the face of the view that the face of the other core covers.
float add_corners(const FaceView& view, int face, float margin, float slack, PolytopeScratch& pair) {
  constexpr float least_slope = 0.05f;  // Heights above steeper faces are lost in rounding.
  const Vec3f normal = view.other.normal(face);
  const float slope = -normal.dot(view.m);
  float least = kInfinity;
  if (slope < least_slope) return least;
  for (int k = view.begin(); k < view.end(); ++k) {
    const Vec3f corner = view.corner(k);
    if (!is_covered(view, face, corner, slack)) continue;
    const float height = (normal.dot(corner) - view.other.offset[at(face)]) / slope;
    const std::uint32_t feature = vertex_feature(view.is_of_A, view.owner.hull->loop[at(k)]);
    least = std::min(least, add_above(view, corner + height * view.m, height, feature, margin, pair));
  }
  return least;
}

FaceView view_of(const SeparatingAxis& axis, const PolytopeScratch& pair) {
  if (axis.kind == SeparatingAxis::Kind::face_of_A) return {pair.a, pair.b, axis.a, true, axis.n};
  return {pair.b, pair.a, axis.b, false, -axis.n};
}

/// The lowest point of the other core, wherever it is.
void add_lowest(const SeparatingAxis& axis, float margin, PolytopeScratch& pair) {
  const FaceView view = view_of(axis, pair);
  const int vertex = lowest_vertex(view);
  add_above(view, view.other.vertex(vertex), axis.separation, vertex_feature(!view.is_of_A, vertex), margin,
            pair);
}

}  // namespace

void place_polytope(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_OB,
                    PlacedPolytope& polytope) {
  const FloatHull& hull = *shape.hull;
  const Mat3f R = placed.rotation();
  const Vec3f p = p_OB + placed.position();
  const Mat3f stretched = R * shape.scale.asDiagonal();
  polytope.hull = &hull;
  const std::size_t vertices = hull.x.size(), faces = hull.nx.size();
  for (std::vector<float>* column : {&polytope.x, &polytope.y, &polytope.z}) column->resize(vertices);
  for (std::vector<float>* column : {&polytope.nx, &polytope.ny, &polytope.nz, &polytope.offset})
    column->resize(faces);
  for (std::size_t k = 0; k < vertices; ++k) {
    const float x = hull.x[k], y = hull.y[k], z = hull.z[k];
    polytope.x[k] = stretched(0, 0) * x + stretched(0, 1) * y + stretched(0, 2) * z + p.x();
    polytope.y[k] = stretched(1, 0) * x + stretched(1, 1) * y + stretched(1, 2) * z + p.y();
    polytope.z[k] = stretched(2, 0) * x + stretched(2, 1) * y + stretched(2, 2) * z + p.z();
  }
  // A scale other than 1 is that of a box, whose normals are along the axes.
  for (std::size_t k = 0; k < faces; ++k) {
    const float x = hull.nx[k], y = hull.ny[k], z = hull.nz[k];
    const float nx = R(0, 0) * x + R(0, 1) * y + R(0, 2) * z, ny = R(1, 0) * x + R(1, 1) * y + R(1, 2) * z,
                nz = R(2, 0) * x + R(2, 1) * y + R(2, 2) * z;
    const float stretch = Vec3f(shape.scale.x() * x, shape.scale.y() * y, shape.scale.z() * z).norm();
    polytope.nx[k] = nx;
    polytope.ny[k] = ny;
    polytope.nz[k] = nz;
    polytope.offset[k] = stretch * hull.offset[k] + nx * p.x() + ny * p.y() + nz * p.z();
  }
  polytope.center = R * hull.center + p;
  polytope.inner = hull.inner * shape.scale.minCoeff();
  polytope.radius = shape.radius;
  polytope.reach = p.norm() + shape.extent;
}

float clip_on_face(const SeparatingAxis& axis, float margin, float slack, PolytopeScratch& pair) {
  const FaceView view = view_of(axis, pair);
  const FloatHull& hull = *view.other.hull;
  const int face = facing_face(view, lowest_vertex(view));
  float least = kInfinity;
  const auto add_vertex = [&](int v) {
    const Vec3f p = view.other.vertex(v);
    if (!lies_over_face(view, p, slack)) return;
    least =
        std::min(least, add_above(view, p, view.height(p), vertex_feature(!view.is_of_A, v), margin, pair));
  };
  if (face < 0) {
    for (int v = 0; v < hull.vertex_count; ++v) add_vertex(v);
    return std::min(least, add_crossings(view, 0, margin, slack, pair));
  }
  for (int k = hull.loop_begin[at(face)]; k < hull.loop_begin[at(face + 1)]; ++k) {
    add_vertex(hull.loop[at(k)]);
    least = std::min(least, add_crossings(view, hull.loop_edges[at(k)], margin, slack, pair));
  }
  return std::min(least, add_corners(view, face, margin, slack, pair));
}

std::optional<Vec3f> find_polytope_candidates(PolytopeScratch& pair, float margin, float rounding) {
  pair.candidates.clear();
  const float slack = 4 * rounding;
  const float radii = pair.a.radius + pair.b.radius;
  const SeparatingAxis axis = find_separating_axis(pair, margin + radii, rounding);
  if (!(axis.separation <= margin + radii)) return std::nullopt;
  const bool is_apart = axis.separation > 0;
  if (axis.kind == SeparatingAxis::Kind::edges) {
    if (cross_edges(axis, slack, pair)) return axis.n;
    return join_nearest_edges(axis, margin, slack, pair);
  }
  const float least = clip_on_face(axis, margin, slack, pair);
  if (least <= axis.separation - radii + slack) return axis.n;
  if (is_apart) {
    pair.candidates.clear();
    return join_nearest_edges(axis, margin, slack, pair);
  }
  add_lowest(axis, margin, pair);
  return axis.n;
}

}  // namespace rigor
