#include "rigor/sim/witness/enclosure.hpp"

#include "rigor/core/rounding.hpp"

#include <algorithm>
#include <variant>

namespace rigor {

Enclosure::Enclosure(const BodyShape& shape) {
  Pose X_BS = shape.X_BS;
  if (const Sphere* sphere = std::get_if<Sphere>(&shape.shape)) {
    kind_ = Kind::ball;
    radius_ = sphere->radius;
  } else if (const Cavity* cavity = std::get_if<Cavity>(&shape.shape)) {
    kind_ = Kind::outside_of_ball;
    radius_ = cavity->radius;
  } else if (const HalfSpace* plane = std::get_if<HalfSpace>(&shape.shape)) {
    kind_ = Kind::half_space;
    normal_ = plane->normal;
    radius_ = plane->offset;
  } else {
    const Aabb box = axis_aligned_box(shape.shape, Pose{Mat3::Identity(), Vec3::Zero()});
    half_ = 0.5 * (box.upper - box.lower);
    X_BS.p = X_BS * Vec3(0.5 * (box.lower + box.upper));
  }
  X_SB_ = X_BS.inverse();
}

double Enclosure::gap(const Vec3& p_B) const {
  const Vec3 p = X_SB_ * p_B;
  switch (kind_) {
    case Kind::ball:
      return std::max(0.0, p.norm() - radius_);
    case Kind::outside_of_ball:
      return std::max(0.0, radius_ - p.norm());
    case Kind::half_space:
      return std::max(0.0, normal_.dot(p) - radius_);
    case Kind::box:
      break;
  }
  return (p.cwiseAbs() - half_).cwiseMax(0).norm();
}

double Enclosure::turning_radius() const {
  if (kind_ == Kind::half_space) return kInfinity;
  // The rotation about its own middle changes a box only: by no more than the way of its corners.
  return X_SB_.p.norm() + half_.norm();
}

Aabb Enclosure::box(const Pose& X_WB) const {
  if (kind_ == Kind::outside_of_ball || kind_ == Kind::half_space)
    return {Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)};
  const Pose X_WS = X_WB * X_SB_.inverse();
  const Vec3 reach = kind_ == Kind::ball ? Vec3(Vec3::Constant(radius_)) : Vec3(X_WS.R.cwiseAbs() * half_);
  return {X_WS.p - reach, X_WS.p + reach};
}

}  // namespace rigor
