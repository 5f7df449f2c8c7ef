#include "rigor/geometry/decomposition/convex_decomposition.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/decomposition/cut_choice.hpp"
#include "rigor/geometry/decomposition/hull_excess.hpp"
#include "rigor/geometry/decomposition/solid_parts.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace rigor {
namespace {

/// Number of parts allowed before joining, per piece allowed after it; half as many as the cells examined.
constexpr std::size_t kPartsAPiece = 4;
/// Accuracy of the excesses: for the choice of the next cut, and for the result.
constexpr MaximumGoal kQuick{.relative_gap = 0.25, .max_evaluations = 1000};
constexpr MaximumGoal kStated{.relative_gap = 0.05, .max_evaluations = 5000};
/// Excesses below this fraction of the size are not distinguished.
constexpr double kFinest = 1e-4;
/// Faces count as coplanar to the tolerance divided by this, because an acute edge multiplies the error.
constexpr double kFlatness = 32;

/// A cell that contains part of the solid, with the hull of that part.
struct OpenCell {
  SolidCell cell;
  std::vector<Vec3> points;
  ConvexHull hull;
  std::vector<CutPlane> conflicts;  ///< Face planes with points in front of them; none if the part is convex.
  MaximumBounds excess;
};

/// Decomposes one mesh; lengths below the flatness count as rounding.
class Cutter {
 public:
  Cutter(const Mesh& mesh, const WindingNumber& winding, const DecompositionOptions& options, double flatness)
      : mesh_(mesh),
        winding_(winding),
        options_(options),
        planes_(find_face_planes(*mesh.mesh, flatness)),
        most_pieces_(at(std::max(1, options.max_pieces))),
        most_excess_(flatness > 0 ? options.tolerance : std::numeric_limits<double>::infinity()) {}

  /// Resolves all notches; returns nothing if that takes too many pieces. The excesses are what rounding and
  /// flatness may add.
  std::optional<ConvexDecomposition> cut_exactly() const;
  /// Cuts the cell with the largest excess until all cells are within the tolerance.
  ConvexDecomposition cut_roughly() const;

 private:
  bool goes_on(std::size_t pieces, double excess) const {
    return !options_.goes_on || options_.goes_on(static_cast<int>(pieces), excess);
  }
  std::optional<OpenCell> opened(SolidCell cell) const;
  void add_cell(SolidCell cell, std::vector<OpenCell>& cells) const;
  MaximumBounds excess_of(const OpenCell& open, MaximumGoal goal) const;
  ConvexDecomposition result(std::vector<SolidPart> parts, double most_excess) const;

