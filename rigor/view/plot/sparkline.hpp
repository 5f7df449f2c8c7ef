#pragma once

#include <span>
#include <string>

namespace rigor {

/// A quantity over time as one line of `width` characters: each stands for the mean of its share of the
/// values, at one of eight heights from the lowest to the highest value (a constant is drawn in the middle).
/// A space marks a share without finite values. Blocks ▁▂▃▄▅▆▇█, or with is_ascii the characters _.,-~=*#.
std::string sparkline(std::span<const double> values, int width, bool is_ascii);

}  // namespace rigor
