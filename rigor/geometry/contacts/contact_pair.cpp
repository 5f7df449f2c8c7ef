#include "rigor/geometry/contacts/contact_pair.hpp"

#include "rigor/geometry/contacts/face_clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {
namespace {

/// Points of the same place differ by rounding only: this part of the smaller shape's size.
constexpr double kMerge = 1e-9;
/// Rounding of positions and separations, relative to the larger shape.
constexpr double kRounding = 1e-13;
/// How far, in parts of the size, the witness points may be off the faces they lie on.
constexpr double kWitnessError = 1e-6;
/// Normals that differ by more are different directions.
constexpr double kSameNormal = 1e-6;
/// Faces whose heights over each other differ by less than this part of the tolerance lie on each other.
constexpr double kOnEachOther = 0.5;

struct ReferenceFace {
  FlatFace face;
  bool is_of_A;
  double separation;
  double alignment;  ///< Cosine with the separating direction.
};

/// Faces at the witness points with the separation along each one's normal.
std::vector<ReferenceFace> faces_at_witnesses(const ContactPair& pair, const DistanceResult& distance) {
  const double reach = pair.scale.tolerance + kWitnessError * std::max(pair.a.size(), pair.b.size());
  std::vector<ReferenceFace> faces;
  for (FlatFace& face : pair.a.faces_near(distance.p_WA, reach)) {
    const Vec3 n = face.normal;
    faces.push_back({std::move(face), true, separation(pair, n), n.dot(distance.n_W)});
  }
  for (FlatFace& face : pair.b.faces_near(distance.p_WB, reach)) {
    const Vec3 n = -face.normal;
    faces.push_back({std::move(face), false, separation(pair, n), n.dot(distance.n_W)});
  }
  return faces;
}

/// Unit normal of the face from A to B.
Vec3 normal_from_A(const ReferenceFace& face) {
  return face.is_of_A ? face.face.normal : -face.face.normal;
}

/// Those whose normals separate the shapes as well as any direction known. Where faces lie on each other up
/// to a tilt far below the tolerance, the best direction is that of two edges between their normals; then the
/// faces count that agree with it.
std::vector<ReferenceFace> best_faces(const ContactPair& pair, std::vector<ReferenceFace> faces,
                                      const Vec3& n) {
  // The largest separation known is the best bound of the signed distance.
  double best = separation(pair, n);
  for (const ReferenceFace& face : faces) best = std::max(best, face.separation);
  const double level = std::max(pair.scale.tie, kOnEachOther * pair.scale.tolerance);
  std::erase_if(faces, [&](const ReferenceFace& face) {
    const bool agrees = (normal_from_A(face) - n).norm() * pair.scale.size <= level;
    return face.separation < best - (agrees ? level : pair.scale.tie);
  });
  return faces;
}

/// The face to clip against among equally good ones: the best aligned with the separating direction, then the
/// larger, then A's, then the first.
const ReferenceFace& reference_face(const std::vector<ReferenceFace>& faces) {
  const ReferenceFace* best = &faces.front();
  for (const ReferenceFace& face : faces) {
    const bool is_better = face.alignment > best->alignment + kMerge ||
                           (face.alignment > best->alignment - kMerge && face.face.area > best->face.area);
    if (is_better) best = &face;
  }
  return *best;
}

/// A single point on the border of the face, where a vertex or an edge of the other shape meets an edge or a
/// corner.
bool is_on_border(const ContactPair& pair, const ReferenceFace& reference,
                  const std::vector<ContactPoint>& contacts) {
  if (contacts.size() != 1) return false;
  const ContactPoint& contact = contacts.front();
  const Feature feature =
      reference.is_of_A ? second_feature(contact.feature) : first_feature(contact.feature);
  const Vec3& p = reference.is_of_A ? contact.p_WA : contact.p_WB;
  return feature.kind != Feature::Kind::side && !lies_over(reference.face, p, -pair.scale.slack);
}

/// Faces in different directions separate equally well only where the shapes meet at an edge or a corner.
bool is_ambiguous(const std::vector<ReferenceFace>& faces) {
  return std::any_of(faces.begin(), faces.end(), [&](const ReferenceFace& face) {
    return (normal_from_A(face) - normal_from_A(faces.front())).norm() > kSameNormal;
  });
}

}  // namespace

ContactScale contact_scale(const ContactShape& a, const ContactShape& b, double tolerance) {
  const double smaller = a.is_plane() ? b.size() : b.is_plane() ? a.size() : std::min(a.size(), b.size());
  const double larger = std::max(a.size(), b.size());
  const double rounding = kRounding * larger;
  return {.size = smaller,
          .tolerance = tolerance,
          .tie = rounding,
          .slack = std::max(std::min(tolerance, kMerge * smaller), rounding),
          .merge = std::max(kMerge * smaller, rounding)};
}

double separation(const ContactPair& pair, const Vec3& n) {
  return n.dot(pair.b.support(-n) - pair.a.support(n));
}

std::vector<ContactPoint> convex_contacts(const ContactPair& pair, const DistanceResult& distance) {
  const std::vector<ReferenceFace> faces = best_faces(pair, faces_at_witnesses(pair, distance), distance.n_W);
  if (faces.empty()) return line_or_point_contacts(pair, distance);
  // The region on the best face. What touches on its border, or as well on a face in another direction, has
  // no sure normal.
  const ReferenceFace& reference = reference_face(faces);
  std::optional<std::vector<ContactPoint>> contacts = face_contacts(pair, reference.face, reference.is_of_A);
  if (!contacts) return line_or_point_contacts(pair, distance);
  if (is_ambiguous(faces) || is_on_border(pair, reference, *contacts)) {
    std::ranges::for_each(*contacts, [](ContactPoint& c) { c.degenerate = true; });
  }
  return *contacts;
}

bool is_their_way(const DistanceResult& distance, const std::vector<ContactPoint>& contacts) {
  return !contacts.empty() && std::ranges::all_of(contacts, [&](const ContactPoint& contact) {
    return (contact.n_W - distance.n_W).norm() <= kSameNormal;
  });
}

void add_witness(const ContactPair& pair, const DistanceResult& distance,
                 std::vector<ContactPoint>& contacts) {
  // One contact has to have the distance as its gap.
  const bool touches = std::any_of(contacts.begin(), contacts.end(), [&](const ContactPoint& contact) {
    return contact.gap <= distance.distance + pair.scale.merge;
  });
  // Contacts along a direction that separates the shapes better know a shorter way out.
  const bool is_shorter =
      !pair.a.is_plane() && std::ranges::any_of(contacts, [&](const ContactPoint& contact) {
        return separation(pair, contact.n_W) > distance.distance + pair.scale.merge;
      });
  if (!touches && !is_shorter) contacts.push_back(witness_contact(pair, distance));
}

void sort_and_merge(const ContactScale& scale, std::vector<ContactPoint>& contacts) {
  std::vector<ContactPoint> kept;
  for (const ContactPoint& contact : contacts) {
    const auto coincides = [&](const ContactPoint& other) {
      return (other.p_WA - contact.p_WA).norm() <= scale.merge &&
             (other.p_WB - contact.p_WB).norm() <= scale.merge && (other.n_W - contact.n_W).norm() <= kMerge;
    };
    if (contact.gap > scale.tolerance || std::any_of(kept.begin(), kept.end(), coincides)) continue;
    kept.push_back(contact);
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [](const ContactPoint& x, const ContactPoint& y) { return x.feature < y.feature; });
  contacts = std::move(kept);
}

}  // namespace rigor
