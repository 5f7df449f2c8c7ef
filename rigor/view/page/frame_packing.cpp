#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/view/page/page_frames.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace rigor {

namespace {

/// Whole numbers of bodies and frames: those of one component of a body lie side by side.
template <typename Number>
class FrameColumns {
 public:
  FrameColumns(std::size_t bodies, std::size_t components, std::size_t frames)
      : components_(components), frames_(frames), values_(bodies * components * frames) {}
  std::span<Number> of(std::size_t body, std::size_t component) {
    return std::span<Number>(values_).subspan((components_ * body + component) * frames_, frames_);
  }
  std::span<const Number> of(std::size_t body, std::size_t component) const {
    return std::span<const Number>(values_).subspan((components_ * body + component) * frames_, frames_);
  }
  const std::vector<Number>& all() const { return values_; }
  std::size_t bodies() const { return frames_ == 0 ? 0 : values_.size() / (components_ * frames_); }
  std::size_t frames() const { return frames_; }

 private:
  std::size_t components_, frames_;
  std::vector<Number> values_;
};
using Reals = FrameColumns<double>;
using Wholes = FrameColumns<std::int64_t>;

/// Velocities are quantised to a part of the largest one of the chunk, angular and linear ones separately.
double velocity_step(const Reals& velocities, int parts) {
  double largest = 0;
  for (const double value : velocities.all()) largest = std::max(largest, std::abs(value));
  const bool is_usable = std::isfinite(largest) && largest / parts > std::numeric_limits<double>::min();
  return is_usable ? power_of_two_below(2 * largest / parts) : 1;
}

Wholes in_steps(const Reals& values, double step, std::size_t bodies) {
  Wholes result(bodies, 3, values.frames());
  for (std::size_t i = 0; i < bodies; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::span<const double> from = values.of(i, c);
      std::transform(from.begin(), from.end(), result.of(i, c).begin(),
                     [step](double value) { return quantised(value, step); });
    }
  }
  return result;
}

/// The order whose residuals are the smallest, judged by some of the bodies.
ColumnOrder best_order(const Wholes& columns) {
  constexpr std::size_t judged = 64;
  const std::size_t stride = std::max<std::size_t>(1, columns.bodies() / judged);
  ColumnOrder best = ColumnOrder::linear;
  double least = std::numeric_limits<double>::infinity();
  for (const ColumnOrder order : {ColumnOrder::constant, ColumnOrder::linear, ColumnOrder::quadratic}) {
    double bits = 0;
    for (std::size_t i = 0; i < columns.bodies(); i += stride) {
      for (std::size_t c = 0; c < 3; ++c) {
        for_residuals(columns.of(i, c), order, [&](std::int64_t residual) {
          bits += static_cast<double>(std::bit_width(static_cast<std::uint64_t>(std::abs(residual))));
        });
      }
    }
    if (bits < least) least = bits, best = order;
  }
  return best;
}

/// Steps of positions, times 2¹⁶, for each step of the sum of two velocities; 0 where it would leave the
/// whole numbers that JavaScript has.
std::int64_t travel_of(double interval, double speed_step, double position_step) {
  constexpr double most = 68719476736.0;  // 2³⁶
  const double travel = 65536 * 0.5 * interval * speed_step / position_step;
  return travel < most ? std::llround(travel) : 0;
}

void append_positions(const Wholes& positions, const Wholes& velocities, std::int64_t travel,
                      std::string& bytes) {
  for (std::size_t i = 0; i < positions.bodies(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::span<const std::int64_t> x = positions.of(i, c), v = velocities.of(i, c);
      append_varint(x[0], bytes);
      for (std::size_t k = 1; k < x.size(); ++k)
        append_varint(x[k] - x[k - 1] - ((travel * (v[k] + v[k - 1]) + (1 << 15)) >> 16), bytes);
    }
  }
}

/// The quaternion w x y z of its stored numbers.
std::array<double, 4> unpacked(const PackedQuaternion& q, int parts) {
  const double step = std::numbers::sqrt2 / 2 / parts;
  std::array<double, 4> all{};
  double rest = 1;
  std::size_t place = 0;
  for (int i = 0; i < 4; ++i) {
    if (i == q.largest) continue;
    const double value = static_cast<double>(q.others[place++]) * step;
    all[at(i)] = value;
    rest -= value * value;
  }
  all[at(q.largest)] = std::sqrt(std::max(0.0, rest));
  return all;
}

/// What is expected of the three others of a quaternion whose largest component is this one.
std::array<std::int64_t, 3> expected_others(const std::array<double, 4>& q, int largest, int parts) {
  const double sign = q[at(largest)] < 0 ? -1 : 1, scale = parts * std::numbers::sqrt2;
  std::array<std::int64_t, 3> others{};
  std::size_t place = 0;
  for (int i = 0; i < 4; ++i) {
    if (i != largest) others[place++] = static_cast<std::int64_t>(std::floor(sign * q[at(i)] * scale + 0.5));
  }
  return others;
}

