#include "rigor/bulk/state/flight_velocities.hpp"

#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cstddef>

namespace rigor {

namespace {

/// Part of an acceleration that rounding may take: steps themselves err by more, and most bodies are slower.
constexpr double kLeastLoss = 3e-5;

/// a · b of the first three numbers.
float dot_of_rows(const float* a, const float* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

void FlightVelocities::begin(const std::vector<int>& moving, const std::vector<char>& touches,
                             const std::vector<MotionRow>& accelerations, double h, int substeps,
                             const BulkBodies& bodies) {
  flights_.clear();
  const float substep = static_cast<float>(h / substeps);
  const float slow = static_cast<float>(kLeastLoss * h / substeps * 0x1p24);
  for (const int body : moving) {
    const std::size_t k = at(body);
    const float *const a = accelerations[k].data(), *const u = bodies.motion[k].v;
    if (!(dot_of_rows(u, u) > slow * slow * dot_of_rows(a, a)) || dot_of_rows(a, a) == 0) continue;
    if (touches[k] != 0 || !bodies.is_dynamic(body)) continue;
    // What the substeps will do, rounding by rounding, and what they should.
    const FloatRow change = substep * load_row(accelerations[k].data());
    FloatRow rounded = load_row(bodies.motion[k].v) - 0.5F * change;
    const Vec3 v = vector_of(bodies.motion[k].v) + vector_of(bodies.finer_v[k].data());
    for (int i = 0; i < substeps; ++i) rounded += change;
    rounded += 0.5F * change;
    flights_.push_back(
        {body, {rounded[0], rounded[1], rounded[2]}, v + h * vector_of(accelerations[k].data())});
  }
}

void FlightVelocities::end(const Executor& executor, BulkBodies& bodies) {
  std::fill(bodies.finer_v.begin(), bodies.finer_v.end(), FinerVelocity{});
  executor.for_ranges(static_cast<int>(flights_.size()), 1024, [&](int begin, int end) {
    for (int place = begin; place < end; ++place) {
      Flight& flight = flights_[at(place)];
      float* const v = bodies.motion[at(flight.body)].v;
      FinerVelocity& finer = bodies.finer_v[at(flight.body)];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (v[axis] != flight.rounded[axis]) continue;
        split_velocity(flight.v[static_cast<Eigen::Index>(axis)], v[axis], finer[axis]);
        flight.rounded[axis] = v[axis];
      }
    }
  });
}

void FlightVelocities::drop_changed(BulkBodies& bodies) const {
  for (const Flight& flight : flights_) {
    const float* const v = bodies.motion[at(flight.body)].v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (v[axis] != flight.rounded[axis]) bodies.finer_v[at(flight.body)][axis] = 0;
    }
  }
}

}  // namespace rigor
