// Files of frictional contact problems, and Siconos' solvers of them.

#include "coulomb_peers.hpp"

#include <hdf5.h>
#include <Eigen/Sparse>

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <SparseBlockMatrix.h>
#include <fc3d_Solvers.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace rigor::bench {

using Eigen::Index;

namespace {

/// Siconos has the normal first, Rigor last.
constexpr int kRowOf[3] = {2, 0, 1};

Index rigor_row(Index row) {
  return row - row % 3 + kRowOf[row % 3];
}

CoulombProblem problem_of(const MatX& W, const VecX& q, const VecX& mu) {
  CoulombProblem problem;
  problem.A.resize(W.rows(), W.cols());
  problem.b.resize(q.size());
  for (Index i = 0; i < q.size(); ++i) {
    problem.b(rigor_row(i)) = q(i);
    for (Index k = 0; k < q.size(); ++k) problem.A(rigor_row(i), rigor_row(k)) = 0.5 * (W(i, k) + W(k, i));
  }
  problem.mu.assign(mu.begin(), mu.end());
  problem.rows.assign(problem.mu.size(), FrictionRow::cone);
  problem.slips.assign(problem.mu.size(), Vec2::UnitX());
  return problem;
}

/// A file of FCLIB.
class FclibFile {
 public:
  explicit FclibFile(const std::string& path) : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {}
  FclibFile(const FclibFile&) = delete;
  FclibFile& operator=(const FclibFile&) = delete;
  ~FclibFile() {
    if (file_ >= 0) H5Fclose(file_);
  }

  bool has(const std::string& group) const {
    return file_ >= 0 && H5Lexists(file_, group.c_str(), H5P_DEFAULT) > 0;
  }
  int integer(const std::string& name) const { return numbers<int>(name, H5T_NATIVE_INT).at(0); }
  VecX vector(const std::string& name) const {
    const std::vector<double> values = numbers<double>(name, H5T_NATIVE_DOUBLE);
    return Eigen::Map<const VecX>(values.data(), static_cast<Index>(values.size()));
  }
  /// Stored as triplets (nz ≥ 0), compressed columns (-1) or compressed rows (-2).
  Eigen::SparseMatrix<double> matrix(const std::string& name) const {
    const std::vector<int> p = numbers<int>(name + "/p", H5T_NATIVE_INT),
                           i = numbers<int>(name + "/i", H5T_NATIVE_INT);
    const std::vector<double> x = numbers<double>(name + "/x", H5T_NATIVE_DOUBLE);
    const int nz = integer(name + "/nz");
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t k = 0; nz >= 0 && k < static_cast<std::size_t>(nz); ++k)
      entries.emplace_back(i[k], p[k], x[k]);
    for (std::size_t outer = 0; nz < 0 && outer + 1 < p.size(); ++outer)
      for (auto k = static_cast<std::size_t>(p[outer]); k < static_cast<std::size_t>(p[outer + 1]); ++k) {
        const int line = static_cast<int>(outer);
        entries.emplace_back(nz == -1 ? i[k] : line, nz == -1 ? line : i[k], x[k]);
      }
    Eigen::SparseMatrix<double> result(integer(name + "/m"), integer(name + "/n"));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

 private:
  template <typename T>
  std::vector<T> numbers(const std::string& name, hid_t type) const {
    if (H5Lexists(file_, name.c_str(), H5P_DEFAULT) <= 0) throw std::runtime_error("there is no " + name);
    const hid_t data = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    const hid_t space = H5Dget_space(data);
    std::vector<T> result(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data());
    H5Sclose(space);
    H5Dclose(data);
    return result;
  }

