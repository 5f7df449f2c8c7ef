#include "rigor/geometry/contacts/contact_pair.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rigor {
namespace {

/// Lines at a larger angle to each other are never taken for parallel.
constexpr double kLargestParallelAngle = 1e-3;

/// Two lines side by side: the stretch where each runs beside the other.
struct SideBySide {
  const SurfaceLine* line_A;
  const SurfaceLine* line_B;
  double overlap;                ///< [m].
  std::array<Vec3, 2> p_A, p_B;  ///< Its two ends on each line.
  std::array<Feature, 2> f_A, f_B;
  std::array<bool, 2> A_ends, B_ends;  ///< Whether that line itself ends there.
};

/// Point of the line at a given coordinate along the unit vector d.
Vec3 point_at(const SurfaceLine& line, const Vec3& d, double coordinate) {
  const double slope = (line.b - line.a).dot(d);
  return line.a + (coordinate - line.a.dot(d)) / slope * (line.b - line.a);
}

/// The overlap of two nearly parallel lines, if they stay beside each other within the tolerance.
std::optional<SideBySide> side_by_side(const ContactPair& pair, const SurfaceLine& line_A,
                                       const SurfaceLine& line_B, const Vec3& n) {
  const Vec3 d_A = (line_A.b - line_A.a).normalized();
  Vec3 d_B = (line_B.b - line_B.a).normalized();
  if (d_A.cross(d_B).norm() > kLargestParallelAngle) return {};
  if (d_A.dot(d_B) < 0) d_B = -d_B;
  const Vec3 d = (d_A + d_B).normalized();

  // The common stretch along the mean direction d.
  const auto lower_end = [&](const SurfaceLine& line) { return std::min(line.a.dot(d), line.b.dot(d)); };
  const auto upper_end = [&](const SurfaceLine& line) { return std::max(line.a.dot(d), line.b.dot(d)); };
  const std::array<double, 2> ends_A{lower_end(line_A), upper_end(line_A)};
  const std::array<double, 2> ends_B{lower_end(line_B), upper_end(line_B)};
  const std::array<double, 2> ends{std::max(ends_A[0], ends_B[0]), std::min(ends_A[1], ends_B[1])};
  SideBySide result{.line_A = &line_A, .line_B = &line_B, .overlap = ends[1] - ends[0]};
  if (!(result.overlap > pair.scale.merge)) return {};

  // At each end of it the two points, whether they lie over each other along n, and which line ends there.
  for (std::size_t k = 0; k < 2; ++k) {
    result.p_A[k] = point_at(line_A, d, ends[k]);
    result.p_B[k] = point_at(line_B, d, ends[k]);
    const Vec3 apart = result.p_B[k] - result.p_A[k];
    const double aside = std::abs(apart.dot(d.cross(n)));
    if (aside > std::max(pair.scale.tolerance, pair.scale.slack)) return {};
    result.A_ends[k] = std::abs(ends_A[k] - ends[k]) <= pair.scale.slack;
    result.B_ends[k] = std::abs(ends_B[k] - ends[k]) <= pair.scale.slack;
    const auto end_feature = [&](const SurfaceLine& line) {
      const bool a_is_lower = line.a.dot(d) <= line.b.dot(d);
      return (k == 0) == a_is_lower ? line.feature_a : line.feature_b;
    };
    result.f_A[k] = result.A_ends[k] ? end_feature(line_A) : line_A.feature;
    result.f_B[k] = result.B_ends[k] ? end_feature(line_B) : line_B.feature;
  }
  return result;
}

/// An edge or corner of a body without its own normal: an edge of a polyhedron, a rim, a vertex.
bool is_sharp(const Feature& feature) {
  return feature.kind == Feature::Kind::vertex || feature.kind == Feature::Kind::edge;
}

ContactPoint contact_at(const ContactPair& pair, const Vec3& p_A, const Vec3& p_B, const Vec3& n,
                        const Feature& f_A, const Feature& f_B) {
  return {.p_WA = p_A,
          .p_WB = p_B,
          .n_W = n,
          .gap = n.dot(p_B - p_A),
          .feature = feature_pair(f_A, f_B),
          .curvature_A = pair.a.curvature(f_A, p_A, n),
          .curvature_B = pair.b.curvature(f_B, p_B, -n)};
}

std::vector<ContactPoint> parallel_contacts(const ContactPair& pair, const SideBySide& lines, const Vec3& n) {
  std::vector<ContactPoint> contacts;
  for (std::size_t k = 0; k < 2; ++k) {
    ContactPoint contact = contact_at(pair, lines.p_A[k], lines.p_B[k], n, lines.f_A[k], lines.f_B[k]);
    contact.degenerate = is_sharp(lines.line_A->feature) && is_sharp(lines.line_B->feature);
    contacts.push_back(contact);
  }
  return contacts;
}

/// The crossing of two lines whose common normal separates the bodies as well as n does.
std::optional<ContactPoint> crossing_contact(const ContactPair& pair, const SurfaceLine& line_A,
                                             const SurfaceLine& line_B, const Vec3& n) {
  // The common normal, if it separates the bodies as well as n.
  const Vec3 u = line_A.b - line_A.a, v = line_B.b - line_B.a;
  const Vec3 normal = u.cross(v);
  const double area = normal.norm();
  if (!(area > 1e-9 * u.norm() * v.norm())) return {};
  const Vec3 n_cross = normal.dot(n) < 0 ? (-normal / area).eval() : (normal / area).eval();
  if (separation(pair, n_cross) < separation(pair, n) - pair.scale.tie) return {};

  // a + s u and b + t v differ by a multiple of u × v.
  const Vec3 from = line_B.a - line_A.a;
  const double s = from.cross(v).dot(normal) / (area * area);
  const double t = from.cross(u).dot(normal) / (area * area);
  const double slack_s = pair.scale.slack / u.norm(), slack_t = pair.scale.slack / v.norm();
  if (s < -slack_s || s > 1 + slack_s || t < -slack_t || t > 1 + slack_t) return {};
  // Both points are on their segments: a contact.
  ContactPoint contact =
      contact_at(pair, line_A.a + s * u, line_B.a + t * v, n_cross, line_A.feature, line_B.feature);
  // At the end of an edge it is a vertex that touches.
  const bool at_end = std::min(s, 1 - s) < slack_s || std::min(t, 1 - t) < slack_t;
  contact.degenerate = at_end && is_sharp(line_A.feature) && is_sharp(line_B.feature);
  return contact;
}

/// The crossings along the normal whose smallest gap is the largest.
std::vector<ContactPoint> with_one_normal(const ContactPair& pair, std::vector<ContactPoint> crossings) {
  if (crossings.empty()) return crossings;
  constexpr double same_direction = 1e-9;
  const auto share_normal = [](const ContactPoint& x, const ContactPoint& y) {
    return (x.n_W - y.n_W).norm() <= same_direction;
  };
  const auto smallest_gap = [&](const ContactPoint& of) {
    double gap = of.gap;
    for (const ContactPoint& other : crossings) {
      if (share_normal(of, other)) gap = std::min(gap, other.gap);
    }
    return gap;
  };
  const ContactPoint best = *std::max_element(
      crossings.begin(), crossings.end(),
      [&](const ContactPoint& x, const ContactPoint& y) { return smallest_gap(x) < smallest_gap(y); });
  std::erase_if(crossings, [&](const ContactPoint& contact) {
    return !share_normal(contact, best) || contact.gap > pair.scale.tolerance;
  });
  return crossings;
}

}  // namespace

