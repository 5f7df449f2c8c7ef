#pragma once

#include "rigor/core/rounding.hpp"
#include "rigor/geometry/shape/feature_graph.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <array>

namespace rigor {

/// Direction cosines below this are zero to rounding.
inline constexpr double kLevelCosine = 8 * kEpsilon;
/// Edges at a smaller angle [rad] count as parallel: their common perpendicular is lost in rounding.
inline constexpr double kParallelAngle = 1e-13;

/// A box or a convex polyhedron with its features. It owns nothing of a hull, which must outlive it; the
/// corners of a box are stored here.
class Polytope {
 public:
  explicit Polytope(const Box& box);
  explicit Polytope(const ConvexHull& hull);
  Polytope(const Polytope&) = delete;
  Polytope& operator=(const Polytope&) = delete;

  /// A box has its corners in the order of the sign bits (x lowest), the last one at its half extents.
  bool is_box() const { return vertices_ == corners_.data(); }
  const FeatureGraph& graph() const { return *graph_; }
  const Vec3& vertex(int v) const { return vertices_[v]; }
  /// Largest distance of a vertex from the origin of the frame [m].
  double extent() const { return extent_; }

  /// Farthest vertex along d, by hill climbing from vertex `start`.
  int farthest(const Vec3& d, int start) const {
    double height = d.dot(vertex(start));
    return climb(d, start, height);
  }
  /// The same where the height d · vertex of the start is known; `height` becomes that of the farthest
  /// vertex.
  int climb(const Vec3& d, int start, double& height) const;

 private:
  const FeatureGraph* graph_;
  const Vec3* vertices_;
  double extent_;
  std::array<Vec3, 8> corners_;
};

/// A feature of a polytope.
struct PolytopeFeature {
  enum class Kind : std::int8_t { vertex, edge, face };
  Kind kind = Kind::vertex;
  int index = 0;  ///< Vertex, half-edge or face.
  bool operator==(const PolytopeFeature& other) const = default;
};

/// One feature of each of two polytopes.
struct FeaturePair {
  PolytopeFeature a, b;
  bool operator==(const FeaturePair& other) const = default;
};

/// Two polytopes for algorithms that treat both alike: side 0 is A, side 1 is B.
class PolytopePair {
 public:
  PolytopePair(const Polytope& a, const Polytope& b, const Pose& X_AB) : sides_{&a, &b}, X_AB_(X_AB) {}

  const Polytope& side(int s) const { return *sides_[s]; }
  const FeatureGraph& graph(int s) const { return sides_[s]->graph(); }
  const Pose& X_AB() const { return X_AB_; }

  /// Vertex v of side s in A's frame [m].
  Vec3 vertex(int s, int v) const { return s == 0 ? side(0).vertex(v) : X_AB_ * side(1).vertex(v); }
  /// Between the frame of side s and that of the other side.
  Vec3 point_to_other(int s, const Vec3& p) const {
    return s == 0 ? Vec3(X_AB_.R.transpose() * (p - X_AB_.p)) : X_AB_ * p;
  }
  Vec3 direction_to_other(int s, const Vec3& d) const {
    return s == 0 ? Vec3(X_AB_.R.transpose() * d) : Vec3(X_AB_.R * d);
  }
  /// Between the frames of side s and of A.
  Vec3 direction_in_a(int s, const Vec3& d) const { return s == 0 ? d : Vec3(X_AB_.R * d); }
  Vec3 direction_from_a(int s, const Vec3& d) const { return s == 0 ? d : Vec3(X_AB_.R.transpose() * d); }
  Vec3 point_from_a(int s, const Vec3& p) const { return s == 0 ? p : point_to_other(0, p); }

 private:
  const Polytope* sides_[2];
  Pose X_AB_;
};

}  // namespace rigor
