#include "apps/singular_warning.hpp"

#include "rigor/sim/islands/singular_start.hpp"

#include <fmt/format.h>

#include <optional>

namespace rigor {

std::string singular_warning(const Scene& scene, const State& start) {
  const std::optional<int> joint = singular_joint(*scene.model, start);
  if (!joint) return {};
  return fmt::format(
      "joint '{}' closes a chain that cannot move as it begins to: it is stretched out or folded flat, so "
      "that its forces have no bound; the run may crawl or fail its audit. A chain a little slack has none "
      "of this",
      scene.model->joint(*joint).name);
}

}  // namespace rigor
