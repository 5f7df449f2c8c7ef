#pragma once

#include "rigor/model/model.hpp"
#include "rigor/view/3d/color.hpp"

#include <vector>

namespace rigor {

/// The colours of a model's shapes: what the scene gives, else what fits.
///
/// Planes are light grey, static bodies grey, of a material whose name says what it is (wood, steel, stone,
/// ...) with a touch of its colour. Up to twelve bodies that move have the palette's colours by their index;
/// more have that of their material, or one of four by their form, each body in a shade of its own: a crowd
/// in all colours is hard to look at.
class ShapeColors {
 public:
  /// The model must outlive this object.
  explicit ShapeColors(const Model& model);
  Color of(int body, const BodyShape& shape) const;

 private:
  const Model& model_;
  bool is_crowd_;
  std::vector<int> forms_;  ///< Of each body: bodies of equal shapes have equal numbers.
};

}  // namespace rigor
