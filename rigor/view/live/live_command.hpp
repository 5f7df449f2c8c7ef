#pragma once

#include "rigor/view/live/live_run.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace rigor {

/// What a live page can ask for; docs/live.md gives the form in which it asks.
namespace live {
struct Run {};
struct Pause {};
/// To the next output time, then pause.
struct Step {};
/// Back to t = 0.
struct Reset {};
/// The file again, from t = 0.
struct Reload {};
/// Whether the file is read again by itself when it changes.
struct Follow {
  bool value;
};
/// Simulated seconds a second.
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
/// A checkpoint to keep.
struct Save {};
/// The recording as a page to keep.
struct Export {};
}  // namespace live

using LiveCommand =
    std::variant<live::Run, live::Pause, live::Step, live::Reset, live::Reload, live::Follow, live::Speed,
                 live::Gravity, live::Surface, live::TargetStep, live::MethodValue, live::Pull, live::Release,
                 live::Push, live::Save, live::Export>;

/// Reads a command: a JSON object with "do" and what that needs, nothing else. Throws InputError.
LiveCommand parse_live_command(std::string_view text);

}  // namespace rigor
