// One table of error and CPU time: Rigor's numbers and, where they are installed, the peers' on the same
// scenes.

#include "bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace rigor::bench {

double cpu_seconds(const std::function<void()>& call) {
  const std::clock_t begin = std::clock();
  call();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double bouncing_height(double h, double t) {
  const double period = 2 * std::sqrt(2 * h / g);
  const double since = std::remainder(t, period);
  return h - 0.5 * g * since * since;
}

double ramp_distance() {
  const double angle = 20 * M_PI / 180;
  return 0.5 * g * (std::sin(angle) - 0.99 * std::tan(angle) * std::cos(angle)) * 100;
}

}  // namespace rigor::bench

int main() {
  using rigor::bench::Row;
  std::vector<Row> rows = rigor::bench::rigor_rows();
  [[maybe_unused]] const auto add = [&rows](const std::vector<Row>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
#ifdef RIGOR_BENCH_ODE
  add(rigor::bench::ode_rows());
#endif
#ifdef RIGOR_BENCH_BULLET
  add(rigor::bench::bullet_rows());
#endif
#ifdef RIGOR_BENCH_MUJOCO
  add(rigor::bench::mujoco_rows());
#endif
  std::vector<std::string> order;
  for (const Row& row : rows) {
    if (std::find(order.begin(), order.end(), row.test) == order.end()) order.push_back(row.test);
  }
  fmt::print("{:<41} {:<25} {:>12}  {:<30} {:>10}\n", "case", "engine", "error", "of", "CPU s");
  for (const std::string& test : order) {
    for (const Row& row : rows) {
      if (row.test != test) continue;
      fmt::print("{:<41} {:<25} {:>12.3g}  {:<30} {:>10.4f}\n", row.test, row.engine, row.error, row.quantity,
                 row.cpu_seconds);
    }
  }
  return 0;
}
