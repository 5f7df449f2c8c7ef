#pragma once

#include "bulk_scenes.hpp"

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/model/model_builder.hpp"

#include <string>
#include <vector>

namespace rigor::bench {

// What scenes of many bodies are made of.

/// A builder with the one material of all scenes.
ModelBuilder scene_builder(const std::string& name);
ShapeDescription shape_at(const Shape& shape, const Vec3& p_US);
void add_body(const std::string& name, const Shape& shape, const Vec3& p_W, const Quat& q_W,
              ModelBuilder& builder);
void add_fixed(const std::string& name, const Shape& shape, const Vec3& p_W, const Quat& q_W,
               ModelBuilder& builder);
/// A floor whose top is y = 0.
void add_ground(ModelBuilder& builder);
/// Four walls around |x|, |z| < half_width, up to y = height.
void add_walls(double half_width, double height, ModelBuilder& builder);
/// Uniform over all rotations.
Quat draw_rotation(SceneDraws& draws);
/// Hulls of 20 to 30 points each, at `radius` from the origin in random directions.
std::vector<Convex> draw_hulls(double radius, SceneDraws& draws);

}  // namespace rigor::bench
