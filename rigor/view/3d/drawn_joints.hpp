#pragma once

#include "rigor/view/3d/drawn_scene.hpp"

#include <vector>

namespace rigor {

/// For each body, the distance of the farthest anchor of its joints from its centre of mass [m]; 0 without
/// joints.
std::vector<double> joint_reaches(const Model& model);

/// Adds the drawings of joints and springs: a thin rod from the centre of mass of each moving body to each
/// anchor, a small ball at the anchor, and a line between the two points of a distance joint or a spring.
/// Rods inside the shapes of a body are hidden, so they only bridge the gaps.
void add_joints(const Model& model, DrawnScene& scene);

}  // namespace rigor
