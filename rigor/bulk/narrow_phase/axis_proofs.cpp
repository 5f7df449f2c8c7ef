#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// A proof does not count if it leaves directions at a larger angle than this [rad] undecided. A face is lone
/// if no other normal of its core is within twice this angle.
constexpr float kNear = 0.01f;

/// The radius of the foot below, of two crossing edges: differences of their points fill a parallelogram with
/// the sides u and v, and the crossing has this distance from its border.
float crossing_radius(const PlacedPolytopes& pair, const SeparatingAxis& axis) {
  const Vec3f u = pair.a.edge_vector(axis.a), v = pair.b.edge_vector(axis.b);
  const Vec3f p = pair.a.vertex(pair.a.edge(axis.a).v0), q = pair.b.vertex(pair.b.edge(axis.b).v0);
  const SegmentPoints points = nearest_on_segments(p, u, q, v);
  const float area = u.cross(v).norm();
  const float inside_u = std::min(points.s, 1 - points.s), inside_v = std::min(points.t, 1 - points.t);
  return area * std::min(inside_u / v.norm(), inside_v / u.norm());
}

/// The radius of the foot (docs/theory/narrow_phase.md): laid flat along the axis n, the differences b - a of
/// points of the cores hold a disk of this radius about the origin, at the height `separation` over it.
/// Negative if they do not.
float foot_radius(const PlacedPolytopes& pair, const SeparatingAxis& axis) {
  if (axis.kind == SeparatingAxis::Kind::edges) return crossing_radius(pair, axis);
  // A vertex lies over a face: the foot reaches as far as the nearest border of the face.
  const bool is_of_A = axis.kind == SeparatingAxis::Kind::face_of_A;
  const PlacedPolytope &own = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
  const int face = is_of_A ? axis.a : axis.b;
  const Vec3f m = own.normal(face);
  const Vec3f p = other.vertex(is_of_A ? axis.b : axis.a);
  const FloatHull& hull = *own.hull;
  const int begin = hull.loop_begin[at(face)], end = hull.loop_begin[at(face + 1)];
  // The distance of the vertex from each side of the face, counted inwards.
  float radius = std::numeric_limits<float>::infinity();
  Vec3f corner = own.vertex(hull.loop[at(end - 1)]);
  for (int k = begin; k < end; ++k) {
    const Vec3f next = own.vertex(hull.loop[at(k)]);
    const Vec3f inward = m.cross(next - corner);
    radius = std::min(radius, inward.dot(p - corner) / inward.norm());
    corner = next;
  }
  return radius;
}

/// Whether the foot of this radius and the balls inside prove that no direction separates the cores by more
/// than the axis does, less `clearly`. The foot proves it only for directions at an angle from which on it
/// loses `clearly`.
bool is_best_by(float radius, float clearly, const BallBound& bound, const SeparatingAxis& axis) {
  // The foot decides up to the angle θ with tan(θ/2) = r / |s|, the balls beyond it.
  const float overlap = std::max(0.0f, -axis.separation);
  const float tangent = radius < overlap ? radius / overlap : 1.0f;
  const float scale = 1 / (1 + tangent * tangent);
  const float cosine = (1 - tangent * tangent) * scale, sine = 2 * tangent * scale;
  // Beyond θ the bound of the balls, m · d at most n · d cos θ + d_t sin θ, decreases if n is closer to d
  // than θ; it has to be low enough at θ itself.
  const float along = axis.n.dot(bound.between);
  const float across = (bound.between - along * axis.n).norm();
  return along * sine >= across * cosine &&
         along * cosine + across * sine - bound.balls <= axis.separation - clearly;
}

/// Whether no face and no other edge of the core is highest along a direction at an angle of no more than
/// `near` from n: all its other vertices are so much lower that rotating n by that angle lifts none of them
/// to the top.
bool is_edge_alone(const PlacedPolytope& core, int e, const Vec3f& n, float near, float rounding) {
  const float drop = 2 * near * core.extent + rounding;
  // Rotating n by ε changes no height by more than ε times the size of the core, and so no difference of two
  // by more than twice that.
  const SupportSet set =
      find_support_set(core.vertices(), core.hull->vertex_count, n, drop, best_lane_target());
  const auto is_highest = [&](int v) { return n.dot(core.vertex(v)) >= set.height - rounding; };
  return set.count == 2 && is_highest(core.edge(e).v0) && is_highest(core.edge(e).v1);
}

/// Of the best face of B and the face of A that is nearly parallel to it, if there is one, the one that the
/// whole search takes.
std::optional<SeparatingAxis> choose_face(const PlacedPolytopes& pair, const SeparatingAxis& axis) {
  const float cosine = std::cos(kNear);
  if (pair.a.hull->face_count == 0) return axis;
  const Support facing = find_support(pair.a.normals(), axis.n, best_lane_target());
  // Without a face of A nearly parallel to it, the face of B has no rival.
  if (facing.height < cosine) return axis;
  if (!pair.a.hull->is_lone[at(facing.index)]) return std::nullopt;
  // With exactly one, the two are compared as the whole search compares them: the face of A is preferred.
  const SeparatingAxis of_A = face_axis(pair, true, facing.index);
  return axis.separation > of_A.separation + pair.rounding ? axis : of_A;
}

}  // namespace

bool is_well_conditioned(const PlacedPolytopes& pair, const SeparatingAxis& axis) {
  constexpr float least_square_sine = 0.01f;
  if (axis.kind != SeparatingAxis::Kind::edges) return true;
  const Vec3f u = pair.a.edge_vector(axis.a), v = pair.b.edge_vector(axis.b);
  return u.cross(v).squaredNorm() > least_square_sine * u.squaredNorm() * v.squaredNorm();
}

bool is_best(const PlacedPolytopes& pair, const BallBound& bound, const SeparatingAxis& axis) {
  if (axis.kind == SeparatingAxis::Kind::none) return false;
  const float radius = foot_radius(pair, axis);
  if (!(radius >= 4 * pair.rounding)) return false;
  return axis.separation >= 0 || is_best_by(radius, 0, bound, axis);
}

std::optional<SeparatingAxis> settle(const PlacedPolytopes& pair, const BallBound& bound,
                                     const SeparatingAxis& axis) {
  if (axis.kind == SeparatingAxis::Kind::none) return std::nullopt;
  // The foot has to decide with half its radius: then directions beyond the angle `near` are worse by what
  // the other half takes.
  const float half_radius = 0.5f * foot_radius(pair, axis), clearly = 4 * pair.rounding;
  if (!(half_radius * kNear >= clearly) || !is_best_by(half_radius, clearly, bound, axis))
    return std::nullopt;
  // Nearer than the angle from which on the foot decides, there must be no other feature that the whole
  // search might take instead. For a face that is another face of its own core: those of the other and edges
  // would have to be better by the rounding.
  if (axis.kind == SeparatingAxis::Kind::face_of_A)
    return pair.a.hull->is_lone[at(axis.a)] ? std::optional(axis) : std::nullopt;
  if (axis.kind == SeparatingAxis::Kind::face_of_B)
    return pair.b.hull->is_lone[at(axis.b)] ? choose_face(pair, axis) : std::nullopt;
  // Edges have to be alone: no other edge and no face is highest along any direction so near.
  const float near = clearly / half_radius;
  return is_well_conditioned(pair, axis) && is_edge_alone(pair.a, axis.a, axis.n, near, pair.rounding) &&
                 is_edge_alone(pair.b, axis.b, -axis.n, near, pair.rounding)
             ? std::optional(axis)
             : std::nullopt;
}

}  // namespace rigor
