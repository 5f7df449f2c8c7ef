#pragma once

#include "rigor/bulk/collide_polytopes.hpp"
#include "rigor/geometry/lane_target.hpp"

namespace rigor {

// The loops over vertices, faces and edges of hulls, eight at a time, for either target.

/// q = M p + t of all of them.
void map_columns(const LaneColumns& from, const Mat3f& M, const Vec3f& t, LaneTarget target,
                 float* const* to);

/// n · p of all of them.
void find_heights(const LaneColumns& points, const Vec3f& n, LaneTarget target, float* heights);
/// The least of them.
float find_lowest(const LaneColumns& points, const Vec3f& n, LaneTarget target);

/// Which of the arcs of B cross arc i of A, of eight from number `first` on: a mask of bits. B's normals are
/// those of its faces, its arcs on the Gauss map the opposite.
unsigned find_crossing_arcs(const ArcColumns& a, std::size_t i, const ArcColumns& b, std::size_t first,
                            LaneTarget target);

}  // namespace rigor
