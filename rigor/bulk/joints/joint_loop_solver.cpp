#include "rigor/bulk/joints/joint_loop_solver.hpp"

#include "rigor/bulk/joints/joint_lanes.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/math/types.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <utility>
#include <vector>

namespace rigor {

namespace {

/// Softness that is added to all rows, as a part of their diagonal element: above what rounding and misfits
/// of a thousandth of an arm make of directions that loops make redundant (their square), below nearly all
/// others.
constexpr double kRedundancy = 1e-6;

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor, kMostJointRows, 6>;
using Sparse = Eigen::SparseMatrix<double>;

Vec3 read_lane(const FloatVec3& a, int lane) {
  return Vec3(a.x[lane], a.y[lane], a.z[lane]);
}
Mat3 read_lane(const FloatSym3& m, int lane) {
  Mat3 full;
  full << m.xx[lane], m.xy[lane], m.xz[lane], m.xy[lane], m.yy[lane], m.yz[lane], m.xz[lane], m.yz[lane],
      m.zz[lane];
  return full;
}
/// M⁻¹ of a body.
struct InverseMass {
  double translation;  ///< [1/kg].
  Mat3 rotation;       ///< [1/(kg m²)].

  InverseMass(const JointSlot& slot, int lane)
      : translation(slot.inverse_mass[lane]), rotation(read_lane(slot.inverse_inertia, lane)) {}
  Rows operator()(const Rows& J) const {
    Rows JM(J.rows(), 6);
    JM.leftCols<3>() = translation * J.leftCols<3>();
    JM.rightCols<3>() = J.rightCols<3>() * rotation;
    return JM;
  }
};

}  // namespace

/// Rows of a joint or a gear on a body.
struct LoopSolver::Side {
  int node = 0;       ///< Joints by link, then gears.
  int slot = 0;       ///< Of a body that joints move.
  int link = 0;       ///< Whose rows they are; of gears that of a wheel.
  bool is_B = false;  ///< Of that joint.
  int wheel = 0;      ///< Of a gear: 1 its first, 2 its second; 0: no gear.
};

/// What all lanes have in common.
struct LoopSolver::Pattern {
  explicit Pattern(const JointSystems& systems);

  std::vector<Side> sides;                 ///< By slot.
  std::vector<int> slot_begin;             ///< In `sides`; one more at the end.
  std::vector<int> first_row, row_counts;  ///< Of each node.
  int size = 0;                            ///< Number of rows.
  Sparse lower;                            ///< Lower triangle, of ones.
  /// Of each pair of sides in the order of for_pairs(): in a column of the second's node, counted from where
  /// the rows of that node begin, the place where those of the first begin.
  std::vector<int> places;

  /// Calls work(i, k) for all pairs of sides of a slot of which i has no lower node than k.
  template <class Work>
  void for_pairs(const Work& work) const {
    for (std::size_t s = 0; s + 1 < slot_begin.size(); ++s) {
      for (int i = slot_begin[s]; i < slot_begin[s + 1]; ++i) {
        for (int k = slot_begin[s]; k < slot_begin[s + 1]; ++k) {
          const std::size_t a = at(i), b = at(k);
          if (sides[a].node >= sides[b].node) work(a, b);
        }
      }
    }
  }

 private:
  int add_node(int rows);
  void add_sides(int node, int link, int wheel, const JointSystems& systems);
  void sort_by_slot(std::size_t slots);
  void find_places();
};

int LoopSolver::Pattern::add_node(int rows) {
  first_row.push_back(size);
  row_counts.push_back(rows);
  size += rows;
  return static_cast<int>(row_counts.size()) - 1;
}

void LoopSolver::Pattern::add_sides(int node, int link, int wheel, const JointSystems& systems) {
  const JointLink& joint = systems.links[at(link)];
  const int moved = static_cast<int>(systems.moved);
  if (joint.parent < moved) sides.push_back({node, joint.parent, link, !joint.child_is_B, wheel});
  if (joint.child < moved) sides.push_back({node, joint.child, link, joint.child_is_B, wheel});
}

void LoopSolver::Pattern::sort_by_slot(std::size_t slots) {
  std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.slot < b.slot; });
  slot_begin.assign(slots + 1, 0);
  for (const Side& side : sides) ++slot_begin[at(side.slot) + 1];
  for (std::size_t s = 0; s < slots; ++s) slot_begin[s + 1] += slot_begin[s];
}

