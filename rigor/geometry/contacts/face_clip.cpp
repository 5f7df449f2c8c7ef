#include "rigor/geometry/contacts/face_clip.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rigor {
namespace {

/// Side of a polygonal face: the line, and the unit vector in the face that points to its inside.
struct Border {
  Vec3 a, b;
  Vec3 along;  ///< Unit.
  Vec3 inward;
  double length;
};

Border border(const FlatFace& face, std::size_t k) {
  const Vec3& a = face.corners[k].p;
  const Vec3& b = face.corners[(k + 1) % face.corners.size()].p;
  const double length = (b - a).norm();
  const Vec3 along = (b - a) / length;
  return {a, b, along, face.normal.cross(along), length};
}

/// Where on the segment from a to b (0 to 1) it crosses the border strictly: ends nearer than slack do not
/// cross.
std::optional<double> crossing(const Border& edge, const Vec3& a, const Vec3& b, double slack) {
  const double height_a = edge.inward.dot(a - edge.a), height_b = edge.inward.dot(b - edge.a);
  const bool is_strict = std::min(height_a, height_b) < -slack && std::max(height_a, height_b) > slack;
  if (!is_strict) return {};
  // Linear interpolation of the height over the border, then whether the crossing lies between its ends.
  const double place = height_a / (height_a - height_b);
  const double along = edge.along.dot(a + place * (b - a) - edge.a);
  if (along <= slack || along >= edge.length - slack) return {};
  return place;
}

/// Where on the segment from a to b (0 to 1) it crosses the wall over the rim of a disk, strictly.
std::vector<double> crossings(const FlatFace& disk, const Vec3& a, const Vec3& b, double slack) {
  // The segment as seen along the normal of the disk.
  const Vec3 n = disk.normal;
  const Vec3 from = a - disk.center - n.dot(a - disk.center) * n;
  const Vec3 along = b - a - n.dot(b - a) * n;
  const double length = along.norm();
  if (length <= 2 * slack) return {};
  // |from + x along/length| = radius, from the foot of the perpendicular to both sides.
  const double foot = -from.dot(along) / length;
  const double off = (from + foot / length * along).norm();
  if (off >= disk.radius) return {};
  const double half_chord = std::sqrt((disk.radius - off) * (disk.radius + off));
  // The two ends of the chord, as far as they are on the segment.
  std::vector<double> places;
  for (const double x : {foot - half_chord, foot + half_chord}) {
    if (x > slack && x < length - slack) places.push_back(x / length);
  }
  return places;
}

/// Clips one shape against one face; collects the points.
class Clipper {
 public:
  Clipper(const ContactShape& owner, const FlatFace& face, const ContactShape& shape, const LowerSide& side,
          double slack)
      : owner_(owner), face_(face), shape_(shape), side_(side), slack_(slack) {}

  std::vector<ClipPoint> clip() {
    for (const SurfacePoint& point : side_.points) {
      if (!lies_over(face_, point.p, slack_)) continue;
      points_.push_back({ClipPoint::Kind::shape_point, point.p, face_.feature, point.feature, point.is_real});
    }
    if (face_.kind == FlatFace::Kind::polygon) clip_against_polygon();
    if (face_.kind == FlatFace::Kind::disk) clip_against_disk();
    return points_;
  }

 private:
  void clip_against_polygon() {
    for (std::size_t k = 0; k < face_.corners.size(); ++k) {
      const FaceCorner& corner = face_.corners[k];
      add_corner(corner.p, owner_.vertex_feature(corner.vertex), corner.is_real);
      const Border edge = border(face_, k);
      const int next = face_.corners[(k + 1) % face_.corners.size()].vertex;
      const auto edge_feature = [&] { return owner_.edge_feature(corner.vertex, next); };
      for (const SurfaceLine& line : side_.lines) {
        const std::optional<double> place = crossing(edge, line.a, line.b, slack_);
        if (!place) continue;
        add_crossing(line.a + *place * (line.b - line.a), edge_feature(), line.feature,
                     corner.edge_is_real && line.is_real);
      }
      if (side_.disk) add_rim_crossings(edge, edge_feature(), corner.edge_is_real);
    }
  }

  /// The border is lifted to the plane of the disk and cut with its rim.
  void add_rim_crossings(const Border& edge, const Feature& edge_feature, bool is_real) {
    const FlatFace& disk = *side_.disk;
    const auto lifted = [&](const Vec3& p) {
      return (p + (disk.center - p).dot(disk.normal) / face_.normal.dot(disk.normal) * face_.normal).eval();
    };
    // Each crossing with the rim is a corner of the common region.
    const Vec3 a = lifted(edge.a), b = lifted(edge.b);
    int part = 0;
    for (const double place : crossings(disk, a, b, slack_)) {
      add_crossing(a + place * (b - a), edge_feature, {Feature::Kind::edge, disk.feature.index, part++},
                   is_real);
    }
  }

  void clip_against_disk() {
    // The four points that stand for the rim of this face count if the shape lies over them.
    for (int k = 0; k < 4; ++k) {
      const double sign = k < 2 ? 1 : -1;
      const Vec3 p = face_.center + sign * face_.radius * owner_.X_OS().R.col(k % 2);
      add_corner(p, {Feature::Kind::vertex, 4 * face_.feature.index + k}, true);
    }
    // Edges and rulings of the shape that cross the rim.
    for (const SurfaceLine& line : side_.lines) {
      int part = 0;
      for (const double place : crossings(face_, line.a, line.b, slack_)) {
        add_crossing(line.a + place * (line.b - line.a), {Feature::Kind::edge, face_.feature.index, part++},
                     line.feature, line.is_real);
      }
    }
    if (side_.disk) add_circle_crossings();
  }

