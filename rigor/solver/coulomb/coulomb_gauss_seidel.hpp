#pragma once

#include "rigor/solver/coulomb/coulomb_guess.hpp"

#include <vector>

namespace rigor {

/// Block Gauss–Seidel for a CoulombProblem: contact after contact solved exactly (solve_coulomb_local) with
/// the others held, forth and back, so that the order matters less. Converges linearly and, for stacks,
/// slowly: its use is to find what the contacts do. Holds a reference to the problem.
class CoulombGaussSeidel {
 public:
  CoulombGaussSeidel(const CoulombProblem& problem, CoulombGuess start);

  /// One symmetric sweep. Returns the largest change of a force, relative to the largest force (0: nothing
  /// changed).
  double sweep();

  const CoulombGuess& guess() const { return guess_; }

 private:
  /// K of one contact, with the proximal term that makes a singular one definite.
  struct Block {
    Mat3 K;
    double proximal;
  };

  void relax(Eigen::Index contact);
  void relax_cone(Eigen::Index contact, const Block& block);
  void relax_slide(Eigen::Index contact, const Block& block);
  void set_force(Eigen::Index contact, const Vec3& lambda);

  const CoulombProblem& problem_;
  CoulombGuess guess_;
  VecX w_;
  std::vector<Block> blocks_;
  double largest_change_ = 0;
};

}  // namespace rigor
