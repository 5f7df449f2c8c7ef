#include "rigor/geometry/decomposition/convex_patches.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/geometry/decomposition/face_planes.hpp"
#include "rigor/geometry/decomposition/solid_parts.hpp"
#include "rigor/geometry/mesh/mesh_shells.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <utility>

namespace rigor {
namespace {

/// Grows the patches of one mesh, one after the other.
class Growth {
 public:
  explicit Growth(const TriangleMesh& mesh)
      : mesh_(mesh), planes_(find_face_planes(mesh)), patch_(mesh.triangles.size(), -1) {
    neighbours_.resize(mesh.triangles.size());
    // In the sorted list the two sides of an edge are next to each other, which gives the neighbours.
    const std::vector<FaceEdge> edges = sorted_edges(as_polygons(mesh));
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
      neighbours_[at(edges[i].face)].push_back(edges[i + 1].face);
      neighbours_[at(edges[i + 1].face)].push_back(edges[i].face);
    }
    for (std::vector<int>& list : neighbours_) std::sort(list.begin(), list.end());
  }

  std::vector<ConvexPatch> run() {
    std::vector<ConvexPatch> patches;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (patch_[t] >= 0) continue;
      patches.push_back({grown(static_cast<int>(t), static_cast<int>(patches.size())), nullptr, {}});
      add_hull(patches.back());
    }
    return patches;
  }

  bool are_more_than(std::size_t most) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size() && count <= most; ++t) {
      poll_interrupt();
      if (patch_[t] < 0) grown(static_cast<int>(t), static_cast<int>(count++));
    }
    return count > most;
  }

 private:
  const FacePlanes::Plane& plane(int t) const { return planes_.planes[at(planes_.plane_of[at(t)])]; }

  /// Whether the patch stays convex with the triangle t: each is behind the planes of the other.
  bool stays_on_hull(const std::vector<int>& triangles, const std::vector<int>& corners, int t) const {
    const FacePlanes::Plane& own = plane(t);
    for (const int v : corners) {
      if (own.plane.height(mesh_.vertices[at(v)]) > own.slack) return false;
    }
    for (const int v : mesh_.triangles[at(t)]) {
      for (const int other : triangles) {
        const FacePlanes::Plane& p = plane(other);
        if (p.plane.height(mesh_.vertices[at(v)]) > p.slack) return false;
      }
    }
    return true;
  }

  /// The triangles of the patch that grows from the seed over those not yet in a patch, ascending.
  std::vector<int> grown(int seed, int number) {
    std::vector<int> triangles, corners;
    std::deque<int> waiting = {seed};
    while (!waiting.empty()) {
      const int t = waiting.front();
      waiting.pop_front();
      if (patch_[at(t)] >= 0 || !stays_on_hull(triangles, corners, t)) continue;
      patch_[at(t)] = number;
      triangles.push_back(t);
      for (const int v : mesh_.triangles[at(t)]) corners.push_back(v);
      for (const int next : neighbours_[at(t)]) {
        if (patch_[at(next)] < 0) waiting.push_back(next);
      }
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

  /// Gives the patch the hull of its corners and the share of each hull face that it covers; a flat patch has
  /// none.
  void add_hull(ConvexPatch& patch) const {
    SolidPart part;
    std::vector<int> corners;
    for (const int t : patch.triangles) {
      ConvexPolygon polygon;
      for (const int v : mesh_.triangles[at(t)]) {
        polygon.push_back(mesh_.vertices[at(v)]);
        corners.push_back(v);
      }
      part.fragments.push_back({planes_.plane_of[at(t)], std::move(polygon)});
    }
    corners = sorted_unique(std::move(corners));
    std::vector<Vec3> points;
    points.reserve(corners.size());
    for (const int v : corners) points.push_back(mesh_.vertices[at(v)]);
    std::variant<ConvexHull, std::string> hull = make_convex_hull(points);
    if (!std::holds_alternative<ConvexHull>(hull)) return;
    part.hull = std::get<ConvexHull>(std::move(hull));
    patch.real_share = real_shares(part, planes_);
    patch.hull = std::make_shared<const ConvexHull>(std::move(part.hull));
  }

  const TriangleMesh& mesh_;
  FacePlanes planes_;
  std::vector<int> patch_;
  std::vector<std::vector<int>> neighbours_;
};

}  // namespace

std::vector<ConvexPatch> find_convex_patches(const TriangleMesh& mesh) {
  return Growth(mesh).run();
}

bool has_more_convex_patches(const TriangleMesh& mesh, std::size_t most) {
  return Growth(mesh).are_more_than(most);
}

}  // namespace rigor
