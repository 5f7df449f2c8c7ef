#pragma once

#include "rigor/solver/motion/motion_modes.hpp"

#include <string>
#include <vector>

namespace rigor::heaps {

/// Contact problems of heaps, written as rules and not as numbers: each is made from its kind, its number of
/// layers and its seed, with the same bits on every machine.
///
/// Bodies:
///   wall     bricks of 0.2 × 0.1 × 0.1 m in running bond: `layers` rows of `layers` bricks;
///   pyramid  bricks of 0.19 × 0.19 × 0.1 m on a grid of 0.2 m, each on up to four: `layers` layers of
///            layers², (layers - 1)², … bricks;
///   balls    balls of 0.1 m radius in the same places of a grid of 0.21 m, each in the pocket of four.
/// Masses: density 1000 kg/m³ times a factor between 1 and 4, drawn for each body.
/// Contacts: where two bodies or a body and the floor touch; of two faces the four corners of what they have
/// in common. The friction of all is one number, drawn between 0.2 and 0.8.
/// Motion: -g h ẑ with h = 0.01 s; for `blow` > 0 also random parts of up to `blow` m/s and 5 `blow` rad/s
/// for each body, and a third of the contacts may first close at up to `blow` / 2 m/s (g⁺/h). Draws: mt19937
/// of the seed, each number generator() / 2³².
enum class Kind { wall, pyramid, balls };

struct Heap {
  Kind kind;
  int layers;
  double blow;
  unsigned seed;
};

/// The 60 problems: 8 to 1,924 contacts. They say nothing of how often problems are solved: what was far from
/// it was left out, balls of seven layers (413 contacts: 1.8e-4 at rest, 7e-5 struck) and walls of eleven and
/// sixteen layers that are struck hard (2e-8, 1.5e-10).
std::vector<Heap> all_heaps();
std::string name_of(const Heap& heap);
MotionProblem problem_of(const Heap& heap);

/// How far forces are from Coulomb's law, as coulomb_residual says it, worked out on the rows.
double residual_of(const MotionProblem& problem, const VecX& lambda);

}  // namespace rigor::heaps
