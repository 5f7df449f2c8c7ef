#include "rigor/geometry/shape/containment.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/exact/orientation.hpp"
#include "rigor/geometry/exact/planar_turns.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

/// +1 if the ray from p along +z leaves the solid through the triangle, -1 if it enters, 0 if it does not
/// meet it.
int crossing(const TriangleMesh& mesh, int triangle, const Vec3& p) {
  const std::array<int, 3>& corners = mesh.triangles[at(triangle)];
  const Vec3& a = mesh.vertices[at(corners[0])];
  const Vec3& b = mesh.vertices[at(corners[1])];
  const Vec3& c = mesh.vertices[at(corners[2])];
  if (std::max({a.z(), b.z(), c.z()}) < p.z()) return 0;
  const int winding = turns_about(a.head<2>(), b.head<2>(), c.head<2>(), p.head<2>());
  if (winding == 0) return 0;
  return orientation(a, b, c, p) == -winding ? winding : 0;
}

struct Inside {
  Vec3 p;

  bool operator()(const Sphere& s) const { return p.squaredNorm() <= s.radius * s.radius; }
  bool operator()(const Box& box) const { return (p.cwiseAbs().array() <= box.half_extents.array()).all(); }
  bool operator()(const Capsule& c) const {
    const double above = std::max(std::abs(p.z()) - c.half_length, 0.0);
    return p.head<2>().squaredNorm() + above * above <= c.radius * c.radius;
  }
  bool operator()(const Cylinder& c) const {
    return std::abs(p.z()) <= c.half_length && p.head<2>().squaredNorm() <= c.radius * c.radius;
  }
  bool operator()(const Cone& c) const {
    const double radius = c.radius * ((c.half_length - p.z()) / (2 * c.half_length));
    return std::abs(p.z()) <= c.half_length && p.head<2>().squaredNorm() <= radius * radius;
  }
  bool operator()(const Ellipsoid& e) const { return p.cwiseQuotient(e.radii).squaredNorm() <= 1; }
  bool operator()(const HalfSpace& h) const { return h.normal.dot(p) <= h.offset; }
  bool operator()(const Cavity& c) const { return p.squaredNorm() >= c.radius * c.radius; }
  bool operator()(const Convex& c) const {
    for (std::size_t f = 0; f < c.hull->faces.size(); ++f) {
      const Vec3& p0 = c.hull->vertices[at(c.hull->faces[f][0])];
      if (c.hull->face_normals[f].dot(p - p0) > 0) return false;
    }
    return true;
  }
  bool operator()(const Mesh& m) const { return winding_number(*m.mesh, p) >= 1; }
  template <class Own>
  bool operator()(const Own& s) const {
    return s.contains(p);
  }
};

}  // namespace

bool contains(const Shape& shape, const Vec3& p_S) {
  return std::visit(Inside{p_S}, shape);
}

int winding_number(const TriangleMesh& mesh, const Vec3& p) {
  int winding = 0;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) winding += crossing(mesh, i, p);
  return winding;
}

WindingNumber::WindingNumber(const TriangleMesh& mesh)
    : mesh_(mesh), lower_(Vec2::Zero()), upper_(Vec2::Zero()) {
  if (!mesh_.vertices.empty()) lower_ = upper_ = mesh_.vertices[0].head<2>();
  for (const Vec3& v : mesh_.vertices) {
    lower_ = lower_.cwiseMin(v.head<2>());
    upper_ = upper_.cwiseMax(v.head<2>());
  }
  columns_a_side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(mesh_.triangles.size()))));

  // Two passes over the triangles: count those of each column, then put them in.
  first_.assign(at(columns_a_side_ * columns_a_side_ + 1), 0);
  const auto for_each_column = [this](int triangle, const auto& visit) {
    Vec2 low = upper_, high = lower_;
    for (const int v : mesh_.triangles[at(triangle)]) {
      low = low.cwiseMin(mesh_.vertices[at(v)].head<2>());
      high = high.cwiseMax(mesh_.vertices[at(v)].head<2>());
    }
    const int from = column(low.x(), low.y()), to = column(high.x(), high.y());
    for (int y = from / columns_a_side_; y <= to / columns_a_side_; ++y) {
      for (int x = from % columns_a_side_; x <= to % columns_a_side_; ++x) visit(y * columns_a_side_ + x);
    }
  };
  const int count = static_cast<int>(mesh_.triangles.size());
  for (int i = 0; i < count; ++i) for_each_column(i, [this](int c) { ++first_[at(c + 1)]; });
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  triangles_.resize(at(first_.back()));
  std::vector<int> next = first_;
  for (int i = 0; i < count; ++i) {
    for_each_column(i, [&, this](int c) { triangles_[at(next[at(c)]++)] = i; });
  }
}

int WindingNumber::column(double x, double y) const {
  const auto cell = [this](double value, double low, double high) {
    if (!(high > low)) return 0;
    return std::clamp(static_cast<int>((value - low) / (high - low) * columns_a_side_), 0,
                      columns_a_side_ - 1);
  };
  return cell(y, lower_.y(), upper_.y()) * columns_a_side_ + cell(x, lower_.x(), upper_.x());
}

int WindingNumber::operator()(const Vec3& p) const {
  if ((p.head<2>().array() < lower_.array()).any() || (p.head<2>().array() > upper_.array()).any()) return 0;
  const int c = column(p.x(), p.y());
  int winding = 0;
  for (int i = first_[at(c)]; i < first_[at(c + 1)]; ++i) winding += crossing(mesh_, triangles_[at(i)], p);
  return winding;
}

std::function<bool(const Vec3&)> make_inside_test(const Shape& shape) {
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) {
    return [winding = std::make_shared<const WindingNumber>(*mesh->mesh)](const Vec3& p) {
      return (*winding)(p) >= 1;
    };
  }
  return [shape](const Vec3& p) { return contains(shape, p); };
}

}  // namespace rigor
