#include "view/frame_reading.hpp"

#include "view/page_reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rigor::test {

namespace {

std::array<double, 4> components(const std::array<std::int64_t, 3>& others, std::int64_t largest,
                                 double step) {
  std::array<double, 4> all{};
  double rest = 1;
  for (std::size_t c = 0, place = 0; c < 4; ++c) {
    if (static_cast<std::int64_t>(c) == largest) continue;
    all[c] = static_cast<double>(others[place++]) * step;
    rest -= all[c] * all[c];
  }
  all[static_cast<std::size_t>(largest)] = std::sqrt(std::max(0.0, rest));
  return all;
}

/// The orientations of a body whose angular velocities are these columns.
std::vector<Quat> read_orientations(BytesReader& reader, const std::vector<std::vector<std::int64_t>>& w,
                                    double turn, int parts) {
  const std::size_t frames = w[0].size();
  const std::vector<std::int64_t> largest = reader.column(frames, 1);
  std::vector<std::array<std::int64_t, 3>> others(frames);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::array<std::int64_t, 3>& own : others) own[c] = reader.varint();
  std::vector<Quat> result;
  std::array<double, 4> last{};
  for (std::size_t k = 0; k < frames; ++k) {
    if (k > 0) {
      std::array<double, 3> a{};
      for (std::size_t c = 0; c < 3; ++c) a[c] = static_cast<double>(w[c][k] + w[c][k - 1]) * turn;
      const std::array<double, 4> q = predicted_orientation(last, a);
      const double sign = q[static_cast<std::size_t>(largest[k])] < 0 ? -1 : 1;
      for (std::size_t c = 0, place = 0; c < 4; ++c) {
        if (static_cast<std::int64_t>(c) != largest[k])
          others[k][place++] +=
              static_cast<std::int64_t>(std::floor(sign * q[c] * (parts * std::numbers::sqrt2) + 0.5));
      }
    }
    last = components(others[k], largest[k], std::numbers::sqrt2 / 2 / parts);
    result.emplace_back(last[0], last[1], last[2], last[3]);
  }
  return result;
}

void read_chunk(const PageBlock& chunk, const PageScale& scale, ReadFrames& read) {
  BytesReader reader(inflated(chunk));
  const double speed_step = reader.take<double>(), spin_step = reader.take<double>(),
               travel = reader.take<double>(), turn = reader.take<double>();
  read.speed_step = std::max(read.speed_step, speed_step);
  read.spin_step = std::max(read.spin_step, spin_step);
  const int orders[2] = {static_cast<int>(reader.take<std::uint32_t>()),
                         static_cast<int>(reader.take<std::uint32_t>())};
  const std::size_t frames = reader.take<std::uint32_t>(), bodies = reader.take<std::uint32_t>();
  std::vector<std::vector<std::vector<std::int64_t>>> velocities[2];
  for (int kind = 0; kind < 2; ++kind) {
    velocities[kind].resize(bodies);
    for (auto& own : velocities[kind])
      for (int c = 0; c < 3; ++c) own.push_back(reader.column(frames, orders[kind]));
  }
  const std::size_t first = read.x.size();
  for (std::size_t k = 0; k < frames; ++k) {
    read.x.emplace_back(bodies), read.v.emplace_back(bodies), read.w.emplace_back(bodies);
    read.q.emplace_back(bodies);
  }
  for (std::size_t i = 0; i < bodies; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int axis = static_cast<int>(c);
      const std::vector<std::int64_t>& v = velocities[0][i][c];
      std::int64_t x = 0;
      for (std::size_t k = 0; k < frames; ++k) {
        x += reader.varint();
        if (k > 0)
          x += static_cast<std::int64_t>(
              std::floor((travel * static_cast<double>(v[k] + v[k - 1]) + 32768) / 65536));
        read.x[first + k][i][axis] = static_cast<double>(x) * scale.position_step + scale.origin[axis];
        read.v[first + k][i][axis] = speed_step * static_cast<double>(v[k]);
        read.w[first + k][i][axis] = spin_step * static_cast<double>(velocities[1][i][c][k]);
      }
    }
  }
  for (std::size_t i = 0; i < bodies; ++i) {
    const std::vector<Quat> q = read_orientations(reader, velocities[1][i], turn, scale.orientation_parts);
    for (std::size_t k = 0; k < frames; ++k) read.q[first + k][i] = q[k];
  }
  EXPECT_TRUE(reader.is_at_end());
}

}  // namespace

ReadFrames read_frames(const std::vector<PageBlock>& chunks, const PageScale& scale) {
  ReadFrames read;
  for (const PageBlock& chunk : chunks) read_chunk(chunk, scale, read);
  return read;
}

}  // namespace rigor::test
