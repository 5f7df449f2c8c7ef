#include "rigor/geometry/decomposition/face_planes.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace rigor {
namespace {

/// Rounding of computed corners relative to the size of the mesh, with room for a few hundred cuts.
constexpr double kRelativeTolerance = 1e-13;
/// The direction of a thin triangle is uncertain, but its slack never exceeds this fraction of the size.
constexpr double kMostSlack = 1e-7;

/// Two triangles that share an edge, and their corners opposite to it.
struct Neighbours {
  int a, b;            ///< Triangles.
  int u, v;            ///< The edge as triangle a runs through it.
  int apex_a, apex_b;  ///< The third corners.
};

/// Merges coplanar neighbours into faces, fits a plane to each, and collects the edges that are notches.
class Finder {
 public:
  Finder(const TriangleMesh& mesh, double flatness)
      : mesh_(mesh), flatness_(flatness), group_(mesh.triangles.size()) {}

  FacePlanes run() {
    // Union-find over the edges gives groups of coplanar triangles; groups that prove to be curved are broken
    // up again, and their planes are made again.
    measure();
    find_neighbours();
    std::iota(group_.begin(), group_.end(), 0);
    for (const Neighbours& n : neighbours_) join_if_flat(n);
    make_planes();
    if (part_bent_groups()) make_planes();
    for (const Neighbours& n : neighbours_) add_if_notch(n);
    return std::move(result_);
  }

 private:
  const Vec3& vertex(int i) const { return mesh_.vertices[at(i)]; }
  Vec3 doubled_area(int t) const {
    const std::array<int, 3>& c = mesh_.triangles[at(t)];
    return (vertex(c[1]) - vertex(c[0])).cross(vertex(c[2]) - vertex(c[0]));
  }
  double longest_side(int t) const {
    const std::array<int, 3>& c = mesh_.triangles[at(t)];
    return std::max({(vertex(c[0]) - vertex(c[1])).norm(), (vertex(c[1]) - vertex(c[2])).norm(),
                     (vertex(c[2]) - vertex(c[0])).norm()});
  }

  /// Size of the mesh, and the lengths that count as rounding.
  void measure() {
    Vec3 lower = mesh_.vertices[0], upper = lower;
    double largest = 0;
    for (const Vec3& v : mesh_.vertices) {
      lower = lower.cwiseMin(v);
      upper = upper.cwiseMax(v);
      largest = std::max(largest, v.cwiseAbs().maxCoeff());
    }
    result_.size = (upper - lower).maxCoeff();
    result_.tolerance = std::max({kRelativeTolerance * result_.size, 16 * kEpsilon * largest, flatness_});
  }

