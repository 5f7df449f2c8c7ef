// Convex pairs: errors and times of signed_distance in four regimes, beside FCL, libccd and Bullet where
// installed.
//
//   rigor_convex_bench [--quick] [--rigor] [--coaxial]
//
// --quick takes every tenth query and three passes; --rigor leaves the peers out; --coaxial prints the last
// table alone.

#include "convex_bench.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>

namespace rigor::bench {
namespace {

constexpr double kWrong = 1e-5;
constexpr double kVeryWrong = 1e-3;

struct Plan {
  int passes = 7;
  std::size_t stride = 1;
  bool has_peers = true;
};

/// What one engine did with the queries of a regime, query by query.
struct Column {
  std::vector<std::optional<EngineAnswer>> answers;
  std::vector<std::optional<EngineAnswer>> reversed;
  std::vector<double> nanoseconds;
};

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

/// The second smallest time of the passes of one call [ns], without the clock's own.
double time_of(const ConvexEngine& engine, const ConvexQuery& query, int passes) {
  using Clock = std::chrono::steady_clock;
  static const double overhead = [] {
    std::vector<double> times;
    for (int i = 0; i < 1000; ++i) {
      const Clock::time_point begin = Clock::now();
      times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
    }
    return percentile(times, 0.1);
  }();
  std::vector<double> times;
  for (int i = 0; i < passes; ++i) {
    const Clock::time_point begin = Clock::now();
    static_cast<void>(engine.solve(query));
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count() - overhead);
  }
  std::sort(times.begin(), times.end());
  return times[1];
}

Column run(const ConvexEngine& engine, const std::vector<ConvexQuery>& queries, int passes) {
  Column column;
  for (const ConvexQuery& query : queries) {
    column.answers.push_back(engine.solve(query));
    column.reversed.push_back(engine.solve({query.b, query.a, query.X_WB, query.X_WA}));
    column.nanoseconds.push_back(time_of(engine, query, passes));
  }
  return column;
}

struct Truth {
  ReferenceDistance distance;
  bool is_polytope_pair;
};

bool is_polytope_kind(int kind) {
  return kind == 1 || kind >= 6;
}

std::vector<Truth> truths(const std::vector<Shape>& shapes, const std::vector<ConvexQuery>& queries,
                          const std::vector<Column>& columns) {
  std::vector<Truth> result;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const ConvexQuery& q = queries[i];
    std::vector<Vec3> normals;
    for (const Column& column : columns) {
      if (column.answers[i] && column.answers[i]->n_W && column.answers[i]->n_W->allFinite())
        normals.push_back(*column.answers[i]->n_W);
    }
    result.push_back({reference_distance(shapes[static_cast<std::size_t>(q.a)], q.X_WA,
                                         shapes[static_cast<std::size_t>(q.b)], q.X_WB, normals),
                      is_polytope_kind(q.kind_a()) && is_polytope_kind(q.kind_b())});
  }
  return result;
}

/// Distance from the interval that holds the truth.
double error_of(double value, const ReferenceDistance& truth) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  const long double d = value;
  return static_cast<double>(std::max({truth.lower - d, d - truth.upper, 0.0L}));
}

struct Summary {
  double error_polytopes = 0;
  double error_curved = 0;
  double asymmetry = 0;
  double normal_excess = 0;
  int wrong = 0;
  int very_wrong = 0;
  int without_answer = 0;

  void add(const Truth& truth, const std::optional<EngineAnswer>& answer,
           const std::optional<EngineAnswer>& reversed) {
    if (!answer) {
      ++without_answer;
      return;
    }
    const double error = error_of(answer->distance, truth.distance);
    double& largest = truth.is_polytope_pair ? error_polytopes : error_curved;
    largest = std::max(largest, error);
    wrong += error > kWrong;
    very_wrong += error > kVeryWrong;
    if (reversed) asymmetry = std::max(asymmetry, std::abs(answer->distance - reversed->distance));
  }
};

std::string brief(double value) {
  return value == 0 ? "0" : fmt::format("{:.1e}", value);
}

void print_accuracy(const std::vector<Shape>& shapes, const std::vector<ConvexQuery>& queries,
                    const std::vector<Truth>& truth, const std::vector<ConvexEngine>& engines,
                    const std::vector<Column>& columns) {
  fmt::print("{:<16}{:>11}{:>11}{:>8}{:>8}{:>8}{:>11}{:>11}{:>10}{:>10}\n", "engine", "err flat",
             "err curved", ">1e-5", ">1e-3", "none", "normal", "|ab - ba|", "median", "p99 [ns]");
  for (std::size_t e = 0; e < engines.size(); ++e) {
    Summary summary;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const std::optional<EngineAnswer>& answer = columns[e].answers[i];
      summary.add(truth[i], answer, columns[e].reversed[i]);
      if (!answer || !answer->n_W || !answer->n_W->allFinite()) continue;
      const ConvexQuery& q = queries[i];
      const long double along = reference_separation(*answer->n_W, shapes[static_cast<std::size_t>(q.a)],
                                                     q.X_WA, shapes[static_cast<std::size_t>(q.b)], q.X_WB);
      summary.normal_excess =
          std::max(summary.normal_excess, static_cast<double>(truth[i].distance.lower - along));
    }
    fmt::print("{:<16}{:>11}{:>11}{:>8}{:>8}{:>8}{:>11}{:>11}{:>10.0f}{:>10.0f}\n", engines[e].name,
               brief(summary.error_polytopes), brief(summary.error_curved), summary.wrong, summary.very_wrong,
               summary.without_answer, brief(summary.normal_excess), brief(summary.asymmetry),
               percentile(columns[e].nanoseconds, 0.5), percentile(columns[e].nanoseconds, 0.99));
  }
}

