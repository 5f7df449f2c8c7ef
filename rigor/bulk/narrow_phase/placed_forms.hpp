#pragma once

#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/bulk/state/shape_ranges.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/core/index.hpp"

#include <unordered_map>
#include <vector>

namespace rigor {

/// A shape of a body: its form and its place, as indices. Balls about the centres of their bodies share a
/// place, which never changes.
struct PlacedForm {
  int form;
  int place;
  BulkShape::Kind kind;
  bool is_ball;
  bool has_core, has_faces, has_rings, is_ellipsoid;

  /// Whether meshes touch it in 32 bits: it has a core, with vertices or without.
  bool is_convex() const { return has_core | has_rings | is_ellipsoid; }
};

/// The forms of all shapes, which bodies that share their shapes share, and where each shape is in its body's
/// orientation.
class PlacedForms {
 public:
  explicit PlacedForms(const Model& model);
  /// After a body has come, gone, or become another.
  void set_body(const Model& model, int body);

  /// Places the shapes of all bodies that are in pairs.
  void place(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, const Executor& executor);

  const PlacedForm& of(int body, int shape) const { return shapes_[at(ranges_.begin(body) + shape)]; }
  const BulkShape& form(const PlacedForm& shape) const { return forms_[at(shape.form)]; }
  const PlacedShape& place_of(const PlacedForm& shape) const { return placed_[at(shape.place)]; }
  const FloatHulls& hulls() const { return hulls_; }

 private:
  PlacedForm placed_form_of(const BodyShape& shape);

  FloatHulls hulls_;
  std::vector<BulkShape> forms_;
  std::unordered_map<const BodyShape*, PlacedForm> known_;  ///< Including the places of centred balls.
  ShapeRanges ranges_;
  std::vector<PlacedForm> shapes_;
  std::vector<PlacedShape> placed_;
  std::vector<char> is_in_pair_;  ///< Each body.
};

}  // namespace rigor
