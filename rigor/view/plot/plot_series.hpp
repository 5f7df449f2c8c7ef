#pragma once

#include "rigor/view/recording/recording.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A quantity over the output times of a recording.
struct PlotSeries {
  std::string key;                 ///< As requested: the name of the line in a legend.
  std::string quantity;            ///< "energy", "position", ...
  std::string unit;                ///< "J", "m", ...
  std::vector<double> values;      ///< One per output time; NaN if not known.
  std::vector<double> times = {};  ///< Its own output times [s]; empty if it shares those of the others.
};

/// The quantity of that key, or nothing if there is none:
///   energy.kinetic|potential|elastic|total [J], momentum, momentum.x|y|z [kg m/s] (of all dynamic bodies),
///   penetration [m], body.NAME.position|velocity|angular_velocity, each alone (its length) or .x|y|z, and
///   body.NAME.orientation.w|x|y|z, and of a joint NAME.coordinate, NAME.rate ([0], [1], ... behind them if
///   it has several), NAME.force, NAME.torque, each alone (its length) or .x|y|z, as far as the trajectory
///   holds them.
std::optional<PlotSeries> find_series(const Recording& recording, std::string_view key);

/// NAME of a key body.NAME.quantity whose quantity exists, or nothing.
std::optional<std::string> body_of_key(std::string_view key);

/// NAME of a key NAME.quantity whose quantity is one of joints, or nothing.
std::optional<std::string> joint_of_key(std::string_view key);

/// All keys, to suggest one: those of the whole scene, then those of the bodies, then those of the joints.
std::vector<std::string> plot_keys(const Recording& recording);

}  // namespace rigor