/// Finds which elements the lower triangle has, and where the blocks of the pairs lie.
void LoopSolver::Pattern::find_places() {
  // Of each node those that share a body with it, from itself on: D has a block wherever two of them do.
  std::vector<std::vector<int>> below(row_counts.size());
  for (std::size_t n = 0; n < below.size(); ++n) below[n].push_back(static_cast<int>(n));
  for_pairs([&](std::size_t i, std::size_t k) { below[at(sides[k].node)].push_back(sides[i].node); });

  // Elements on and below the diagonal.
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t n = 0; n < below.size(); ++n) {
    below[n] = sorted_unique(std::move(below[n]));
    for (int c = first_row[n]; c < first_row[n] + row_counts[n]; ++c) {
      for (const int node : below[n]) {
        const std::size_t b = at(node);
        for (int r = std::max(c, first_row[b]); r < first_row[b] + row_counts[b]; ++r) {
          entries.emplace_back(r, c, 1.0);
        }
      }
    }
  }
  lower.resize(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());

  // Where in its columns the block of each pair begins.
  for_pairs([&](std::size_t i, std::size_t k) {
    int place = 0;
    for (const int node : below[at(sides[k].node)]) {
      if (node == sides[i].node) break;
      place += row_counts[at(node)];
    }
    places.push_back(place);
  });
}

LoopSolver::Pattern::Pattern(const JointSystems& systems) {
  for (std::size_t i = 0; i < systems.links.size(); ++i) {
    add_sides(add_node(row_count(systems.links[i])), static_cast<int>(i), 0, systems);
  }
  for (const GearLink& gear : systems.gears) {
    const int node = add_node(1);
    add_sides(node, gear.first, 1, systems);
    add_sides(node, gear.second, 2, systems);
  }
  sort_by_slot(systems.moved);
  find_places();
}

struct LoopSolver::Lane {
  int lane = 0;
  std::vector<Rows> J, JM;  ///< Of each side: its rows, and J M⁻¹.
  Sparse lower;
  VecX redundancy;  ///< The softness E of each row.
  std::unique_ptr<Eigen::SimplicialLLT<Sparse>> cholesky;
};

LoopSolver::LoopSolver(const JointSystems& systems) : pattern_(std::make_unique<const Pattern>(systems)) {
  // One sparse matrix a lane; the order of little fill is found once.
  for (int lane = 0; lane < kLaneCount; ++lane) {
    if (systems.links[0].joints[at(lane)] < 0) continue;
    Lane& added = lanes_.emplace_back();
    added.lane = lane;
    added.J.resize(pattern_->sides.size());
    added.JM.resize(pattern_->sides.size());
    added.lower = pattern_->lower;
    added.redundancy.resize(pattern_->size);
    added.cholesky = std::make_unique<Eigen::SimplicialLLT<Sparse>>();
    added.cholesky->analyzePattern(pattern_->lower);
  }
}

LoopSolver::LoopSolver(LoopSolver&& other) noexcept = default;
LoopSolver::~LoopSolver() = default;

/// C and C M⁻¹ of each side, in 64 bits.
void LoopSolver::read_rows(const JointBlock& block, Lane& lane) const {
  const int l = lane.lane;
  for (std::size_t i = 0; i < pattern_->sides.size(); ++i) {
    const Side& side = pattern_->sides[i];
    const JointLink& link = block.systems.links[at(side.link)];
    const JointLanes& joint = block.joints[at(side.link)];
    const int held = held_row_count(link.type, link.has_laws);
    const int first = side.wheel > 0 ? held : 0;  // The coordinate of a wheel is the first.
    const int count = pattern_->row_counts[at(side.node)];

    // Rows of laws count where they are on; a gear has (second coordinate) - ratio (first one).
    Rows& J = lane.J[i];
    J.resize(count, 6);
    for (int r = 0; r < count; ++r) {
      double factor = side.is_B ? 1 : -1;
      if (side.wheel == 1) {
        factor *= -block.gears[at(side.node) - block.joints.size()].ratio[at(l)];
      } else if (side.wheel == 0 && r >= held) {
        factor *= joint.on[r][l];
      }
      const FloatVec3& a = side.is_B ? joint.a_B[first + r] : joint.a_A[first + r];
      J.row(r) << factor * read_lane(joint.n[first + r], l).transpose(), factor * read_lane(a, l).transpose();
    }
    lane.JM[i] = InverseMass(block.slots[at(side.slot)], l)(J);
  }
}

/// D = C M⁻¹ Cᵀ: each pair of sides on a body adds to the block of their nodes.
void LoopSolver::assemble(Lane& lane) const {
  std::fill_n(lane.lower.valuePtr(), lane.lower.nonZeros(), 0.0);
  std::size_t pair = 0;
  pattern_->for_pairs([&](std::size_t i, std::size_t k) {
    const int node = pattern_->sides[k].node;
    const bool is_diagonal = pattern_->sides[i].node == node;
    const int place = pattern_->places[pair++];
    const int first = pattern_->first_row[at(node)];
    const Rows &JM = lane.JM[i], &J = lane.J[k];
    for (int c = 0; c < J.rows(); ++c) {
      double* column = lane.lower.valuePtr() + lane.lower.outerIndexPtr()[first + c] + place - c;
      for (int r = is_diagonal ? c : 0; r < JM.rows(); ++r) column[r] += JM.row(r).dot(J.row(c));
    }
  });
}

