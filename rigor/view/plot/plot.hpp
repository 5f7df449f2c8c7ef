#pragma once

#include "rigor/view/plot/drawing.hpp"
#include "rigor/view/plot/plot_series.hpp"

#include <span>

namespace rigor {

/// Plot of quantities over time: one panel for each of them (all energies share one), one below the other
/// with a common time axis, axes with units and a legend above each panel. A value that is not finite
/// interrupts the line. Lines with output times of their own belong to several runs, which may coincide: each
/// is wider than the next, so that all remain visible.
Drawing make_plot(std::span<const double> time, std::span<const PlotSeries> series);

/// Segments of finite values of a line, as points (time, value). A segment of one value becomes two equal
/// points, so that it shows as a dot. Where there are many points, only the lowest and the highest value of
/// each of `columns` equal spans of time are kept, which looks the same.
std::vector<Polyline> line_pieces(std::span<const double> time, std::span<const double> values,
                                  std::size_t columns);

}  // namespace rigor
