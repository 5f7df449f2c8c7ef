// Frictional contact problems (W, q, μ) from files, solved by solve_coulomb and by Siconos, each in a process
// of its own that may take so many seconds of processor time. Files: Siconos' text (.dat) and FCLIB's local
// problems (.hdf5). Without files: heaps of our own. usage: rigor_coulomb_bench [--limit seconds] [--only
// Rigor] [FILE...]
//
// The measure is the same for all: coulomb_residual, the natural map relative to the largest term.

#include "coulomb_peers.hpp"

#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/linear/contact_motion.hpp"
#include "solver/heap_problems.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

namespace rigor::bench {

namespace {

constexpr double kWanted = 1e-8;

/// What a solver did with a problem.
struct Outcome {
  double residual = std::numeric_limits<double>::infinity();
  double seconds = std::numeric_limits<double>::infinity();  ///< Of processor time.
};

double process_time() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::function<VecX()> by_rigor(const CoulombProblem& problem) {
  return [&] { return solve_coulomb(problem, {.tolerance = 1e-10, .least_norm = false}).lambda; };
}

/// The mean over as many solutions as fit into a twentieth of a second: small problems take microseconds.
Outcome timed(const CoulombProblem& problem, const CoulombSolver& solve) {
  constexpr double enough = 0.05;
  constexpr int most = 1000000;
  const std::function<VecX()> ready = solve(problem);
  VecX lambda;
  int count = 0;
  const double begin = process_time();
  double end = begin;
  while (count < most && end - begin < enough) {
    lambda = ready();
    ++count;
    end = process_time();
  }
  Outcome outcome;
  outcome.seconds = (end - begin) / count;
  if (lambda.size() == problem.b.size() && lambda.allFinite())
    outcome.residual = coulomb_residual(problem, lambda, problem.A * lambda + problem.b);
  return outcome;
}

/// In a child process, since a peer may end it or take for ever.
Outcome apart(const CoulombProblem& problem, const CoulombSolver& solve, unsigned limit) {
  int ends[2];
  if (::pipe(ends) != 0) return {};
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) return {};
  if (child == 0) {
    const rlimit most{limit, limit};
    ::setrlimit(RLIMIT_CPU, &most);
    if (!std::freopen("/dev/null", "w", stdout) || !std::freopen("/dev/null", "w", stderr)) ::_exit(1);
    const Outcome outcome = timed(problem, solve);
    const bool is_written = ::write(ends[1], &outcome, sizeof outcome) == sizeof outcome;
    ::_exit(is_written ? 0 : 1);
  }
  ::close(ends[1]);
  Outcome outcome;
  if (::read(ends[0], &outcome, sizeof outcome) != sizeof outcome) outcome = {};
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return outcome;
}

std::string text_of(const Outcome& outcome) {
  if (!std::isfinite(outcome.seconds)) return fmt::format("{:>10} {:>8}", "-", "-");
  return fmt::format("{:10.3g} {:8.0e}", 1e3 * outcome.seconds, outcome.residual);
}

/// A = J M⁻¹ Jᵀ column by column.
CoulombProblem with_matrix(const MotionProblem& problem) {
  CoulombProblem laws = problem.laws;
  const Eigen::Index size = laws.b.size();
  laws.A.resize(size, size);
  const SparseMotion motion(problem.rows);
  for (Eigen::Index k = 0; k < size; ++k)
    laws.A.col(k) = motion.rates(motion.apply_inverse_mass(motion.apply_transpose(VecX::Unit(size, k))));
  return laws;
}

/// Heaps of the tests (tests/solver/heap_problems.hpp), of which the matrix can be written out.
std::vector<NamedProblem> own_problems() {
  constexpr std::size_t most_contacts = 500;
  std::vector<NamedProblem> result;
  for (const heaps::Heap& heap : heaps::all_heaps()) {
    const MotionProblem problem = heaps::problem_of(heap);
    if (problem.laws.mu.size() <= most_contacts)
      result.push_back({heaps::name_of(heap), with_matrix(problem)});
  }
  return result;
}

}  // namespace

}  // namespace rigor::bench

int main(int argc, char** argv) {
  using namespace rigor::bench;
  CLI::App app(
      "Coulomb's law of given matrices: processor time and residual, beside Siconos where it is installed");
  std::vector<std::string> files;
  unsigned limit = 60;
  std::string only;
  app.add_option("files", files, "Problems: .dat of Siconos, .hdf5 of FCLIB (without: heaps of our own)");
  app.add_option("--limit", limit, "Seconds that a solver may take")->capture_default_str();
  std::vector<NamedSolver> solvers{{"Rigor", by_rigor}};
#ifdef RIGOR_BENCH_SICONOS
  for (NamedSolver& peer : siconos_solvers()) solvers.push_back(std::move(peer));
#endif
  std::vector<std::string> names;
  for (const NamedSolver& each : solvers) names.push_back(each.name);
  app.add_option("--only", only, "This solver alone")->check(CLI::IsMember(names));
  CLI11_PARSE(app, argc, argv);

  if (!only.empty()) std::erase_if(solvers, [&](const NamedSolver& each) { return each.name != only; });

  std::vector<NamedProblem> problems = files.empty() ? own_problems() : std::vector<NamedProblem>();
  for (const std::string& file : files) {
    std::optional<NamedProblem> read = std::nullopt;
#ifdef RIGOR_BENCH_SICONOS
    try {
      read = read_problem(file);
    } catch (const std::runtime_error& error) {
      fmt::print(stderr, "{}: {}\n", file, error.what());
      continue;
    }
#endif
    if (read)
      problems.push_back(std::move(*read));
    else
      fmt::print(stderr,
                 "{}: no problem of contacts in space, or Siconos is not installed, whose reader it is\n",
                 file);
  }

  fmt::print("Processor time [ms] and residual (solved: below {:.0e}, within {} s)\n", kWanted, limit);
  fmt::print("{:>34} {:>8}", "problem", "contacts");
  for (const NamedSolver& solver : solvers) fmt::print(" {:>19}", solver.name);
  fmt::print("{}\n", solvers.size() > 1 ? "  best peer / Rigor" : "");
  std::vector<int> solved(solvers.size(), 0);
  int first = 0;
  for (const NamedProblem& problem : problems) {
    fmt::print("{:>34} {:>8}", problem.name, problem.laws.mu.size());
    std::vector<double> times;
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      const Outcome outcome = apart(problem.laws, solvers[i].solve, limit);
      const bool is_solved = outcome.residual <= kWanted;
      solved[i] += is_solved;
      times.push_back(is_solved ? outcome.seconds : std::numeric_limits<double>::infinity());
      fmt::print(" {}{}", text_of(outcome), is_solved ? "" : "!");
    }
    if (times.size() > 1) {
      const double peer = *std::min_element(std::next(times.begin()), times.end());
      first += std::isfinite(times[0]) && times[0] <= peer;
      if (std::isfinite(times[0])) fmt::print("  {:.3g}", peer / times[0]);
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  fmt::print("{:>34} {:>8}", "solved", problems.size());
  for (const int count : solved) fmt::print(" {:>19}", count);
  if (solvers.size() > 1) fmt::print("  Rigor first on {}", first);
  fmt::print("\n");
}
