#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rigor {

/// Energy and penetration over a run, in a fixed amount of memory, for the plots in the terminal.
class RunSparkline {
 public:
  /// Adds the energy at an output time [J] and the deepest overlap since the last one [m].
  void add(double energy, double penetration);

  /// Two lines with a plot, with the first and last or the largest value; at most `width` characters per
  /// line.
  std::string text(int width, bool is_ascii) const;

 private:
  /// A span of output times.
  struct Span {
    double energy;       ///< Mean.
    double penetration;  ///< Largest.
  };
  void merge_pairs();

  std::vector<Span> spans_;
  std::size_t per_span_ = 1;     ///< Output times per span.
  std::size_t in_last_ = 0;      ///< Output times in the last span.
  double first_ = 0, last_ = 0;  ///< Energies.
  double deepest_ = 0;
};

}  // namespace rigor
