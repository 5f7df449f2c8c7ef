#pragma once

#include "rigor/geometry/broad_phase/aabb_tree.hpp"
#include "rigor/geometry/motion/shape_cast.hpp"
#include "rigor/geometry/rays/ray_cast.hpp"
#include "rigor/model/state.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace rigor {

/// A shape of a body, by indices: model.body(body).shapes[shape].
struct ShapeIndex {
  /// Index in the model.
  int body = -1;
  /// Of the body, from 0.
  int shape = -1;

  /// By body and shape.
  bool operator==(const ShapeIndex& other) const = default;
};

/// Where a ray meets a body.
struct BodyRayHit {
  /// Which shape it met.
  ShapeIndex on;
  /// Where.
  RayHit hit;
};

/// Where a shape that is swept along a path meets a body.
struct BodyCastHit {
  /// Which shape it met.
  ShapeIndex on;
  /// Where and when.
  ShapeCastHit hit;
};

/// How far a body is from the point or shape of a query.
struct NearBody {
  ShapeIndex on;             ///< Its nearest shape.
  double distance = 0;       ///< Signed [m]; negative inside or overlapping.
  Vec3 p_WQ = Vec3::Zero();  ///< Witness point on the query [m].
  Vec3 p_WB = Vec3::Zero();  ///< Witness point on the body: p_WQ + distance · n_W [m].
  Vec3 n_W = Vec3::Zero();   ///< Unit, from the query to the body.
};

/// Queries about the bodies of a scene at one instant: rays, swept shapes, points, overlaps, the nearest
/// bodies. All queries are const: many threads may share one object. Equal queries have equal answers, bit
/// for bit; among equal distances the lower indices come first.
/// docs/queries.md.
class SceneQueries {
 public:
  /// Which bodies a query considers; empty: all.
  using Filter = std::function<bool(int body)>;

  /// The Model must outlive this; the poses are copied from the State.
  SceneQueries(const Model& model, const State& state);
  /// Moves the bodies to the poses of another State. O(n), except every 64th time, when the tree is rebuilt.
  void update(const State& state);

  /// Of a body's frame B [m].
  const Pose& pose(int body) const { return poses_[static_cast<std::size_t>(body)]; }

  /// The first surface that the ray crosses. A ray that begins inside a body hits it where it leaves it.
  std::optional<BodyRayHit> first_hit(const Ray& ray, const Filter& filter = {}) const;
  /// All crossings, in the order of their fractions.
  std::vector<BodyRayHit> all_hits(const Ray& ray, const Filter& filter = {}) const;
  /// The first body that a swept shape meets, with the part of its path that is proven free.
  std::optional<BodyCastHit> cast(const ShapeCast& cast, const Filter& filter = {}) const;

  /// Up to k bodies nearest to the point, in ascending order of their signed distance.
  std::vector<NearBody> nearest(const Vec3& p_W, int k = 1, const Filter& filter = {}) const;
  /// The same for a shape (convex, or a half-space or a mesh where the pair has a distance) at X_WS.
  std::vector<NearBody> nearest(const Shape& shape, const Pose& X_WS, int k = 1,
                                const Filter& filter = {}) const;

  /// Bodies whose shapes hold the point, ascending.
  std::vector<int> containing(const Vec3& p_W, const Filter& filter = {}) const;
  /// Bodies that a shape at X_WS touches or overlaps, ascending.
  std::vector<int> overlapping(const Shape& shape, const Pose& X_WS, const Filter& filter = {}) const;
  /// Bodies that a box along the axes of W touches or overlaps, ascending.
  std::vector<int> overlapping(const Aabb& box, const Filter& filter = {}) const;

 private:
  Pose shape_pose(const ShapeIndex& at) const;
  const Shape& shape(const ShapeIndex& at) const;
  std::vector<NearBody> nearest(const Aabb& around, int k, const Filter& filter,
                                const std::function<NearBody(const ShapeIndex&)>& measure) const;

  const Model& model_;
  std::vector<Pose> poses_;  ///< X_WB of each body.
  std::vector<Aabb> boxes_;  ///< Of each body that has shapes.
  AabbTree tree_;            ///< Of those boxes.
  int updates_ = 0;
};

}  // namespace rigor
