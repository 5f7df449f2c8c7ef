#pragma once

#include "rigor/model/model.hpp"
#include "rigor/sim/witness/body_path.hpp"
#include "rigor/sim/witness/marked_body.hpp"

#include <optional>

namespace rigor {

/// A marker of one body as it is seen from a shape of another, while each has one piece of path. It is
/// followed in chords that stay within a quarter of its clearance of the way and turn by less than half a
/// radian.
class RelativeTrajectory {
 public:
  /// All arguments must outlive it.
  RelativeTrajectory(const PathPiece& of_marker, const Marker& marker, const PathPiece& of_solid,
                     const Body& solid, const BodyShape& shape)
      : of_marker_(of_marker),
        marker_(marker),
        offset_(marker.p_B.norm()),
        of_solid_(of_solid),
        solid_(solid),
        shape_(shape) {}

  /// When the marker first enters the solid in [ta, tb] [s]. Nothing where the orientation of a body on its
  /// way is not known and would matter.
  std::optional<double> first_entry(double ta, double tb) const;

 private:
  bool stay_apart(double ta, double tb) const;
  Vec3 seen(double t) const;
  bool may_meet(double ta, double tb) const;
  std::optional<double> between(double ta, const Vec3& a, double tb, const Vec3& b, int halvings) const;
  std::optional<double> entry_of_chord(const Vec3& a, const Vec3& b) const;

  const PathPiece& of_marker_;
  const Marker& marker_;
  double offset_;  ///< Of the marker from the centre of mass [m].
  const PathPiece& of_solid_;
  const Body& solid_;
  const BodyShape& shape_;
};

}  // namespace rigor
