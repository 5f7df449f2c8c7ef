#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rigor::bench {

/// Makes a problem ready, and gives what finds its forces (3n).
using CoulombSolver = std::function<std::function<VecX()>(const CoulombProblem&)>;

struct NamedSolver {
  std::string name;
  CoulombSolver solve;
};

struct NamedProblem {
  std::string name;
  CoulombProblem laws;
};

#ifdef RIGOR_BENCH_SICONOS
/// Those of Siconos that solve most of such problems.
std::vector<NamedSolver> siconos_solvers();
/// A problem of contacts in space, its matrix made symmetric: text as Siconos writes it, or a local problem
/// of FCLIB (.hdf5). Nothing if the file holds none; std::runtime_error if it lacks a part.
std::optional<NamedProblem> read_problem(const std::string& path);
#endif

}  // namespace rigor::bench
