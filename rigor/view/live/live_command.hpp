#pragma once

#include "rigor/view/live/live_run.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace rigor {

/// The requests of a live page; docs/live.md gives their form.
namespace live {
struct Run {};
struct Pause {};
/// Advances to the next output time, then pauses.
struct Step {};
/// Returns to the output time before this one, then pauses.
struct Back {};
/// Returns to t = 0.
struct Reset {};
/// Reads the file again and starts from t = 0.
struct Reload {};
/// Whether the file is read again automatically when it changes.
struct Follow {
  bool value;
};
/// Simulated seconds per real second.
struct Speed {
  double value;
};
struct Gravity {
  Vec3 value;  ///< [m/s²].
};
struct Surface {
  std::string material;
  std::optional<double> friction, restitution;
};
struct TargetStep {
  double value;  ///< [s].
};
struct MethodValue {
  std::string key, value;
};
struct Pull {
  LivePull pull;
};
struct Release {};
struct Push {
  int body;
  Vec3 p_BP;  ///< [m] in B.
  Vec3 j_W;   ///< [N s].
};
/// Drives a coordinate of a joint at a velocity [rad/s] or [m/s]; nothing ends that.
struct Motor {
  int joint, coordinate;
  std::optional<double> velocity;
};
/// Where the spring of a coordinate of a joint rests [rad] or [m].
struct Rest {
  int joint, coordinate;
  double value;
};
/// Asks for a checkpoint to keep.
struct Save {};
/// Asks for the recording as a page to keep.
struct Export {};
}  // namespace live

using LiveCommand =
    std::variant<live::Run, live::Pause, live::Step, live::Back, live::Reset, live::Reload, live::Follow,
                 live::Speed, live::Gravity, live::Surface, live::TargetStep, live::MethodValue, live::Pull,
                 live::Release, live::Push, live::Motor, live::Rest, live::Save, live::Export>;

/// Reads a command: a JSON object with "do" and the values that it needs, and nothing else. Throws
/// InputError.
LiveCommand parse_live_command(std::string_view text);

}  // namespace rigor
