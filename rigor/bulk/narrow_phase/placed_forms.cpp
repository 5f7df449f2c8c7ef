#include "rigor/bulk/narrow_phase/placed_forms.hpp"

#include "rigor/bulk/lanes/list_room.hpp"

#include <algorithm>

namespace rigor {

namespace {

constexpr int kPlaceGrain = 1024;  ///< Bodies whose shapes one thread places at a time.

bool is_ball(const BulkShape& shape) {
  return shape.kind == BulkShape::Kind::round && shape.extent == 0;
}
/// Whether rotating the body does not move the shape.
bool is_centred_ball(const BulkShape& shape) {
  return is_ball(shape) && shape.X_BS.p.isZero(0);
}

}  // namespace

PlacedForms::PlacedForms(const Model& model) : ranges_(at(model.body_count())) {
  shapes_.reserve(at(model.body_count()));
  for (int i = 0; i < model.body_count(); ++i) set_body(model, i);
}

void PlacedForms::set_body(const Model& model, int body) {
  const BodyShapes& own = model.body(body).shapes;
  ranges_.give(body, static_cast<int>(own.size()));
  make_room(ranges_.size(), shapes_);
  shapes_.resize(std::max(shapes_.size(), ranges_.size()));
  for (std::size_t s = 0; s < own.size(); ++s) shapes_[at(ranges_.begin(body)) + s] = placed_form_of(own[s]);
}

/// The form of a shape and a place for it.
PlacedForm PlacedForms::placed_form_of(const BodyShape& shape) {
  constexpr int no_place = -1;
  // Bodies that share a shape share its form.
  const auto [known, is_new] =
      known_.emplace(&shape, PlacedForm{static_cast<int>(forms_.size()), no_place, BulkShape::Kind::other,
                                        false, false, false, false, false});
  if (is_new) forms_.push_back(make_bulk_shape(shape, hulls_));
  PlacedForm own = known->second;
  own.kind = form(own).kind;
  own.is_ball = is_ball(form(own));
  own.has_faces = own.kind == BulkShape::Kind::box || own.kind == BulkShape::Kind::hull;
  own.has_core = own.has_faces || own.kind == BulkShape::Kind::round;
  own.has_rings = own.kind == BulkShape::Kind::rings;
  own.is_ellipsoid = own.kind == BulkShape::Kind::ellipsoid;
  // Each shape has a place of its own, only balls about the centres of their bodies share one.
  if (own.place == no_place) {
    own.place = static_cast<int>(placed_.size());
    make_room(placed_.size() + 1, placed_);
    placed_.push_back(place_shape(form(own), Quat::Identity()));
    if (is_centred_ball(form(own))) known->second = own;
  }
  return own;
}

void PlacedForms::place(const BulkBodies& bodies, const std::vector<ShapePair>& pairs,
                        const Executor& executor) {
  is_in_pair_.assign(bodies.x.size(), 0);
  for (const ShapePair& pair : pairs) is_in_pair_[at(pair.body_A)] = is_in_pair_[at(pair.body_B)] = 1;
  executor.for_ranges(bodies.count(), kPlaceGrain, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      if (is_in_pair_[at(i)] == 0) continue;
      for (int k = ranges_.begin(i); k < ranges_.end(i); ++k) {
        const PlacedForm& shape = shapes_[at(k)];
        if (!(shape.is_ball && is_centred_ball(form(shape))))
          placed_[at(shape.place)] = place_shape(form(shape), bodies.q[at(i)]);
      }
    }
  });
}

}  // namespace rigor