  hid_t file_;
};

/// Local: u = W r + q. Global: M v = H r + f and u = Hᵀ v + w, so that W = Hᵀ M⁻¹ H and q = Hᵀ M⁻¹ f + w.
std::optional<CoulombProblem> read_fclib(const std::string& path) {
  const FclibFile file(path);
  if (file.has("/fclib_local") && file.integer("/fclib_local/spacedim") == 3)
    return problem_of(MatX(file.matrix("/fclib_local/W")), file.vector("/fclib_local/vectors/q"),
                      file.vector("/fclib_local/vectors/mu"));
  if (!file.has("/fclib_global") || file.integer("/fclib_global/spacedim") != 3) return std::nullopt;
  const Eigen::SparseMatrix<double> H = file.matrix("/fclib_global/H");
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> M(file.matrix("/fclib_global/M"));
  if (M.info() != Eigen::Success) throw std::runtime_error("its mass matrix is singular");
  const Eigen::SparseMatrix<double> W = H.transpose() * Eigen::SparseMatrix<double>(M.solve(H));
  const VecX q = H.transpose() * VecX(M.solve(file.vector("/fclib_global/vectors/f"))) +
                 file.vector("/fclib_global/vectors/w");
  return problem_of(MatX(W), q, file.vector("/fclib_global/vectors/mu"));
}

std::optional<CoulombProblem> read_text(const std::string& path) {
  FrictionContactProblem* const read = frictionContact_new_from_filename(path.c_str());
  if (!read) return std::nullopt;
  std::optional<CoulombProblem> result;
  if (read->dimension == 3) {
    const Index size = 3 * read->numberOfContacts;
    MatX W(size, size);
    for (Index i = 0; i < size; ++i)
      for (Index k = 0; k < size; ++k)
        W(i, k) = NM_get_value(read->M, static_cast<int>(i), static_cast<int>(k));
    result = problem_of(W, Eigen::Map<const VecX>(read->q, size),
                        Eigen::Map<const VecX>(read->mu, read->numberOfContacts));
  }
  frictionContactProblem_free(read);
  return result;
}

/// W in blocks of 3 × 3, as Siconos' own programs hand it over.
NumericsMatrix* blocks_of(const CoulombProblem& problem) {
  const Index size = problem.b.size();
  NumericsMatrix* const entries = NM_create(NM_SPARSE, static_cast<int>(size), static_cast<int>(size));
  NM_triplet_alloc(entries, static_cast<CS_INT>(size));
  for (Index i = 0; i < size; ++i)
    for (Index k = 0; k < size; ++k)
      if (const double value = problem.A(rigor_row(i), rigor_row(k)); value != 0)
        NM_entry(entries, static_cast<int>(i), static_cast<int>(k), value);
  NumericsMatrix* const result = NM_create(NM_SPARSE_BLOCK, static_cast<int>(size), static_cast<int>(size));
  SBM_from_csparse(3, NM_csc(entries), result->matrix1);
  NM_clear(entries);
  std::free(entries);
  return result;
}

/// A problem as Siconos has it.
class TheirProblem {
 public:
  explicit TheirProblem(const CoulombProblem& problem) : q_(problem.b.size()), mu_(problem.mu) {
    for (Index i = 0; i < q_.size(); ++i) q_(i) = problem.b(rigor_row(i));
    problem_ = frictionContactProblem_new_with_data(3, static_cast<int>(mu_.size()), blocks_of(problem),
                                                    q_.data(), mu_.data());
  }
  TheirProblem(const TheirProblem&) = delete;
  TheirProblem& operator=(const TheirProblem&) = delete;
  ~TheirProblem() {
    problem_->q = problem_->mu = nullptr;
    frictionContactProblem_free(problem_);
  }

  VecX solve(int solver, int most_iterations) {
    VecX reaction = VecX::Zero(q_.size()), velocity = VecX::Zero(q_.size()), lambda(q_.size());
    SolverOptions* const options = solver_options_create(solver);
    options->dparam[SICONOS_DPARAM_TOL] = 1e-9;
    options->iparam[SICONOS_IPARAM_MAX_ITER] = most_iterations;
    fc3d_driver(problem_, reaction.data(), velocity.data(), options);
    solver_options_delete(options);
    for (Index i = 0; i < q_.size(); ++i) lambda(rigor_row(i)) = reaction(i);
    return lambda;
  }

 private:
  VecX q_;
  std::vector<double> mu_;
  FrictionContactProblem* problem_;
};

}  // namespace

std::vector<NamedSolver> siconos_solvers() {
  const auto named = [](const char* name, int solver, int most_iterations) {
    return NamedSolver{name, [=](const CoulombProblem& problem) {
                         const auto theirs = std::make_shared<TheirProblem>(problem);
                         return [=] { return theirs->solve(solver, most_iterations); };
                       }};
  };
  return {named("NSN_AC", SICONOS_FRICTION_3D_NSN_AC, 1000), named("NSGS", SICONOS_FRICTION_3D_NSGS, 100000),
          named("ADMM", SICONOS_FRICTION_3D_ADMM, 100000)};
}

std::optional<NamedProblem> read_problem(const std::string& path) {
  const std::filesystem::path name(path);
  std::optional<CoulombProblem> laws = name.extension() == ".hdf5" ? read_fclib(path) : read_text(path);
  if (!laws) return std::nullopt;
  return NamedProblem{name.stem().string(), std::move(*laws)};
}

}  // namespace rigor::bench
