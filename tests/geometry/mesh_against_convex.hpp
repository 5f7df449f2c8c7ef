#pragma once

#include "geometry/mesh_shapes.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

/// A study of meshes: a solid given as a mesh against the same solid given as a convex shape.
namespace rigor::test {

/// What was found in one cell of the study: a mesh and a kind of shape, at random poses.
struct MeshStudyCell {
  int poses = 0;
  int wrong_depth = 0;                      ///< Signed distance not that of the convex.
  int broken_bounds = 0;                    ///< Lower and upper bound that the truth contradicts.
  int wrong_normal = 0;                     ///< Of a contact.
  int missing = 0;                          ///< Sets that lack a point of the convex's.
  int extra = 0;                            ///< Sets with a point that the convex's lacks.
  int empty = 0;                            ///< No contact although the solids overlap.
  int broken_law = 0;                       ///< Sets with p_B - p_A ≠ gap n.
  double worst_depth = 0;                   ///< Largest error of the signed distance [m].
  double distance_us = 0, contacts_us = 0;  ///< Mean times of a query.

  bool is_clean() const {
    return wrong_depth + broken_bounds + wrong_normal + missing + extra + empty + broken_law == 0;
  }
};

/// A solid twice: as the mesh that is judged and as the convex that is the truth.
struct MeshStudySolid {
  std::string name;
  Mesh mesh;
  Shape convex;
  Pose X_MC;  ///< Of the convex in the frame of the mesh.
};

struct MeshStudyPose {
  Pose X_WM, X_WB;
};

inline Shape mesh_study_shape(Draw& draw, int kind) {
  if (kind < Draw::kKinds) return draw.shape(kind);
  const double r = draw.size(), h = draw.size();
  return std::get<Revolution>(make_revolution(
      {Vec2(0, -h), Vec2(0.7 * r, -h), Vec2(r, -0.3 * h), Vec2(0.6 * r, 0.8 * h), Vec2(0, h)}));
}
inline constexpr int kMeshStudyKinds = Draw::kKinds + 1;

/// The overlap of the shape with the convex brought to the depth [m], along the normal of the overlap.
inline void bring_to_depth(const MeshStudySolid& solid, const Shape& shape, double depth,
                           MeshStudyPose& pose) {
  for (int round = 0; round < 3; ++round) {
    const DistanceResult d = signed_distance(solid.convex, pose.X_WM * solid.X_MC, shape, pose.X_WB);
    pose.X_WB.p -= (d.distance + depth) * d.n_W;
  }
}

/// Compares one pose.
class MeshStudy {
 public:
  MeshStudy(const MeshStudySolid& solid, const Shape& shape, double tolerance)
      : solid_(solid), mesh_(solid.mesh), shape_(shape), tolerance_(tolerance) {}

  void compare(const MeshStudyPose& pose, MeshStudyCell& cell) const {
    ++cell.poses;
    compare_distances(pose, cell);
    compare_contacts(pose, cell);
  }

  void compare_distances(const MeshStudyPose& pose, MeshStudyCell& cell) const {
    const DistanceResult truth = signed_distance(solid_.convex, pose.X_WM * solid_.X_MC, shape_, pose.X_WB);
    DistanceResult found;
    cell.distance_us += microseconds([&] { found = signed_distance(mesh_, pose.X_WM, shape_, pose.X_WB); });
    // The truth itself is known between its bounds.
    const double error = std::max({0.0, truth.lower - found.distance, found.distance - truth.upper});
    cell.worst_depth = std::max(cell.worst_depth, error);
    cell.wrong_depth += error > kExact;
    cell.broken_bounds += found.lower > truth.upper || found.upper < truth.lower ||
                          found.lower > found.distance || found.upper < found.distance;
  }

  void compare_contacts(const MeshStudyPose& pose, MeshStudyCell& cell) const {
    const std::vector<ContactPoint> truth =
        contact_set(solid_.convex, pose.X_WM * solid_.X_MC, shape_, pose.X_WB, tolerance_);
    std::vector<ContactPoint> found;
    cell.contacts_us +=
        microseconds([&] { found = contact_set(mesh_, pose.X_WM, shape_, pose.X_WB, tolerance_); });
    cell.empty += found.empty() && !truth.empty();
    bool is_missing = false, is_extra = false, has_wrong_normal = false, breaks_law = false;
    for (const ContactPoint& t : truth)
      is_missing |= !std::ranges::any_of(found, [&](const auto& f) { return are_same(t, f); });
    // Whether the deepest point is added to others that are as deep is decided by rounding.
    const auto is_as_deep = [&](const ContactPoint& f) {
      return std::ranges::any_of(
          truth, [&](const auto& t) { return f.gap < 0 && std::abs(f.gap - t.gap) <= kExact; });
    };
    for (const ContactPoint& f : found) {
      is_extra |=
          !is_as_deep(f) && !std::ranges::any_of(truth, [&](const auto& t) { return are_same(t, f); });
      has_wrong_normal |=
          !std::ranges::any_of(truth, [&](const auto& t) { return (t.n_W - f.n_W).norm() <= kExact; });
      breaks_law |= (f.p_WB - f.p_WA - f.gap * f.n_W).norm() > kExact + tolerance_;
    }
    cell.missing += is_missing;
    cell.extra += is_extra;
    cell.wrong_normal += has_wrong_normal;
    cell.broken_law += breaks_law;
  }

 private:
  /// Of sizes about 1 m.
  static constexpr double kExact = 1e-9;

  static bool are_same(const ContactPoint& x, const ContactPoint& y) {
    return (x.p_WA - y.p_WA).norm() <= kExact && (x.p_WB - y.p_WB).norm() <= kExact &&
           (x.n_W - y.n_W).norm() <= kExact;
  }
  static double microseconds(const auto& call) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
  }

  const MeshStudySolid& solid_;
  const Shape mesh_;
  const Shape& shape_;
  double tolerance_;
};

}  // namespace rigor::test
