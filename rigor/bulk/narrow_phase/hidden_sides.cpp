#include "rigor/bulk/narrow_phase/hidden_sides.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/contacts/hidden_side.hpp"

#include <variant>

namespace rigor {

namespace {

/// Of the radius of the body: pieces of ground whose heights differ by less are one floor.
constexpr double level = 1e-3;
/// Square of the angle between normals of one plane.
constexpr double same_plane = 1e-6;

/// A manifold of a body with a piece of ground, seen from the ground.
struct GroundContact {
  GroundContact(const ShapePair& pair, const ManifoldView& manifold, bool ground_is_A)
      : n(manifold.normal[0], manifold.normal[1], manifold.normal[2]),
        ground(ground_is_A ? pair.body_A : pair.body_B),
        ground_shape(ground_is_A ? pair.shape_A : pair.shape_B),
        body(ground_is_A ? pair.body_B : pair.body_A),
        body_shape(ground_is_A ? pair.shape_B : pair.shape_A) {
    if (!ground_is_A) n = -n;
  }

  Vec3 n;  ///< From the ground to the body.
  int ground, ground_shape, body, body_shape;
};

}  // namespace

void HiddenSides::take_out(const Model& model, const BulkBodies& bodies, const std::vector<ShapePair>& pairs,
                           ManifoldList& manifolds) {
  // The manifolds of each body with the ground.
  last_.assign(bodies.x.size(), -1);
  before_.assign(manifolds.size(), -1);
  is_hidden_.assign(manifolds.size(), 0);
  const auto pair_of = [&](int i) -> const ShapePair& { return pairs[at(manifolds.pair(at(i)))]; };
  const auto contact = [&](int i) {
    return GroundContact(pair_of(i), manifolds.view(at(i)), !bodies.is_dynamic(pair_of(i).body_A));
  };
  const auto shape_of = [&](int body, int shape) -> const Shape& {
    return model.body(body).shapes[at(shape)].shape;
  };
  const auto pose_of = [&](int body, int shape) {
    return Pose{bodies.q[at(body)].toRotationMatrix(), bodies.x[at(body)]} *
           model.body(body).shapes[at(shape)].X_BS;
  };

  // Whether the plane of a contact holds the body apart from the ground of another.
  const auto hides = [&](int plane, int side) {
    const GroundContact a = contact(plane), b = contact(side);
    const bool is_one_ground = a.ground == b.ground || (model.body(a.ground).motion == MotionType::fixed &&
                                                        model.body(b.ground).motion == MotionType::fixed);
    const bool is_one_piece = a.ground == b.ground && a.ground_shape == b.ground_shape;
    if (!is_one_ground || is_one_piece || a.body_shape != b.body_shape) return false;
    if ((a.n - b.n).squaredNorm() < same_plane) return false;
    if (std::holds_alternative<Mesh>(shape_of(a.ground, a.ground_shape))) return false;

    // The plane, by the surface of the ground at the contact, and the deepest that the body is under it.
    const ManifoldView points = manifolds.view(at(plane));
    GroundPlane ground{a.n, Vec3::Zero(), 0};
    for (int k = 0; k < points.point_count; ++k) {
      const ManifoldPoint& point = points.points[k];
      if (k > 0 && point.gap >= ground.gap) continue;
      ground.gap = point.gap;
      ground.p_W = bodies.x[at(pair_of(plane).body_A)] + Vec3(point.p[0], point.p[1], point.p[2]) -
                   0.5 * point.gap * a.n;
    }
    return hides_side(ground, shape_of(a.body, a.body_shape), pose_of(a.body, a.body_shape),
                      shape_of(b.ground, b.ground_shape), pose_of(b.ground, b.ground_shape),
                      level * model.body(a.body).bounding_radius);
  };

  // Each with the others of its body.
  bool is_any = false;
  for (int i = 0; i < static_cast<int>(manifolds.size()); ++i) {
    const ShapePair& pair = pair_of(i);
    const bool is_A = bodies.is_dynamic(pair.body_A), is_B = bodies.is_dynamic(pair.body_B);
    if (is_A == is_B) continue;
    int& last = last_[at(is_A ? pair.body_A : pair.body_B)];
    for (int other = last; other >= 0; other = before_[at(other)]) {
      if (!is_hidden_[at(other)] && !is_hidden_[at(i)]) {
        is_hidden_[at(i)] = hides(other, i);
        if (!is_hidden_[at(i)]) is_hidden_[at(other)] = hides(i, other);
      }
      is_any = is_any || is_hidden_[at(i)] || is_hidden_[at(other)];
    }
    before_[at(i)] = last;
    last = i;
  }
  if (is_any) manifolds.take_out([&](std::size_t i) { return is_hidden_[i] != 0; });
}

}  // namespace rigor