  /// Pairs of triangles with a common edge: sorting the sides by their vertices puts the two of an edge next
  /// to each other.
  void find_neighbours() {
    struct Side {
      int low, high, triangle, apex;
      bool is_forward;
      bool operator<(const Side& s) const {
        return std::tie(low, high, triangle) < std::tie(s.low, s.high, s.triangle);
      }
    };
    std::vector<Side> sides;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int u = mesh_.triangles[t][k], v = mesh_.triangles[t][(k + 1) % 3];
        sides.push_back(
            {std::min(u, v), std::max(u, v), static_cast<int>(t), mesh_.triangles[t][(k + 2) % 3], u < v});
      }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
      const Side &a = sides[i], &b = sides[i + 1];
      const int u = a.is_forward ? a.low : a.high, v = a.is_forward ? a.high : a.low;
      neighbours_.push_back({a.triangle, b.triangle, u, v, a.apex, b.apex});
    }
  }

  /// Representative of the group of the triangle: its least triangle.
  int root(int t) const {
    while (group_[at(t)] != t) t = group_[at(t)];
    return t;
  }

  /// Joins the groups of two triangles if the far corner of each is in the plane of the other.
  void join_if_flat(const Neighbours& n) {
    const Vec3 normal_a = doubled_area(n.a).normalized(), normal_b = doubled_area(n.b).normalized();
    const Vec3 across = vertex(n.apex_b) - vertex(n.apex_a);
    const Vec3 edge = vertex(n.v) - vertex(n.u);
    const double height = std::max(std::abs(normal_a.dot(vertex(n.apex_b) - vertex(n.u))),
                                   std::abs(normal_b.dot(vertex(n.apex_a) - vertex(n.u))));
    const bool is_folded = normal_a.dot(normal_b) <= 0 || across.isZero(0) || edge.isZero(0);
    if (is_folded || height > result_.tolerance) return;
    const int a = root(n.a), b = root(n.b);
    group_[at(std::max(a, b))] = std::min(a, b);
  }

  /// Makes one plane for each group: normal from the sum of the area vectors, offset from the corners, slack
  /// from the rounding.
  void make_planes() {
    const std::size_t count = mesh_.triangles.size();
    result_.planes.clear();
    result_.plane_of.resize(count);
    std::vector<int> number(count, -1);
    std::vector<double> width;
    for (std::size_t t = 0; t < count; ++t) {
      const int r = root(static_cast<int>(t));
      if (number[at(r)] < 0) {
        number[at(r)] = static_cast<int>(result_.planes.size());
        result_.planes.push_back({{Vec3::Zero(), 0}, 0, 0});
        width.push_back(0);
      }
      const std::size_t p = at(result_.plane_of[t] = number[at(r)]);
      const Vec3 area = doubled_area(static_cast<int>(t));
      result_.planes[p].plane.normal += area;
      width[p] = std::max(width[p], area.norm() / longest_side(static_cast<int>(t)));
    }
    for (FacePlanes::Plane& p : result_.planes) p.plane.normal.normalize();
    fit_offsets();
    // The slack covers the fit, the rounding of corners, and the error of the direction: a normal that is
    // known across a small width only is off at a distance.
    for (std::size_t p = 0; p < result_.planes.size(); ++p) {
      const double tilt = result_.tolerance * 0.01 * result_.size / std::max(width[p], 1e-300);
      result_.planes[p].slack =
          result_.planes[p].fit + result_.tolerance + std::min(tilt, kMostSlack * result_.size);
    }
  }

  /// Breaks up groups that are curved although each two neighbours are coplanar: each triangle is its own
  /// plane then. Returns whether there were any.
  bool part_bent_groups() {
    bool has_parted = false;
    for (std::size_t t = 0; t < group_.size(); ++t) {
      if (result_.planes[at(result_.plane_of[t])].fit <= result_.tolerance) continue;
      has_parted = has_parted || group_[t] != static_cast<int>(t);
      group_[t] = static_cast<int>(t);
    }
    return has_parted;
  }

  /// Puts each plane in the middle of the heights of its own corners; half their range is the fit.
  void fit_offsets() {
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<std::array<double, 2>> heights(result_.planes.size(), {infinity, -infinity});
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const std::size_t p = at(result_.plane_of[t]);
      for (const int v : mesh_.triangles[t]) {
        const double height = result_.planes[p].plane.normal.dot(vertex(v));
        heights[p] = {std::min(heights[p][0], height), std::max(heights[p][1], height)};
      }
    }
    for (std::size_t p = 0; p < result_.planes.size(); ++p) {
      result_.planes[p].plane.offset = 0.5 * (heights[p][0] + heights[p][1]);
      result_.planes[p].fit = 0.5 * (heights[p][1] - heights[p][0]);
    }
  }

  /// Adds the edge as a notch if its faces bend inwards, that is, if either far corner is in front of the
  /// other face.
  void add_if_notch(const Neighbours& n) {
    const int a = result_.plane_of[at(n.a)], b = result_.plane_of[at(n.b)];
    if (a == b) return;
    const FacePlanes::Plane &plane_a = result_.planes[at(a)], &plane_b = result_.planes[at(b)];
    const bool bends_in = plane_a.plane.height(vertex(n.apex_b)) > plane_a.slack ||
                          plane_b.plane.height(vertex(n.apex_a)) > plane_b.slack;
    if (!bends_in) return;
    const Vec3 along = (vertex(n.v) - vertex(n.u)).normalized();
    result_.notches.push_back({vertex(n.u),
                               vertex(n.v),
                               {plane_a.plane.normal.cross(along), -plane_b.plane.normal.cross(along)},
                               {a, b}});
  }

  const TriangleMesh& mesh_;
  double flatness_;
  std::vector<int> group_;
  std::vector<Neighbours> neighbours_;
  FacePlanes result_;
};

}  // namespace

FacePlanes find_face_planes(const TriangleMesh& mesh, double flatness) {
  return Finder(mesh, flatness).run();
}

}  // namespace rigor