void print_truth(const std::vector<Truth>& truth) {
  long double gap = 0;
  for (const Truth& t : truth) gap = std::max(gap, t.distance.upper - t.distance.lower);
  fmt::print("largest gap of the certified reference: {}\n", brief(static_cast<double>(gap)));
}

/// How wide the bounds are that the first engine returns, and how many do not hold the truth.
void print_bounds(const std::vector<Truth>& truth, const Column& column) {
  std::vector<double> widths;
  int broken = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const EngineAnswer::Bounds bounds = column.answers[i].value().bounds.value();
    widths.push_back(bounds.upper - bounds.lower);
    broken += bounds.lower > truth[i].distance.upper || bounds.upper < truth[i].distance.lower;
  }
  fmt::print("rigor's bounds: {} of {} do not hold the truth; width median {}, p99 {}, largest {}\n", broken,
             widths.size(), brief(percentile(widths, 0.5)), brief(percentile(widths, 0.99)),
             brief(percentile(widths, 1)));
}

/// Median times of the pairs of kinds, one table an engine, a row a pair.
void print_pairs(const std::vector<std::vector<ConvexQuery>>& queries,
                 const std::vector<std::vector<Column>>& columns, const std::vector<ConvexEngine>& engines) {
  fmt::print("\nmedian ns by pair of kinds: separated/touching/shallow/deep\n{:<22}", "pair");
  for (const ConvexEngine& engine : engines) fmt::print("{:>28}", engine.name);
  fmt::print("\n");
  for (int a = 0; a < kKinds; ++a) {
    for (int b = a; b < kKinds; ++b) {
      fmt::print("{:<22}", fmt::format("{}-{}", kKindNames[static_cast<std::size_t>(a)],
                                       kKindNames[static_cast<std::size_t>(b)]));
      for (std::size_t e = 0; e < engines.size(); ++e) {
        std::string cell;
        for (std::size_t r = 0; r < queries.size(); ++r) {
          std::vector<double> times;
          for (std::size_t i = 0; i < queries[r].size(); ++i) {
            const ConvexQuery& q = queries[r][i];
            if (q.kind_a() == a && q.kind_b() == b) times.push_back(columns[r][e].nanoseconds[i]);
          }
          cell += fmt::format("{}{:.0f}", r ? "/" : "", percentile(times, 0.5));
        }
        fmt::print("{:>28}", cell);
      }
      fmt::print("\n");
    }
  }
}

std::vector<ConvexEngine> engines_for(const std::vector<Shape>& shapes, bool has_peers) {
  std::vector<ConvexEngine> engines{rigor_engine(shapes)};
  if (!has_peers) return engines;
#ifdef RIGOR_BENCH_FCL
  engines.push_back(fcl_engine(shapes));
#endif
#ifdef RIGOR_BENCH_CCD
  engines.push_back(ccd_mpr_engine(shapes));
  engines.push_back(ccd_epa_engine(shapes));
#endif
#ifdef RIGOR_BENCH_BULLET
  engines.push_back(bullet_kernel_engine(shapes));
#endif
  return engines;
}

void run_bench(const Plan& plan) {
  const std::vector<Shape> shapes = bench_shapes();
  const std::vector<ConvexEngine> engines = engines_for(shapes, plan.has_peers);
  std::vector<std::vector<ConvexQuery>> queries;
  std::vector<std::vector<Column>> columns;
  for (std::size_t r = 0; r < kRegimeNames.size(); ++r) {
    const std::vector<ConvexQuery> all = bench_queries(shapes, static_cast<Regime>(r));
    std::vector<ConvexQuery>& some = queries.emplace_back();
    for (std::size_t i = 0; i < all.size(); i += plan.stride) some.push_back(all[i]);
    std::vector<Column>& by_engine = columns.emplace_back();
    for (const ConvexEngine& engine : engines) by_engine.push_back(run(engine, some, plan.passes));
    const std::vector<Truth> truth = truths(shapes, some, by_engine);
    fmt::print("\n{}: {} queries\n", kRegimeNames[r], some.size());
    print_accuracy(shapes, some, truth, engines, by_engine);
    print_truth(truth);
    print_bounds(truth, by_engine[0]);
    std::fflush(stdout);
  }
  print_pairs(queries, columns, engines);
  print_coaxial();
}

}  // namespace

ConvexEngine rigor_engine(const std::vector<Shape>& shapes) {
  return {"rigor", true, [shapes](const ConvexQuery& q) -> std::optional<EngineAnswer> {
            const DistanceResult r = signed_distance(shapes[static_cast<std::size_t>(q.a)], q.X_WA,
                                                     shapes[static_cast<std::size_t>(q.b)], q.X_WB);
            return EngineAnswer{r.distance, r.n_W, EngineAnswer::Bounds{r.lower, r.upper}};
          }};
}

}  // namespace rigor::bench

int main(int argc, char** argv) {
  rigor::bench::Plan plan;
  for (int i = 1; i < argc; ++i) {
    const std::string_view option = argv[i];
    if (option == "--quick") {
      plan.stride = 10;
      plan.passes = 3;
    } else if (option == "--rigor") {
      plan.has_peers = false;
    } else if (option == "--coaxial") {
      rigor::bench::print_coaxial();
      return 0;
    } else {
      fmt::print(stderr, "usage: rigor_convex_bench [--quick] [--rigor] [--coaxial]\n");
      return 2;
    }
  }
  rigor::bench::run_bench(plan);
  return 0;
}
