#pragma once

#include "rigor/geometry/contacts/contact_shape.hpp"

#include <vector>

namespace rigor {

/// A vertex of the region in which a shape lies over a flat face.
struct ClipPoint {
  enum class Kind {
    shape_point,  ///< A corner or lowest point of the shape over the face.
    crossing,     ///< A line of the shape over the border of the face.
    face_corner,  ///< A corner of the face under the shape.
  };
  Kind kind;
  Vec3 p;                ///< On the shape [m].
  Feature face_feature;  ///< Face, edge or corner of the face's owner.
  Feature shape_feature;
  bool is_real =
      true;  ///< False where flat pieces of a mesh meet: it belongs to the region, but is no vertex of it.
};

/// Does the prism over the face (along its normal) hold p, but for `slack`?
bool lies_over(const FlatFace& face, const Vec3& p, double slack);

/// Every vertex of the region of `shape` over `face` (of `owner`). Lines that only graze the border do not
/// count as crossing it: their ends and the face's corners carry them.
std::vector<ClipPoint> clip(const ContactShape& owner, const FlatFace& face, const ContactShape& shape,
                            const LowerSide& side, double slack);

}  // namespace rigor
