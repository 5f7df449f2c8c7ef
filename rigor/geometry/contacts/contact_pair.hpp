#pragma once

#include "rigor/geometry/contacts/contact_shape.hpp"
#include "rigor/geometry/convex/distance_result.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// Two shapes near each other with their tolerances.
struct ContactPair {
  const ContactShape& a;
  const ContactShape& b;
  ContactScale scale;
};

ContactScale contact_scale(const ContactShape& a, const ContactShape& b, double tolerance);

/// min n·b - max n·a: the signed distance if n is the right unit normal, less otherwise. Not for planes.
double separation(const ContactPair& pair, const Vec3& n);

/// All contacts of a convex pair whose signed distance is known, in O (the fields that end in W hold vectors
/// in O). Of a face that explains the distance as well as the witnesses do, the whole clipped region; else
/// the meeting of two lines; else the witness points. One of them has the distance as its gap: a rim that is
/// tilted against a face by less than the tolerance, say, touches between the corners that stand for it, and
/// then its witness points join.
std::vector<ContactPoint> convex_contacts(const ContactPair& pair, const DistanceResult& distance);

/// Contacts of a shape with the flat face of another: every corner of the part of the face that the shape
/// covers with a gap within the tolerance; nothing if it covers none. Of a triangle inside a flat patch of a
/// mesh it may cover a part without a contact: the corners lie on other triangles.
std::optional<std::vector<ContactPoint>> face_contacts(const ContactPair& pair, const FlatFace& face,
                                                       bool face_is_of_A);

/// Contacts where no face takes part: two lines cross (one point) or run side by side (two), or one witness
/// point.
std::vector<ContactPoint> line_or_point_contacts(const ContactPair& pair, const DistanceResult& distance);

/// The contact at the witness points of the distance.
ContactPoint witness_contact(const ContactPair& pair, const DistanceResult& distance);

/// Adds the witness points of the distance if no contact has it as its gap: a rim that is tilted against a
/// face by less than the tolerance touches between the points that stand for it, and an edge that overlaps
/// another may lie beside the face that stands for both.
void add_witness(const ContactPair& pair, const DistanceResult& distance,
                 std::vector<ContactPoint>& contacts);

/// Whether the contacts have the normal of the distance: the shortest way out of an overlap may be another.
bool is_their_way(const DistanceResult& distance, const std::vector<ContactPoint>& contacts);

/// One point of those that coincide, in the order of features, none beyond the tolerance.
void sort_and_merge(const ContactScale& scale, std::vector<ContactPoint>& contacts);

}  // namespace rigor
