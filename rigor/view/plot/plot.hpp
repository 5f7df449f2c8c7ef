#pragma once

#include "rigor/view/plot/drawing.hpp"
#include "rigor/view/plot/plot_series.hpp"

#include <span>

namespace rigor {

/// Plot of quantities over time: one panel for each of them (all energies in one), one below the other with a
/// common time axis, axes with units, a legend above each panel. A value that is not finite breaks the line
/// there. Lines with output times of their own are of several runs, which may lie on each other: each is
/// wider than the next, so that all are seen.
Drawing make_plot(std::span<const double> time, std::span<const PlotSeries> series);

/// Runs of finite values of a line, as points (time, value). A run of one value is a run of two equal points,
/// so that it shows as a dot. Of runs with many points, only the lowest and the highest value of each
/// of `columns` equal spans of time are kept: what the eye sees stays.
std::vector<Polyline> line_pieces(std::span<const double> time, std::span<const double> values,
                                  std::size_t columns);

}  // namespace rigor
