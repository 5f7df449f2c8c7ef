#include "rigor/geometry/convex/level_face.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/convex/gjk.hpp"

#include <cmath>
#include <vector>

namespace rigor {
namespace {

/// All points of a core that are farthest along d, to `tolerance` [m]: a disk about z, or the convex hull of
/// a few points.
class LevelFace {
 public:
  LevelFace(const ConvexCore& core, const Vec3& d, double tolerance) {
    switch (core.kind) {
      case ConvexCore::Kind::point:
      case ConvexCore::Kind::ellipsoid:
        points_ = {core_support(core, d).p};
        return;
      case ConvexCore::Kind::segment:
      case ConvexCore::Kind::box:
        add_level_pieces(core, core.kind == ConvexCore::Kind::box ? 8 : 2, d, tolerance);
        return;
      case ConvexCore::Kind::points:
        add_level_pieces(core, static_cast<int>(core.points.size()), d, tolerance);
        return;
      case ConvexCore::Kind::rings: {
        // The cap that faces d is level as a whole if its rim is; otherwise points of the rings are.
        const Ring end = ring_of(core, d.z() > 0 ? ring_count(core) - 1 : 0);
        is_disk_ = end.radius > 0 && end.radius * d.head<2>().norm() <= tolerance;
        if (!is_disk_) add_level_pieces(core, ring_count(core), d, tolerance);
        if (is_disk_)
          disk_ = {
              .kind = ConvexCore::Kind::rings, .size = {end.radius, end.radius, 0}, .extent = core.extent};
        height_ = end.z;
        return;
      }
    }
  }

  ConvexCore core() const { return is_disk_ ? disk_ : make_points_core(points_); }
  /// Pose of core() in the frame of the shape.
  Pose pose() const { return {.p = Vec3(0, 0, is_disk_ ? height_ : 0)}; }

 private:
  void add_level_pieces(const ConvexCore& core, int count, const Vec3& d, double tolerance) {
    // Pieces within the tolerance of the farthest point are level with it.
    const double top = d.dot(core_support(core, d).p);
    for (int i = 0; i < count; ++i) {
      const Vec3 p = piece_point(core, i, d);
      if (d.dot(p) >= top - tolerance) points_.push_back(p);
    }
  }

  std::vector<Vec3> points_;
  bool is_disk_ = false;
  ConvexCore disk_;
  double height_ = 0;
};

}  // namespace

Separation with_level_witnesses(const CorePair& pair, const Separation& separation) {
  return with_level_witnesses(pair, separation, pair.rounding);
}

Separation with_level_witnesses(const CorePair& pair, const Separation& separation, double tolerance) {
  // The faces that are level along n, as cores of their own.
  const LevelFace face_a(pair.a, separation.n, tolerance);
  const LevelFace face_b(pair.b, pair.X_AB.R.transpose() * -separation.n, tolerance);
  const ConvexCore a = face_a.core();
  const ConvexCore b = face_b.core();
  const Pose X_AB = pair.X_AB * face_b.pose();
  const Vec3 p_A = face_a.pose().p;
  const CorePair faces(a, b, {X_AB.R, X_AB.p - p_A});
  // The nearest points of the two faces, to the last digit: tolerance zero.
  GjkState gjk = start_gjk(faces);
  advance_gjk(faces, 0, gjk);

  // The witnesses, moved back from the frame of A's face to that of A.
  Separation result{separation.n, separation.value, p_A, p_A};
  for (int i = 0; i < gjk.nearest.count; ++i) {
    const std::size_t k = at(i);
    result.a += gjk.nearest.weight[k] * gjk.points[k].a;
    result.b += gjk.nearest.weight[k] * gjk.points[k].b;
  }
  return result;
}

}  // namespace rigor