void LoopSolver::factor(const JointBlock& block) {
  for (Lane& lane : lanes_) {
    read_rows(block, lane);
    assemble(lane);

    // E on the diagonal.
    for (int row = 0; row < pattern_->size; ++row) {
      double& element = lane.lower.valuePtr()[lane.lower.outerIndexPtr()[row]];
      lane.redundancy[row] = kRedundancy * element;
      element += lane.redundancy[row];
    }

    // The softness of laws.
    for (std::size_t i = 0; i < block.joints.size(); ++i) {
      const JointLink& link = block.systems.links[i];
      for (int r = held_row_count(link.type, link.has_laws); r < row_count(link); ++r) {
        const int row = pattern_->first_row[i] + r;
        lane.lower.valuePtr()[lane.lower.outerIndexPtr()[row]] += block.joints[i].softness[r][lane.lane];
      }
    }
    lane.cholesky->factorize(lane.lower);
  }
}

/// The parts of D⁻¹ b that are used for places and for rates, of the series x₁ = (D + E)⁻¹ b, x_(k+1) = (D +
/// E)⁻¹ E x_k (docs/theory/bulk_joints.md, section 3).
VecX LoopSolver::impulses(const Lane& lane, const VecX& b, bool of_places) const {
  const auto again = [&](const VecX& x) {
    return VecX(lane.cholesky->solve(lane.redundancy.cwiseProduct(x)));
  };
  const VecX x1 = lane.cholesky->solve(b), x2 = again(x1);
  if (of_places) return x1 - x2;
  const VecX x3 = again(x2), x4 = again(x3);
  return x1 + x2 - x3 - x4;
}

void LoopSolver::solve_lane(const Lane& lane, JointBlock& block) const {
  // Only what is not finite cannot be factored: the State tells.
  if (lane.cholesky->info() != Eigen::Success) return;

  // b, the change of the rates that is wanted.
  const int l = lane.lane;
  VecX b(pattern_->size);
  for (std::size_t i = 0; i < block.joints.size(); ++i) {
    for (int r = 0; r < pattern_->row_counts[i]; ++r) {
      b[pattern_->first_row[i] + r] = -block.joints[i].residual[r][l];
    }
  }
  for (std::size_t g = 0; g < block.gears.size(); ++g) {
    b[pattern_->first_row[block.joints.size() + g]] = -block.gears[g].residual[l];
  }

  // b - C M⁻¹ p with the pushes p.
  std::vector<Vec6> push(block.systems.moved);
  for (std::size_t s = 0; s < push.size(); ++s) {
    for (int k = 0; k < 6; ++k) push[s][k] = block.slots[s].push[k][l];
  }
  const auto rows_of = [&](const Side& side, VecX& x) {
    const std::size_t node = at(side.node);
    return x.segment(pattern_->first_row[node], pattern_->row_counts[node]);
  };
  for (std::size_t i = 0; i < pattern_->sides.size(); ++i) {
    const Side& side = pattern_->sides[i];
    rows_of(side, b) -= lane.JM[i] * push[at(side.slot)];
  }

  // D λ = b - C M⁻¹ p.
  VecX lambda = impulses(lane, b, block.is_position_error);

  // Δv = M⁻¹ (p + Cᵀ λ).
  for (std::size_t i = 0; i < pattern_->sides.size(); ++i) {
    const Side& side = pattern_->sides[i];
    push[at(side.slot)] += lane.J[i].transpose() * rows_of(side, lambda);
  }
  for (std::size_t s = 0; s < push.size(); ++s) {
    JointSlot& slot = block.slots[s];
    const InverseMass inverse(slot, l);
    const Vec3 v = inverse.translation * push[s].head<3>(), w = inverse.rotation * push[s].tail<3>();
    for (int k = 0; k < 3; ++k) {
      slot.change[k][l] = static_cast<float>(v[k]);
      slot.change[3 + k][l] = static_cast<float>(w[k]);
    }
  }

  // The impulses of the substep.
  for (std::size_t i = 0; i < block.joints.size(); ++i) {
    for (int r = 0; r < pattern_->row_counts[i]; ++r) {
      block.joints[i].impulse[r][l] += static_cast<float>(lambda[pattern_->first_row[i] + r]);
    }
  }
}

void LoopSolver::solve(JointBlock& block) const {
  for (JointSlot& slot : block.slots) {
    for (FloatLanes& change : slot.change) change = float_lanes(0);
  }
  for (const Lane& lane : lanes_) solve_lane(lane, block);
}

}  // namespace rigor