  const Mesh& mesh_;
  const WindingNumber& winding_;
  const DecompositionOptions& options_;
  FacePlanes planes_;
  std::size_t most_pieces_;
  double most_excess_;  ///< Largest excess of pieces joined after exact cuts [m].
};

/// The cell with its hull and its conflicts; nothing if it contains no solid, or no more than a film of
/// rounding.
std::optional<OpenCell> Cutter::opened(SolidCell cell) const {
  OpenCell open{std::move(cell), {}, {}, {}, {}};
  open.points = solid_points(open.cell, winding_, planes_.tolerance);
  std::variant<ConvexHull, std::string> hull = make_convex_hull(open.points);
  if (!std::holds_alternative<ConvexHull>(hull)) return std::nullopt;
  open.hull = std::get<ConvexHull>(std::move(hull));
  for (const int i : conflict_planes(open.cell, open.points, planes_)) {
    open.conflicts.push_back(planes_.planes[at(i)].plane);
  }
  return open;
}

std::optional<ConvexDecomposition> Cutter::cut_exactly() const {
  std::vector<SolidPart> parts;
  // Cells are cut depth first, beginning with a box about the whole mesh.
  std::vector<SolidCell> waiting = {make_whole_cell(*mesh_.mesh, planes_)};
  const std::size_t most_cells = 2 * kPartsAPiece * most_pieces_;
  for (std::size_t cells = 0; !waiting.empty(); ++cells) {
    poll_interrupt();
    if (cells + waiting.size() > most_cells) return std::nullopt;
    std::optional<OpenCell> open = opened(std::move(waiting.back()));
    waiting.pop_back();
    if (!open) continue;
    // No conflict: the part of the solid in the cell is convex and is a piece. Otherwise a notch is resolved
    // by a cut, and both halves are examined.
    if (open->conflicts.empty()) {
      const double excess = shallow_excess(open->cell, open->points, planes_, winding_);
      parts.push_back({std::move(open->hull), std::move(open->cell.fragments), excess});
    } else {
      const CutPlane cut = choose_exact_cut(open->cell, open->points, planes_);
      std::array<SolidCell, 2> halves = cut_cell(open->cell, cut, planes_);
      waiting.push_back(std::move(halves[1]));
      waiting.push_back(std::move(halves[0]));
    }
    if (!goes_on(parts.size(), std::numeric_limits<double>::infinity())) return std::nullopt;
  }
  // Joining undoes cuts that proved to be unnecessary.
  ConvexDecomposition exact = result(std::move(parts), most_excess_);
  if (exact.pieces.size() > most_pieces_) return std::nullopt;
  return exact;
}

MaximumBounds Cutter::excess_of(const OpenCell& open, MaximumGoal goal) const {
  goal.absolute_gap = kFinest * planes_.size;
  // The bound for shallow pockets is cheap; where it is already small, branch and bound is not needed.
  const double shallow = shallow_excess(open.cell, open.points, planes_, winding_);
  if (shallow <= goal.absolute_gap) return {0, shallow, open.points[0]};
  MaximumBounds bounds = hull_excess(open.hull, mesh_, winding_, goal, open.conflicts);
  // A conflict means an excess, even if the pocket is too fine for the search to see.
  bounds.upper = std::max(std::min(bounds.upper, shallow), planes_.tolerance);
  return bounds;
}

void Cutter::add_cell(SolidCell cell, std::vector<OpenCell>& cells) const {
  std::optional<OpenCell> open = opened(std::move(cell));
  if (!open) return;
  if (!open->conflicts.empty()) open->excess = excess_of(*open, kQuick);
  cells.push_back(std::move(*open));
}

ConvexDecomposition Cutter::cut_roughly() const {
  std::vector<OpenCell> cells;
  add_cell(make_whole_cell(*mesh_.mesh, planes_), cells);
  // The cell with the largest bound of its excess is replaced by its two halves.
  while (!cells.empty() && cells.size() < most_pieces_) {
    poll_interrupt();
    const auto worst = std::max_element(cells.begin(), cells.end(), [](const OpenCell& a, const OpenCell& b) {
      return a.excess.upper < b.excess.upper;
    });
    const double excess = worst->excess.upper;
    if (excess <= options_.tolerance || !goes_on(cells.size(), excess)) break;
    // The cut passes through the bottom of the deepest pocket, which is the point of the solid nearest to the
    // farthest point of the hull.
    const Vec3 deepest = worst->excess.place;
    const Vec3 nearest = nearest_mesh_point(mesh_, deepest).p_M;
    const CutPlane cut = choose_rough_cut(worst->cell, worst->points, planes_, deepest, nearest);
    std::array<SolidCell, 2> halves = cut_cell(worst->cell, cut, planes_);
    cells.erase(worst);
    for (SolidCell& half : halves) add_cell(std::move(half), cells);
  }
  // The excesses of the cells that are left are bounded more closely, since they are the stated error.
  std::vector<SolidPart> parts;
  for (OpenCell& open : cells) {
    const double stated = open.conflicts.empty() ? 0 : excess_of(open, kStated).upper;
    const double excess = std::min(stated, open.excess.upper);
    parts.push_back({std::move(open.hull), std::move(open.cell.fragments), excess});
  }
  // Joining must not make the worst piece worse.
  double most_excess = options_.tolerance;
  for (const SolidPart& part : parts) most_excess = std::max(most_excess, part.excess);
  return result(std::move(parts), most_excess);
}

ConvexDecomposition Cutter::result(std::vector<SolidPart> parts, double most_excess) const {
  ConvexDecomposition result;
  result.volume = mass_properties(*mesh_.mesh, 1.0).mass;
  for (const SolidPart& part : joined_parts(std::move(parts), planes_, most_excess)) {
    result.pieces.push_back(
        {std::make_shared<const ConvexHull>(part.hull), real_shares(part, planes_), part.excess});
    result.pieces_volume += hull_volume(part.hull);
    result.error = std::max(result.error, part.excess);
  }
  return result;
}

/// The exact decomposition. Its excesses are rounding only and are stated as 0.
std::optional<ConvexDecomposition> exact_pieces(const Cutter& cutter) {
  std::optional<ConvexDecomposition> exact = cutter.cut_exactly();
  if (!exact) return exact;
  exact->is_exact = true;
  exact->error = 0;
  for (ConvexPiece& piece : exact->pieces) piece.excess = 0;
  return exact;
}

}  // namespace

ConvexDecomposition decompose(const Mesh& mesh, const DecompositionOptions& options) {
  RIGOR_ASSERT(mesh.tree != nullptr && mesh.tree->is_closed && !mesh.mesh->triangles.empty());
  const WindingNumber winding(*mesh.mesh);
  std::optional<ConvexDecomposition> best = exact_pieces(Cutter(mesh, winding, options, 0));
  if (best && options.tolerance <= 0) return *best;
  const auto take_if_better = [&](ConvexDecomposition other) {
    const bool is_good = other.error <= options.tolerance;
    if (!best || (is_good && other.pieces.size() < best->pieces.size())) best = std::move(other);
  };
  // Faces that are flat in single precision only give many notches. With a flatness their triangles are one
  // face, and the bound for shallow pockets says what that costs.
  if (options.tolerance > 0) {
    const Cutter flat(mesh, winding, options, options.tolerance / kFlatness);
    std::optional<ConvexDecomposition> nearly = flat.cut_exactly();
    if (nearly && nearly->error <= options.tolerance) take_if_better(std::move(*nearly));
  }
  if (best && best->pieces.size() == 1) return *best;
  // Approximate decomposition: one with more pieces than the best so far would be no better.
  DecompositionOptions fewer = options;
  if (best) fewer.max_pieces = static_cast<int>(best->pieces.size()) - 1;
  take_if_better(Cutter(mesh, winding, fewer, 0).cut_roughly());
  return *best;
}

std::optional<ConvexDecomposition> decompose_exactly(const Mesh& mesh, int max_pieces) {
  RIGOR_ASSERT(mesh.tree != nullptr && mesh.tree->is_closed && !mesh.mesh->triangles.empty());
  const WindingNumber winding(*mesh.mesh);
  const DecompositionOptions options{.max_pieces = max_pieces};
  return exact_pieces(Cutter(mesh, winding, options, 0));
}

}  // namespace rigor
