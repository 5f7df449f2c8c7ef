#pragma once

namespace rigor {

/// What has been set apart (a body that was put elsewhere while its joints stayed, a limit that was set
/// anew) comes back no faster than this [m/s] or [rad/s], as overlaps are put back. In one substep metres
/// would be hundreds of metres a second, and on their arms rotations of radians, of which corrections of
/// first order know nothing.
constexpr double kApproachSpeed = 3;

}  // namespace rigor