// At almost no distance the witness points say little about the normal: there a smooth surface knows better.
ContactPoint witness_contact(const ContactPair& pair, const DistanceResult& distance) {
  Vec3 n = distance.n_W;
  const Feature f_A = pair.a.classify(distance.p_WA, n), f_B = pair.b.classify(distance.p_WB, -n);
  const std::optional<Vec3> m_A = pair.a.surface_normal(f_A, distance.p_WA);
  const std::optional<Vec3> m_B = pair.b.surface_normal(f_B, distance.p_WB);
  if ((m_A || m_B) && !pair.a.is_plane()) {
    const Vec3 of_surfaces = (m_A.value_or(Vec3::Zero()) - m_B.value_or(Vec3::Zero())).normalized();
    if (separation(pair, of_surfaces) >= separation(pair, n) - pair.scale.tie) n = of_surfaces;
  }
  ContactPoint contact = contact_at(pair, distance.p_WA, distance.p_WB, n, f_A, f_B);
  contact.gap = distance.distance;
  contact.degenerate = is_sharp(f_A) && is_sharp(f_B);
  return contact;
}

std::vector<ContactPoint> line_or_point_contacts(const ContactPair& pair, const DistanceResult& distance) {
  const Vec3& n = distance.n_W;
  const double reach = pair.scale.tolerance + pair.scale.slack;
  const std::vector<SurfaceLine> lines_A = pair.a.lines_along(n, reach);
  const std::vector<SurfaceLine> lines_B = pair.b.lines_along(-n, reach);

  // The longest stretch of parallel lines, if there is one.
  std::optional<SideBySide> longest;
  for (const SurfaceLine& line_A : lines_A) {
    for (const SurfaceLine& line_B : lines_B) {
      const std::optional<SideBySide> lines = side_by_side(pair, line_A, line_B, n);
      if (lines && (!longest || lines->overlap > longest->overlap)) longest = lines;
    }
  }
  if (longest) return parallel_contacts(pair, *longest, n);

  // Else where lines cross. Of several normals that separate equally well the one with the largest gap; but
  // an edge that lies on a face but for the tolerance crosses two of its borders with one normal, and both
  // count.
  std::vector<ContactPoint> crossings;
  for (const SurfaceLine& line_A : lines_A) {
    for (const SurfaceLine& line_B : lines_B) {
      const std::optional<ContactPoint> contact = crossing_contact(pair, line_A, line_B, n);
      if (contact) crossings.push_back(*contact);
    }
  }
  crossings = with_one_normal(pair, std::move(crossings));
  if (!crossings.empty()) return crossings;

  return {witness_contact(pair, distance)};
}

}  // namespace rigor
