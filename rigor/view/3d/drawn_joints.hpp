#pragma once

#include "rigor/view/3d/drawn_scene.hpp"

#include <vector>

namespace rigor {

/// For each body, how far from its centre of mass the farthest anchor of its joints is [m]; 0 without joints.
std::vector<double> joint_reaches(const Model& model);

/// What joints and springs look like: from the centre of mass of each body that moves a thin rod to each
/// anchor, a small ball at the anchor, and a line between the two points of a distance joint or a spring.
/// Rods inside of a body's shapes are not seen, so only what the shapes leave open is filled.
void add_joints(const Model& model, DrawnScene& scene);

}  // namespace rigor
