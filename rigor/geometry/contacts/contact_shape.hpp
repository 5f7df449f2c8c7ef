#pragma once

#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/shape/convex_core.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rigor {

/// A feature of a shape's surface, by a name that does not depend on the pose:
///
///   polyhedron    vertex, edge, face by the index in the hull (of a mesh: in the mesh; its faces are flat
///   patches) half-space    face 0 cylinder, cone, revolution
///                 face 0 the cap at the lowest ring, 1 that at the highest; edge (rim) by the index of its
///                 ring from the lowest up; side by that of its lower ring; vertices 0 to 3 and 4 to 7: the
///                 points of the outermost rims on the x and y axes of the shape (+x +y -x -y), which stand
///                 for a cap that lies flat; of an apex there 0 or 4
///   capsule       side 0 the cylindrical part, 1 the cap at -z, 2 that at +z
///   sphere, ellipsoid
///                 side 0
struct Feature {
  enum class Kind : std::uint32_t { vertex, edge, face, side };
  Kind kind = Kind::vertex;
  int index = 0;
  int part = 0;  ///< Tells two crossings of the same features apart.
};

/// The pair as a number: the feature of A in the upper half.
std::uint64_t feature_pair(const Feature& a, const Feature& b);
/// The features that make up such a number.
Feature first_feature(std::uint64_t pair);
Feature second_feature(std::uint64_t pair);

/// A corner of a flat face; the boundary runs on from it to the next one.
struct FaceCorner {
  Vec3 p;
  int vertex = 0;            ///< Of the polyhedron.
  bool is_real = true;       ///< False inside a flat patch of a mesh or on its straight side.
  bool edge_is_real = true;  ///< The same for the edge to the next corner.
};

/// A flat part of a surface.
struct FlatFace {
  enum class Kind { polygon, disk, plane };
  Kind kind = Kind::polygon;
  Feature feature;
  Vec3 normal;                      ///< Outward unit normal.
  Vec3 center;                      ///< A point of the face; of a disk its centre [m].
  double radius = 0;                ///< Of a disk [m].
  double area = 0;                  ///< [m²], infinite for a plane.
  std::vector<FaceCorner> corners;  ///< Of a polygon, counter-clockwise seen from outside.
};

/// A straight line on a surface: an edge, or the line of a ruled side that is farthest along some direction.
struct SurfaceLine {
  Vec3 a, b;
  Feature feature;
  Feature feature_a, feature_b;  ///< Of its ends.
  bool is_real = true;           ///< False inside a flat patch of a mesh.
};

/// A point that may be in contact, with what it lies on.
struct SurfacePoint {
  Vec3 p;
  Feature feature;
  bool is_real = true;  ///< False inside a flat patch of a mesh or on its straight side.
};

/// What a shape shows to a plane below it.
struct LowerSide {
  std::vector<SurfacePoint> points;  ///< Lowest points and corners that are not hidden.
  std::vector<SurfaceLine> lines;    ///< Edges and ruling lines between them.
  std::optional<FlatFace> disk;      ///< A cap that lies flat; its rim points are among `points`.
};

/// Tolerances of one pair, all from the sizes of its shapes [m].
struct ContactScale {
  double size;       ///< Of the smaller shape.
  double tolerance;  ///< Of the set.
  double tie;        ///< Separations this close are equal: rounding.
  double slack;      ///< A point this far outside a boundary still counts as on it.
  double merge;      ///< Contacts this close are one.
};

/// In place of the number of an edge: the side is none of the surface, and nothing comes near it.
inline constexpr int kNoMeshEdge = 0x1fffffff;

/// A flat piece of a mesh, a face, a triangle or a part of a patch, with what the mesh makes of its corners
/// and sides.
struct MeshFacet {
  std::vector<Vec3> corners;  ///< Of a convex polygon, in the frame of the mesh [m].
  Vec3 normal;                ///< Unit.
  std::vector<int> vertices;  ///< Their indices.
  std::vector<int> edges;  ///< A number for the side from corner k to the next, the same from its other face.
  std::vector<bool> corner_is_real, edge_is_real;
  int patch;
  double patch_area;     ///< [m²].
  bool is_part = false;  ///< One of several facets of its patch that a shape may touch at once.
};

/// A shape placed in a frame O: axes of W, origin near both shapes, so that differences of coordinates keep
/// their digits. Knows its features. Half-spaces are allowed, meshes only facet by facet.
class ContactShape {
 public:
  /// The shape must outlive this.
  ContactShape(const Shape& shape, const Pose& X_OS);
  ContactShape(const MeshFacet& facet, const Pose& X_OM);
  ContactShape(const ContactShape&) = delete;
  ContactShape& operator=(const ContactShape&) = delete;

