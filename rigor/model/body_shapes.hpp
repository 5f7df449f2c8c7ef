#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rigor {

/// A shape of a body with its place on it.
struct BodyShape {
  Shape shape;
  Pose X_BS;          ///< Pose of the shape's frame S in the body frame B.
  int material = 0;   ///< Index into Model::materials().
  double radius = 0;  ///< Of the ball about the origin of S that holds the shape [m]; infinite for a plane.
  std::string color;  ///< "#rgb" or "#rrggbb", or empty.
};

/// The shapes of a body: a vector, which bodies with equal shapes share.
class BodyShapes {
 public:
  BodyShapes() = default;
  BodyShapes(std::vector<BodyShape> shapes)  // NOLINT(google-explicit-constructor): it is such a vector.
      : shapes_(shapes.empty() ? nullptr : std::make_shared<std::vector<BodyShape>>(std::move(shapes))) {}

  const std::vector<BodyShape>& all() const;
  operator const std::vector<BodyShape>&() const { return all(); }  // NOLINT(google-explicit-constructor)
  bool empty() const { return !shapes_; }
  std::size_t size() const { return shapes_ ? shapes_->size() : 0; }
  const BodyShape& operator[](std::size_t i) const { return (*shapes_)[i]; }
  const BodyShape& front() const { return shapes_->front(); }
  const BodyShape& back() const { return shapes_->back(); }
  std::vector<BodyShape>::const_iterator begin() const { return all().begin(); }
  std::vector<BodyShape>::const_iterator end() const { return all().end(); }

 private:
  std::shared_ptr<const std::vector<BodyShape>> shapes_;  ///< Null if there are none.
};

/// Lets bodies with equal shapes share them. Hulls and meshes are equal if they are the same object.
class SharedShapes {
 public:
  void share(BodyShapes& shapes);

 private:
  std::unordered_multimap<std::size_t, BodyShapes> known_;  ///< By their hash.
};

}  // namespace rigor
