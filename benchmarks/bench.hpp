#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rigor::bench {

/// One row of the table: an engine on a case.
struct Row {
  std::string test;      ///< Name of the case; rows of one case stand together.
  std::string engine;    ///< With its step or variant.
  std::string quantity;  ///< What the error is of, with its unit.
  double error;          ///< NaN where the engine cannot do the case.
  double cpu_seconds;    ///< Process CPU time of the simulation alone.
};

/// CPU time of the process that the call uses [s].
double cpu_seconds(const std::function<void()>& call);

std::vector<Row> rigor_rows();
#ifdef RIGOR_BENCH_ODE
std::vector<Row> ode_rows();
#endif
#ifdef RIGOR_BENCH_BULLET
std::vector<Row> bullet_rows();
#endif
#ifdef RIGOR_BENCH_MUJOCO
std::vector<Row> mujoco_rows();
#endif

// The scenes in numbers, shared by all engines (g = 9.81 m/s², SI units).
inline constexpr double g = 9.81;
/// Height of the lowest point of a ball dropped from h that bounces without loss, at time t.
double bouncing_height(double h, double t);
/// Distance that a block slides in 10 s on 20 degrees with 0.99 of the friction that would hold it.
double ramp_distance();

}  // namespace rigor::bench
