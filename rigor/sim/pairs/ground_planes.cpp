#include "rigor/sim/pairs/ground_planes.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/contacts/hidden_side.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"

#include <utility>
#include <variant>

namespace rigor {

namespace {

/// Of the radius of the body: pieces of ground whose heights differ by less are one floor.
constexpr double level = 1e-6;
/// Square of the angle between normals of one plane.
constexpr double same_plane = 1e-12;

/// A contact of a body with the ground, seen from the ground.
struct GroundContact {
  GroundContact(const Contact& contact, bool ground_is_A)
      : n(ground_is_A ? contact.point.n_W : (-contact.point.n_W).eval()),
        p(ground_is_A ? contact.point.p_WA : contact.point.p_WB),
        gap(contact.point.gap),
        ground(ground_is_A ? contact.body_A : contact.body_B),
        ground_shape(ground_is_A ? contact.shape_A : contact.shape_B),
        body(ground_is_A ? contact.body_B : contact.body_A),
        body_shape(ground_is_A ? contact.shape_B : contact.shape_A) {}

  Vec3 n;  ///< From the ground to the body.
  Vec3 p;  ///< On the ground [m].
  double gap;
  int ground, ground_shape, body, body_shape;
};

/// Whether the plane of a contact holds the body apart from the ground of another.
bool hides(const Model& model, const State& state, const GroundContact& plane, const GroundContact& side) {
  const auto shape_of = [&](int body, int shape) -> const Shape& {
    return model.body(body).shapes[at(shape)].shape;
  };
  const auto is_fixed = [&](int body) { return model.body(body).motion == MotionType::fixed; };
  const bool is_one_ground = plane.ground == side.ground || (is_fixed(plane.ground) && is_fixed(side.ground));
  if (!is_one_ground || (plane.n - side.n).squaredNorm() < same_plane) return false;
  if (std::holds_alternative<Mesh>(shape_of(plane.ground, plane.ground_shape))) return false;
  const auto X_W = [&](int body, int shape) {
    return pose_of(state, body) * model.body(body).shapes[at(shape)].X_BS;
  };
  return hides_side({plane.n, plane.p, plane.gap}, shape_of(plane.body, plane.body_shape),
                    X_W(plane.body, plane.body_shape), shape_of(side.ground, side.ground_shape),
                    X_W(side.ground, side.ground_shape), level * model.body(plane.body).bounding_radius);
}

bool is_on_ground(const Model& model, const Contact& contact) {
  const auto is_dynamic = [&](int body) { return model.body(body).motion == MotionType::dynamic; };
  return !contact.stop && is_dynamic(contact.body_A) != is_dynamic(contact.body_B);
}

GroundContact from_ground(const Model& model, const Contact& contact) {
  return {contact, model.body(contact.body_B).motion == MotionType::dynamic};
}

}  // namespace

GroundPlanes::GroundPlanes(const Model& model, const State& state, const std::vector<Contact>& near)
    : model_(model), state_(state) {
  for (const Contact& contact : near) {
    if (!is_on_ground(model, contact)) continue;
    const GroundContact plane = from_ground(model, contact);
    planes_[{plane.body, plane.body_shape}].push_back(contact);
  }
}

std::optional<Contact> GroundPlanes::plane_before(const Contact& contact) const {
  if (!is_on_ground(model_, contact)) return {};
  const GroundContact side = from_ground(model_, contact);
  const auto planes = planes_.find({side.body, side.body_shape});
  if (planes == planes_.end()) return {};
  for (const Contact& other : planes->second) {
    // Of two that hide each other, pieces of ground in one place, the first stays.
    const GroundContact plane = from_ground(model_, other);
    const bool is_first =
        std::pair{plane.ground, plane.ground_shape} < std::pair{side.ground, side.ground_shape};
    if (hides(model_, state_, plane, side) && (is_first || !hides(model_, state_, side, plane))) return other;
  }
  return {};
}

void GroundPlanes::take_out_hidden(std::vector<Contact>& contacts) const {
  std::erase_if(contacts, [this](const Contact& contact) { return plane_before(contact).has_value(); });
}

}  // namespace rigor
