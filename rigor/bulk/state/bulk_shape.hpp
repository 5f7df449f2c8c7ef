#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/float_mesh.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/model/body.hpp"

#include <memory>
#include <span>
#include <vector>

namespace rigor {

using Vec3f = Eigen::Vector3f;
using Mat3f = Eigen::Matrix<float, 3, 3, Eigen::RowMajor>;

/// The rounding of separations, relative to the lengths in a pair.
constexpr float kCollisionRounding = 1e-6f;

/// Hulls have fewer edges than this, so that two edges and a few bits more name an axis in 32 bits.
constexpr std::size_t kMaxHullEdges = 16384;

/// Points or directions in columns of whole lanes.
struct LaneColumns {
  const float *x, *y, *z;
  std::size_t count;
};

/// A convex polyhedron in 32 bits. A segment (two vertices, one edge) and a point (one vertex, an edge
/// without length) are polyhedra without faces. Columns are padded to whole lanes with their last entry.
struct FloatHull {
  struct Edge {
    int v0, v1;        ///< The edge runs v0 -> v1 in the loop of face f0 and v1 -> v0 in that of f1.
    int f0, f1;        ///< -1 where there are no faces.
    float cosine = 1;  ///< Cosine of the angle between their normals.
  };
  /// An edge and its arc on the Gauss map, in two rows of lanes.
  struct alignas(64) ArcRecord {
    float along[3], normal_0[3], normal_1[3], point[3];
    float pad[4];
  };
  int vertex_count = 0, face_count = 0;
  std::vector<float> x, y, z;             ///< Vertices [m].
  std::vector<float> nx, ny, nz;          ///< Outward unit normals of the faces.
  std::vector<float> offset;              ///< Offsets of the faces: n · v of their vertices [m].
  std::vector<char> is_lone;              ///< Whether no other normal is within 0.02 rad of a face's.
  std::vector<Edge> edges;                ///< Each edge once.
  std::vector<int> sharp_edges;           ///< Edges between faces whose normals are at an obtuse angle.
  std::vector<ArcRecord> arcs;            ///< Arcs of the edges; none without faces.
  std::vector<int> loop_begin;            ///< Beginning of each face's loop, and the end of the last.
  std::vector<int> loop, loop_edges;      ///< Vertices counter-clockwise, and the edge to the next one.
  std::vector<int> fan_begin, fan;        ///< The faces around each vertex.
  std::vector<int> around_begin, around;  ///< The edges around each vertex.
  Vec3f center = Vec3f::Zero();           ///< Centre of a ball inside [m].
  float inner = 0;                        ///< Radius of that ball [m].
  float extent = 0;                       ///< No vertex is farther from the origin [m].

  LaneColumns vertices() const { return {x.data(), y.data(), z.data(), x.size()}; }
  LaneColumns normals() const { return {nx.data(), ny.data(), nz.data(), nx.size()}; }
  Vec3f vertex(int v) const {
    const std::size_t k = at(v);
    return Vec3f(x[k], y[k], z[k]);
  }
  Vec3f normal(int f) const {
    const std::size_t k = at(f);
    return Vec3f(nx[k], ny[k], nz[k]);
  }
  std::span<const int> border_vertices(int face) const { return part(loop, loop_begin, face); }
  std::span<const int> border_edges(int face) const { return part(loop_edges, loop_begin, face); }
  std::span<const int> faces_around(int vertex) const { return part(fan, fan_begin, vertex); }
  std::span<const int> edges_around(int vertex) const { return part(around, around_begin, vertex); }

 private:
  static std::span<const int> part(const std::vector<int>& all, const std::vector<int>& begin, int i) {
    const std::size_t k = at(i), first = at(begin[k]);
    return std::span(all).subspan(first, at(begin[k + 1]) - first);
  }
};

FloatHull make_float_hull(const FeatureGraph& graph, const std::vector<Vec3>& vertices);

/// A convex solid of revolution about z, the hull of two circles, which may be points; and a ball inside it.
struct FloatRings {
  float z[2] = {0, 0}, r[2] = {0, 0};  ///< Heights, ascending, and radii of the circles [m].
  float k = 0, square = 1;  ///< Along the axis and across it: the parts of the unit normals of the side.
  float inner = 0;          ///< Radius of the ball [m].
  float ball = 0;           ///< Height of its centre [m].
  float ball_shift = 0, ball_across = 0;  ///< How far it can be moved along the axis and across it [m].
};
FloatRings make_float_rings(const Ring& lower, const Ring& upper);

/// What the narrow phase knows of a shape: a core of vertices, which is `hull` scaled by `scale` along its
/// axes, grown by `radius`; or `rings`; or an ellipsoid with the radii `scale`; or a half-space; or a mesh;
/// or a shape that is only treated in double precision.
struct BulkShape {
  enum class Kind : std::int8_t { round, box, hull, rings, ellipsoid, plane, mesh, other };
  Kind kind = Kind::other;
  const Shape* shape = nullptr;
  Pose X_BS;
  bool is_body_frame = false;  ///< Whether the shape's frame S is the body frame B.
  std::shared_ptr<const FloatHull> hull;
  std::shared_ptr<const FloatMesh> mesh;
  FloatRings rings;             ///< Of a solid of revolution; balls and capsules are such solids too.
  Vec3f scale = Vec3f::Ones();  ///< Half extents of a box, radii of an ellipsoid; (1, 1, half length) of a
                                ///< segment [m].
  float radius = 0;             ///< [m].
  float extent = 0;             ///< No point of the core is farther from the origin of S [m].
  float size = 0;  ///< Longest side of the box about the shape along its axes [m]; may be infinite.
  /// How far the ball inside the core can be moved along the axes of S, both ways [m].
  Vec3f ball_shift = Vec3f::Zero();

  /// Radius of a ball inside the shape, if it has a core [m].
  float inner_radius() const { return hull->inner * scale.minCoeff() + radius; }
};

/// The hulls that shapes share.
struct FloatHulls {
  FloatHulls();
  /// The cube |x|, |y|, |z| <= 1; edges are numbered 4 axis + the sign bits of their vertices without that of
  /// the axis.
  std::shared_ptr<const FloatHull> box;
  std::shared_ptr<const FloatHull> segment;  ///< The segment |z| <= 1 on the axis.
  std::shared_ptr<const FloatHull> point;    ///< The origin.
  std::vector<std::pair<const ConvexHull*, std::shared_ptr<const FloatHull>>> convex;
  std::vector<std::pair<const TriangleTree*, std::shared_ptr<const FloatMesh>>> meshes;
};

/// The form of a body's shape in 32 bits; the shape must outlive it.
BulkShape make_bulk_shape(const BodyShape& shape, FloatHulls& hulls);

/// Where a shape's frame S is, relative to the centre of its body along W's axes, with what pairs of boxes
/// need besides: one cache line.
struct alignas(64) PlacedShape {
  float R[9];     ///< R_WS, row by row.
  float p[3];     ///< [m].
  float half[3];  ///< Half extents of a box [m].
  float extent;   ///< As in the BulkShape [m].

  Mat3f rotation() const { return Eigen::Map<const Mat3f>(R); }
  Vec3f position() const { return Vec3f(p[0], p[1], p[2]); }
};

PlacedShape place_shape(const BulkShape& shape, const Quat& q_WB);

}  // namespace rigor