  /// The two points where two rims cross as seen along the normal.
  void add_circle_crossings() {
    // The centres as seen along the normal; circles apart or one in the other do not cross.
    const FlatFace& disk = *side_.disk;
    const Vec3& n = face_.normal;
    const Vec3 between = disk.center - face_.center - n.dot(disk.center - face_.center) * n;
    const double distance = between.norm();
    const double r1 = face_.radius, r2 = disk.radius;
    if (distance >= r1 + r2 - slack_ || distance <= std::abs(r1 - r2) + slack_) return;
    // The common chord of two circles is square to the line of centres, at `along` from this one; its half is
    // `aside`.
    const double along = 0.5 * (distance + (r1 - r2) * (r1 + r2) / distance);
    const double aside = std::sqrt(std::max(0.0, (r1 - along) * (r1 + along)));
    const Vec3 x = between / distance;
    for (int part = 0; part < 2; ++part) {
      const Vec3 p = face_.center + along * x + (part == 0 ? aside : -aside) * n.cross(x);
      const double height = (disk.center - p).dot(disk.normal) / n.dot(disk.normal);
      const std::optional<Vec3> crossing = over_this_rim(disk, p + height * n);
      if (!crossing) continue;
      add_crossing(*crossing, {Feature::Kind::edge, face_.feature.index, part},
                   {Feature::Kind::edge, disk.feature.index, part}, true);
    }
  }

  /// The point of the rim of a disk that lies over the rim of this face, near `guess` in the plane of the
  /// disk: seen along the normal, the rim of a tilted disk is an ellipse. Nothing if they only come near.
  std::optional<Vec3> over_this_rim(const FlatFace& disk, const Vec3& guess) const {
    constexpr int most_steps = 20;
    const double rounding = 1e-13 * (face_.radius * face_.radius + disk.radius * disk.radius);
    const auto seen = [this](const Vec3& d) { return Vec3(d - face_.normal.dot(d) * face_.normal); };
    Vec3 p = guess;
    for (int k = 0; k < most_steps; ++k) {
      const Vec3 off = seen(p - face_.center), arm = p - disk.center;
      const double excess = off.squaredNorm() - face_.radius * face_.radius;
      const bool is_on_rim = std::abs(arm.squaredNorm() - disk.radius * disk.radius) <= rounding;
      if (is_on_rim && std::abs(excess) <= rounding) return p;
      // Newton's method along the rim, from the nearest point of it.
      const Vec3 outward = arm.normalized(), along = disk.normal.cross(outward);
      const Vec3 on_rim = disk.center + disk.radius * outward, off_rim = seen(on_rim - face_.center);
      const double slope = 2 * disk.radius * off_rim.dot(seen(along));
      const double angle =
          (off_rim.squaredNorm() - face_.radius * face_.radius) / (slope == 0 ? rounding : slope);
      if (!(std::abs(angle) < 1)) return {};
      p = disk.center + disk.radius * (std::cos(angle) * outward - std::sin(angle) * along);
    }
    return {};
  }

  void add_crossing(const Vec3& p, const Feature& on_face, const Feature& on_shape, bool is_real) {
    points_.push_back({ClipPoint::Kind::crossing, p, on_face, on_shape, is_real});
  }

  /// A corner of the face counts if a flat side of the shape lies over it, or one of its lines does.
  void add_corner(const Vec3& p, const Feature& feature, bool is_real) {
    // Under a flat side of the shape.
    const std::optional<double> height = shape_.height_above(p, face_.normal, side_.disk, slack_);
    if (height) {
      const Vec3 p_shape = p + *height * face_.normal;
      points_.push_back(
          {ClipPoint::Kind::face_corner, p_shape, feature, shape_.classify(p_shape, -face_.normal), is_real});
      return;
    }
    // Or under one of its lines: the point of the line over the corner, if it is that near.
    for (const SurfaceLine& line : side_.lines) {
      const Vec3 along = line.b - line.a;
      const Vec3 flat = along - face_.normal.dot(along) * face_.normal;
      if (!(flat.norm() > slack_)) continue;
      const double place = (p - line.a).dot(flat) / flat.squaredNorm();
      if (place < 0 || place > 1) continue;
      const Vec3 p_shape = line.a + place * along;
      const Vec3 off = p_shape - p;
      if ((off - face_.normal.dot(off) * face_.normal).norm() > slack_) continue;
      points_.push_back({ClipPoint::Kind::crossing, p_shape, feature, line.feature, is_real && line.is_real});
      return;
    }
  }

  const ContactShape& owner_;
  const FlatFace& face_;
  const ContactShape& shape_;
  const LowerSide& side_;
  const double slack_;
  std::vector<ClipPoint> points_;
};

}  // namespace

bool lies_over(const FlatFace& face, const Vec3& p, double slack) {
  if (face.kind == FlatFace::Kind::plane) return true;
  if (face.kind == FlatFace::Kind::disk) {
    const Vec3 off = p - face.center;
    return (off - face.normal.dot(off) * face.normal).norm() <= face.radius + slack;
  }
  for (std::size_t k = 0; k < face.corners.size(); ++k) {
    const Border edge = border(face, k);
    if (edge.inward.dot(p - edge.a) < -slack) return false;
  }
  return true;
}

std::vector<ClipPoint> clip(const ContactShape& owner, const FlatFace& face, const ContactShape& shape,
                            const LowerSide& side, double slack) {
  return Clipper(owner, face, shape, side, slack).clip();
}

}  // namespace rigor