void append_orientation(std::span<const PackedQuaternion> column,
                        const std::array<std::span<const std::int64_t>, 3>& w, double turn, int parts,
                        std::string& bytes) {
  std::int64_t last = 0;
  for (const PackedQuaternion& q : column) {
    append_varint(q.largest - last, bytes);
    last = q.largest;
  }
  std::array<std::string, 3> others;
  for (std::size_t k = 0; k < column.size(); ++k) {
    std::array<std::int64_t, 3> guess{};
    if (k > 0) {
      std::array<double, 3> a{};
      for (std::size_t c = 0; c < 3; ++c) a[c] = static_cast<double>(w[c][k] + w[c][k - 1]) * turn;
      guess =
          expected_others(predicted_orientation(unpacked(column[k - 1], parts), a), column[k].largest, parts);
    }
    for (std::size_t c = 0; c < 3; ++c) append_varint(column[k].others[c] - guess[c], others[c]);
  }
  for (const std::string& own : others) bytes += own;
}

/// The phases of a chunk by component.
struct ChunkMotion {
  Wholes positions;
  Reals velocities, spins;
  std::vector<PackedQuaternion> orientations;  ///< Frames of the first body, of the second, ...
};

ChunkMotion motion_of(const FrameChunk& chunk) {
  const std::size_t bodies = chunk.moving.size(), frames = chunk.states.size();
  ChunkMotion motion{Wholes(bodies, 3, frames), Reals(bodies, 3, frames), Reals(bodies, 3, frames),
                     std::vector<PackedQuaternion>(bodies * frames)};
  for (std::size_t k = 0; k < frames; ++k) {
    const State& state = *chunk.states[k];
    for (std::size_t i = 0; i < bodies; ++i) {
      const int body = chunk.moving[i];
      const Vec3 x = state.position(body) - chunk.scale.origin, v = linear_velocity(chunk.model, state, body),
                 w = angular_velocity(chunk.model, state, body);
      for (int c = 0; c < 3; ++c) {
        motion.positions.of(i, at(c))[k] = quantised(x[c], chunk.scale.position_step);
        motion.velocities.of(i, at(c))[k] = v[c];
        motion.spins.of(i, at(c))[k] = w[c];
      }
      motion.orientations[i * frames + k] = packed(state.orientation(body), chunk.scale.orientation_parts);
    }
  }
  return motion;
}

}  // namespace

std::array<double, 4> predicted_orientation(const std::array<double, 4>& q, const std::array<double, 3>& a) {
  const double n = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  if (!(n < 4)) return q;
  // Cosine of |a|, and sine over |a|.
  const double w = 1 - n / 2 * (1 - n / 12 * (1 - n / 30)), s = 1 - n / 6 * (1 - n / 20 * (1 - n / 42));
  const double x = s * a[0], y = s * a[1], z = s * a[2];
  return {w * q[0] - x * q[1] - y * q[2] - z * q[3], w * q[1] + x * q[0] + y * q[3] - z * q[2],
          w * q[2] - x * q[3] + y * q[0] + z * q[1], w * q[3] + x * q[2] - y * q[1] + z * q[0]};
}

PageBlock packed_frames(const FrameChunk& chunk) {
  const std::size_t bodies = chunk.moving.size(), frames = chunk.states.size();
  const PageScale& scale = chunk.scale;
  const ChunkMotion motion = motion_of(chunk);
  const double interval =
      frames > 1 ? (chunk.states.back()->t - chunk.states.front()->t) / static_cast<double>(frames - 1) : 0;

  // The velocities in steps that follow from the largest of them, and what they do to poses.
  const double speed_step = velocity_step(motion.velocities, scale.velocity_parts),
               spin_step = velocity_step(motion.spins, scale.velocity_parts);
  const Wholes V = in_steps(motion.velocities, speed_step, bodies),
               W = in_steps(motion.spins, spin_step, bodies);
  const std::int64_t travel = travel_of(interval, speed_step, scale.position_step);
  const double turn = 0.25 * interval * spin_step;
  const ColumnOrder order_V = best_order(V), order_W = best_order(W);

  // The header of the chunk.
  std::string bytes;
  for (const double number : {speed_step, spin_step, static_cast<double>(travel), turn})
    append_f64(number, bytes);
  for (const std::size_t number :
       {at(static_cast<int>(order_V)), at(static_cast<int>(order_W)), frames, bodies})
    append_u32(static_cast<std::uint32_t>(number), bytes);
  // The columns, kind by kind.
  for (const auto& [columns, order] : {std::pair(&V, order_V), std::pair(&W, order_W)}) {
    for (std::size_t i = 0; i < bodies; ++i)
      for (std::size_t c = 0; c < 3; ++c) append_column(columns->of(i, c), bytes, order);
  }
  append_positions(motion.positions, V, travel, bytes);
  for (std::size_t i = 0; i < bodies; ++i) {
    append_orientation(std::span(motion.orientations).subspan(i * frames, frames),
                       {W.of(i, 0), W.of(i, 1), W.of(i, 2)}, turn, scale.orientation_parts, bytes);
  }
  return make_page_block("frames", bytes);
}

}  // namespace rigor