  bool is_polyhedron() const { return topology_ != nullptr; }
  bool is_plane() const { return shape_ && std::holds_alternative<HalfSpace>(*shape_); }
  /// Longest side of the box of the shape in its own frame [m]; 0 for a plane.
  double size() const { return size_; }
  const Pose& X_OS() const { return X_OS_; }
  const ConvexCore& core() const { return core_; }

  /// Farthest point along the unit vector m (all vectors in O from here on). Not for a plane.
  Vec3 support(const Vec3& m) const;
  /// Flat faces whose planes pass the point p at no more than `reach`.
  std::vector<FlatFace> faces_near(const Vec3& p, double reach) const;
  /// The lower side as seen from a face of another shape; only features that come closer to its plane than
  /// `reach`.
  LowerSide lower_side(const FlatFace& face, double reach) const;
  /// Height above p, along n, at which a line meets the lower side of a polyhedron or the disk; nothing if it
  /// misses by more than `slack`. Sides steeper than 89.9° do not count as lower.
  std::optional<double> height_above(const Vec3& p, const Vec3& n, const std::optional<FlatFace>& disk,
                                     double slack) const;
  /// Straight lines on the surface that are farthest along m but for `reach`.
  std::vector<SurfaceLine> lines_along(const Vec3& m, double reach) const;
  /// The feature at the surface point p with outward normal m.
  Feature classify(const Vec3& p, const Vec3& m) const;
  /// Outward normal of a side at its point p; nothing at other features.
  std::optional<Vec3> surface_normal(const Feature& feature, const Vec3& p) const;
  /// How the feature bends at p, where the outward normal is m.
  SurfaceCurvature curvature(const Feature& feature, const Vec3& p, const Vec3& m) const;

  /// Face of a polyhedron by its index; of a facet 0 is the front.
  FlatFace polygon(int face) const;
  Feature vertex_feature(int vertex) const;
  /// Edge of a polyhedron between two vertices.
  Feature edge_feature(int v0, int v1) const;

 private:
  Vec3 in_O(const Vec3& p_S) const { return X_OS_ * p_S; }
  Vec3 in_S(const Vec3& p_O) const { return X_OS_.R.transpose() * (p_O - X_OS_.p); }
  Vec3 direction_in_S(const Vec3& d_O) const { return X_OS_.R.transpose() * d_O; }
  Vec3 axis() const { return X_OS_.R.col(2); }

  const std::vector<Vec3>& vertices_S() const;
  Vec3 face_normal_S(int face) const;
  Feature face_feature(int face) const;
  bool vertex_is_real(int vertex) const;
  bool edge_is_real(int edge) const;
  /// Cap 0 at the lowest ring, 1 at the highest; nothing where the end is an apex or round.
  std::optional<FlatFace> cap(int index) const;
  bool has_rings() const { return core_.kind == ConvexCore::Kind::rings; }
  int last_ring() const { return ring_count(core_) - 1; }
  /// A rim, or the apex where the ring has no radius.
  Feature ring_feature(int ring) const;
  Feature ring_feature_at(const Vec3& p_S, const Vec3& m_S) const;

  LowerSide polyhedron_lower_side(const Vec3& n, const Vec3& p_plane, double reach) const;
  LowerSide round_lower_side(const FlatFace& face, double reach) const;
  bool is_flat_over(const FlatFace& face, const FlatFace& disk, double reach) const;
  SurfaceLine edge_line(int edge) const;
  /// The straight lines of a ruled side on the half plane from the axis towards m, from the lowest up; none
  /// if the surface has none or m lies along the axis.
  std::vector<SurfaceLine> rulings(const Vec3& m) const;
  SurfaceLine capsule_ruling(const Vec3& outward) const;
  std::vector<SurfaceLine> facing_rulings(const Vec3& n, const Vec3& p_plane, double reach) const;
  Feature classify_on_polyhedron(const Vec3& p) const;

  const Shape* shape_ = nullptr;  ///< Null for a facet.
  Pose X_OS_;
  ConvexCore core_;
  double size_ = 0;
  const ConvexHull* topology_ = nullptr;    ///< Of a polyhedron; its coordinates hold only for a Convex.
  std::vector<Vec3> own_vertices_S_;        ///< Of a box or a facet.
  std::optional<ConvexHull> own_topology_;  ///< Of a facet that is no triangle.
  std::optional<MeshFacet> facet_;
};

}  // namespace rigor
