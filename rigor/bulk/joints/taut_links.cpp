#include "rigor/bulk/joints/taut_links.hpp"

#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"

namespace rigor {

namespace {

/// Part of the rotation of two fully taut bodies against each other that a substep takes away. Inertia that
/// changes from substep to substep with the pull feeds vibrations as noise does; half of this already stopped
/// all growth.
constexpr float kCalmed = 0.1F;

FloatSym3 operator+(const FloatSym3& A, const FloatSym3& B) {
  return {A.xx + B.xx, A.yy + B.yy, A.zz + B.zz, A.xy + B.xy, A.xz + B.xz, A.yz + B.yz};
}
FloatSym3 operator*(const FloatLanes& a, const FloatSym3& B) {
  return {a * B.xx, a * B.yy, a * B.zz, a * B.xy, a * B.xz, a * B.yz};
}
FloatSym3 zeros() {
  const FloatLanes zero = float_lanes(0);
  return {zero, zero, zero, zero, zero, zero};
}

/// h² K of one pull: a force that pulls at an arm resists rotations across the arm. K = (f · r) (E - r rᵀ/r²)
/// where f is along r; what presses counts as much, since it folds as fast.
FloatSym3 stiffness(float h, const FloatVec3& impulse, const FloatVec3& arm) {
  const FloatLanes along_arm = float_lanes(h) * dot(impulse, arm), pull = float_max(along_arm, -along_arm);
  const FloatLanes along = pull / float_max(dot(arm, arm), float_lanes(1e-30F));
  return {pull - along * arm.x * arm.x,           pull - along * arm.y * arm.y,
          pull - along * arm.z * arm.z,           float_lanes(0) - along * arm.x * arm.y,
          float_lanes(0) - along * arm.x * arm.z, float_lanes(0) - along * arm.y * arm.z};
}

/// tr(A B).
FloatLanes trace_of_product(const FloatSym3& A, const FloatSym3& B) {
  return A.xx * B.xx + A.yy * B.yy + A.zz * B.zz + 2.0F * (A.xy * B.xy + A.xz * B.xz + A.yz * B.yz);
}

}  // namespace

void Slack::add_body(const Vec3& moments, int joints, const Vec3& arm) {
  // x is at most twice the sum of h f r over the joints, by the least moment.
  const double least = kFastest * moments.minCoeff() / (2 * joints * arm.norm());
  if (least * least < squared) squared = least * least;
}

void invert(const FloatSym3& A, FloatSym3& inverse) {
  // Of B = A / tr A, whose products stay within 32 bits: cofactors over the determinant.
  const FloatLanes scale = 1.0F / (A.xx + A.yy + A.zz);
  const FloatSym3 B = scale * A;
  const FloatSym3 C = {B.yy * B.zz - B.yz * B.yz, B.xx * B.zz - B.xz * B.xz, B.xx * B.yy - B.xy * B.xy,
                       B.xz * B.yz - B.xy * B.zz, B.xy * B.yz - B.xz * B.yy, B.xy * B.xz - B.yz * B.xx};
  inverse = (scale / (B.xx * C.xx + B.xy * C.xy + B.xz * C.xz)) * C;
}

void stiffen(float h, const std::vector<TautLink>& links, std::vector<TautBody>& bodies) {
  // The pulls on each body.
  for (TautBody& body : bodies) body.stiffening = zeros();
  for (const TautLink& link : links) {
    TautBody &child = bodies[at(link.child)], &parent = bodies[at(link.parent)];
    child.stiffening = child.stiffening + stiffness(h, link.impulse, link.arm_child);
    parent.stiffening = parent.stiffening + stiffness(h, float_lanes(-1) * link.impulse, link.arm_parent);
  }
  // The part that is needed.
  for (TautBody& body : bodies) {
    const FloatLanes x = trace_of_product(body.inverse_inertia, body.stiffening);
    body.share = 1.0F - float_lanes(kFastest) / float_max(x, float_lanes(kFastest));
    body.stiffening = body.share * body.stiffening;
  }
}

unsigned raise(const FloatLanes& trace_of_inertia, const TautBody& more, TautBody& body) {
  const auto trace = [](const FloatSym3& A) { return A.xx + A.yy + A.zz; };
  const IntLanes is_more = trace(more.stiffening) > 2.0F * trace(body.stiffening) + trace_of_inertia;
  const auto take = [&](const FloatLanes& from, FloatLanes& to) { to = is_more ? from : to; };
  take(more.stiffening.xx, body.stiffening.xx);
  take(more.stiffening.yy, body.stiffening.yy);
  take(more.stiffening.zz, body.stiffening.zz);
  take(more.stiffening.xy, body.stiffening.xy);
  take(more.stiffening.xz, body.stiffening.xz);
  take(more.stiffening.yz, body.stiffening.yz);
  take(more.share, body.share);
  body.inverse_inertia = more.inverse_inertia;
  return lane_bits(is_more);
}

void calm(const std::vector<TautLink>& links, std::vector<TautBody>& bodies) {
  // Angular impulses (I⁻¹ of both)⁻¹ times the part of the relative rotation, all by the rotations of before.
  std::vector<FloatVec3> changes(bodies.size(), FloatVec3{float_lanes(0), float_lanes(0), float_lanes(0)});
  for (const TautLink& link : links) {
    const TautBody &child = bodies[at(link.child)], &parent = bodies[at(link.parent)];
    const FloatLanes part = float_lanes(kCalmed) * float_max(child.share, parent.share);
    FloatSym3 of_both;
    invert(child.inverse_inertia + parent.inverse_inertia, of_both);
    const FloatVec3 L = of_both * (part * (parent.w - child.w));
    changes[at(link.child)] = changes[at(link.child)] + child.inverse_inertia * L;
    changes[at(link.parent)] = changes[at(link.parent)] - parent.inverse_inertia * L;
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].w = bodies[i].w + changes[i];
}

}  // namespace rigor
