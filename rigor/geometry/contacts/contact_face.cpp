#include "rigor/geometry/contacts/contact_pair.hpp"
#include "rigor/geometry/contacts/face_clip.hpp"

namespace rigor {
namespace {

/// In a contact with a face the face's side is flat; what rests on it is not: the ends of a line or a corner
/// that lies on the face is a point that rotates with its own body.
SurfaceCurvature without_flat_directions(SurfaceCurvature curvature) {
  curvature.flat_count = 0;
  curvature.flat_W = Vec3::Zero();
  return curvature;
}

/// What lies on a face at a point of the common region. Only the lowest point of a rim moves along it as the
/// normal turns; where a rim crosses a border it is a point of its body.
SurfaceCurvature resting_surface(const ContactShape& shape, const ClipPoint& point, const Vec3& m) {
  const bool is_on_rim = !shape.is_polyhedron() && point.shape_feature.kind == Feature::Kind::edge;
  if (point.kind == ClipPoint::Kind::crossing && is_on_rim) return {};
  return without_flat_directions(shape.curvature(point.shape_feature, point.p, m));
}

SurfaceCurvature flat_surface() {
  SurfaceCurvature curvature;
  curvature.flat_count = 2;
  return curvature;
}

}  // namespace

std::optional<std::vector<ContactPoint>> face_contacts(const ContactPair& pair, const FlatFace& face,
                                                       bool face_is_of_A) {
  // What the other shape shows to the plane of the face.
  const ContactShape& owner = face_is_of_A ? pair.a : pair.b;
  const ContactShape& shape = face_is_of_A ? pair.b : pair.a;
  const LowerSide side = shape.lower_side(face, pair.scale.tolerance);

  // The part of the face under it, by its corners; those within the tolerance are contacts.
  std::vector<ContactPoint> contacts;
  bool is_covered = false;
  for (const ClipPoint& point : clip(owner, face, shape, side, pair.scale.slack)) {
    const double gap = face.normal.dot(point.p - face.center);
    if (gap > pair.scale.tolerance) continue;
    is_covered = true;
    if (!point.is_real) continue;
    // The witness points lie over each other along the normal of the face. Of a corner of the face it is the
    // other side that is flat.
    const Vec3 p_face = point.p - gap * face.normal;
    const bool is_corner = point.kind == ClipPoint::Kind::face_corner;
    const SurfaceCurvature of_face = is_corner ? SurfaceCurvature{} : flat_surface();
    const SurfaceCurvature of_shape =
        is_corner ? flat_surface() : resting_surface(shape, point, -face.normal);
    ContactPoint contact{.p_WA = face_is_of_A ? p_face : point.p,
                         .p_WB = face_is_of_A ? point.p : p_face,
                         .n_W = face_is_of_A ? face.normal : (-face.normal).eval(),
                         .gap = gap,
                         .feature = face_is_of_A ? feature_pair(point.face_feature, point.shape_feature)
                                                 : feature_pair(point.shape_feature, point.face_feature),
                         .curvature_A = face_is_of_A ? of_face : of_shape,
                         .curvature_B = face_is_of_A ? of_shape : of_face};
    contacts.push_back(contact);
  }
  if (!is_covered) return {};
  return contacts;
}

}  // namespace rigor
