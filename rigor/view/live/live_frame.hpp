#pragma once

#include "rigor/sim/audit/contact_snapshot.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A moment of a live run.
struct LiveFrame {
  std::uint32_t generation;  ///< The scene that it belongs to.
  Vec3 origin;               ///< Positions are sent relative to this point [m].
  const Model& model;
  const State& state;
  std::vector<double> series;  ///< Values at the last output time.
  const std::vector<TouchingPoint>& contacts;
};

/// The message of a frame: all numbers are little-endian, in the order of docs/live.md.
std::string live_frame_bytes(const LiveFrame& frame);

/// The message of a file that the browser is to keep under this name.
std::string live_file_bytes(std::string_view name, std::string_view bytes);

}  // namespace rigor
