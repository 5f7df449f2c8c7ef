#pragma once

#include "rigor/geometry/shape/shape.hpp"

#include <array>
#include <span>

namespace rigor {

/// What tells two shapes of the same type apart: the numbers that define them.
struct ShapeData {
  std::array<double, 4> own{};  ///< Of a shape that holds its numbers itself; `count` of them.
  std::size_t count = 0;
  const void* shared = nullptr;  ///< Data that several shapes may share (hull, mesh, profile), or null.
  std::span<const double> shared_numbers;  ///< Coordinates in the shared data.

  /// In a fixed order [m]. They live as long as this and the shape.
  std::span<const double> numbers() const& {
    return shared != nullptr ? shared_numbers : std::span(own).first(count);
  }
};

/// Of a mesh the coordinates of the vertices alone, without its triangles.
ShapeData shape_data(const Shape& shape);

}  // namespace rigor
