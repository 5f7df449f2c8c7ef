#include "apps/run_sparkline.hpp"

#include "apps/terminal.hpp"
#include "rigor/view/plot/sparkline.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

void RunSparkline::add(double energy, double penetration) {
  constexpr std::size_t most_spans = 1024;
  if (spans_.empty()) first_ = energy;
  last_ = energy;
  deepest_ = std::max(deepest_, penetration);
  if (spans_.empty() || in_last_ == per_span_) {
    if (spans_.size() == most_spans) merge_pairs();
    spans_.push_back({energy, penetration});
    in_last_ = 1;
    return;
  }
  Span& span = spans_.back();
  ++in_last_;
  span.energy += (energy - span.energy) / static_cast<double>(in_last_);
  span.penetration = std::max(span.penetration, penetration);
}

void RunSparkline::merge_pairs() {
  for (std::size_t i = 0; i + 1 < spans_.size(); i += 2) {
    const Span &a = spans_[i], &b = spans_[i + 1];
    spans_[i / 2] = {0.5 * (a.energy + b.energy), std::max(a.penetration, b.penetration)};
  }
  spans_.resize(spans_.size() / 2);
  per_span_ *= 2;
}

std::string RunSparkline::text(int width, bool is_ascii) const {
  constexpr int title = 16, numbers = 36, widest = 60;
  std::vector<double> energies, penetrations;
  for (const Span& span : spans_) energies.push_back(span.energy), penetrations.push_back(span.penetration);
  const int room = std::min(width - title - numbers, widest);
  const auto line = [&](const std::vector<double>& values) {
    return toned(sparkline(values, room, is_ascii), Tone::good, stderr);
  };
  return fmt::format("  energy        {}  {:.6g} J to {:.6g} J\n", line(energies), first_, last_) +
         fmt::format("  penetration   {}  {:.3g} m at most\n", line(penetrations), deepest_);
}

}  // namespace rigor
