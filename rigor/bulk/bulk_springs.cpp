#include "rigor/bulk/bulk_springs.hpp"

#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace rigor {

BulkSprings::BulkSprings(const Model& model) : model_(&model) {
  for (const Force& force : model.forces()) {
    const Spring* const spring = std::get_if<Spring>(&force);
    if (spring != nullptr && (spring->stiffness > 0 || spring->damping > 0)) springs_.push_back(*spring);
  }
}

void BulkSprings::mark_bodies(std::vector<char>& marks) const {
  for (const Spring& spring : springs_) {
    for (const int body : {spring.body_A, spring.body_B}) {
      if (body != world_body) marks[at(body)] = 1;
    }
  }
}

BulkSprings::Place BulkSprings::begin_of(const Spring& spring, const BulkBodies& bodies) const {
  const auto is_world = [](int body) { return body == world_body; };
  const auto arm_of = [&](int body, const Vec3& p) {
    return is_world(body) ? p : Vec3(bodies.q[at(body)] * p);
  };
  const auto center_of = [&](int body) { return is_world(body) ? Vec3(Vec3::Zero()) : bodies.x[at(body)]; };
  const Vec3 r_A = arm_of(spring.body_A, spring.p_AP), r_B = arm_of(spring.body_B, spring.p_BQ);
  return place_between(spring, {r_A, r_B}, center_of(spring.body_B) - center_of(spring.body_A));
}

BulkSprings::Place BulkSprings::end_of(const Spring& spring, const BulkBodies& bodies, const Span& span,
                                       const Motions& accelerations) const {
  // Centre and arm of each end, moved by h u + β h² a and turned by h ω + β h² α.
  const auto moved = [&](int body, const Vec3& p) {
    if (body == world_body) return std::pair<Vec3, Vec3>(Vec3::Zero(), p);
    const MotionRecord& m = bodies.motion[at(body)];
    const auto& a = accelerations[at(body)];
    const double grown = bodies.is_dynamic(body) ? span.beta * span.h * span.h : 0;
    const Vec3 dx = span.h * vector_of(m.v) + grown * a.head<3>();
    const Vec3 turn = span.h * vector_of(m.w) + grown * a.tail<3>();
    const double angle = turn.norm();
    const Vec3 arm = bodies.q[at(body)] * p;
    const Vec3 turned = angle > 0 ? Vec3(Eigen::AngleAxisd(angle, turn / angle) * arm) : arm;
    return std::pair<Vec3, Vec3>(bodies.x[at(body)] + dx, turned);
  };
  const auto A = moved(spring.body_A, spring.p_AP), B = moved(spring.body_B, spring.p_BQ);
  return place_between(spring, {A.second, B.second}, B.first - A.first);
}

BulkSprings::Place BulkSprings::place_between(const Spring& spring, const std::array<Vec3, 2>& arms,
                                              const Vec3& between) const {
  // Where the ends meet, the line has no direction: no force.
  const Vec3 d = between + arms[1] - arms[0];
  const double length = d.norm();
  return {arms[0], arms[1], length > 0 ? Vec3(d / length) : Vec3(Vec3::Zero()), length - spring.length};
}

/// The ends of a spring at a place, with their mobility.
BulkSprings::Row BulkSprings::line_up(const Spring& spring, const Place& place,
                                      const BulkBodies& bodies) const {
  Row row;
  const auto end_at = [&](int body, const Vec3& arm, const Vec3& direction) {
    End end{body, direction, arm.cross(direction)};
    if (body == world_body || !bodies.is_dynamic(body)) return end;
    const Body& own = model_->body(body);
    const Quat& q_WB = bodies.q[at(body)];
    end.dv = end.direction / own.mass;
    end.dw = q_WB * (q_WB.conjugate() * end.moment).cwiseQuotient(own.moments);
    row.mobility += end.direction.dot(end.dv) + end.moment.dot(end.dw);
    return end;
  };
  row.A = end_at(spring.body_A, place.r_A, -place.line);
  row.B = end_at(spring.body_B, place.r_B, place.line);
  return row;
}

double BulkSprings::along(const Row& row, const Motions& rows, const BulkBodies& bodies) {
  double sum = 0;
  for (const End* end : {&row.A, &row.B}) {
    if (end->body == world_body || !bodies.is_dynamic(end->body)) continue;
    const auto& v = rows[at(end->body)];
    sum += end->direction.dot(v.head<3>()) + end->moment.dot(v.tail<3>());
  }
  return sum;
}

/// The force is f = -k (s + c (s₁ - s)) - d (s₁ - s)/h, s₁ being the stretch at the end of the step, along a
/// line between those of its beginning and its end.
BulkSprings::Row BulkSprings::row_of(const Spring& spring, const BulkBodies& bodies, const Span& span,
                                     const Accelerations& accelerations) const {
  const double h = span.h, grown = span.beta * h * h;
  const Place begin = begin_of(spring, bodies), end = end_of(spring, bodies, span, accelerations.before);
  const double mobility = line_up(spring, begin, bodies).mobility;
  const double later = later_share(spring, span, mobility);
  const auto mean = [later](const Vec3& a, const Vec3& b) { return Vec3((1 - later) * a + later * b); };
  Row row = line_up(spring,
                    {mean(begin.r_A, end.r_A), mean(begin.r_B, end.r_B),
                     mean(begin.line, end.line).normalized(), begin.stretch},
                    bodies);
  row.stiff = h * (h * spring.stiffness + spring.damping) * mobility;
  const double change = along(row, accelerations.others, bodies) - along(row, accelerations.before, bodies);
  const double answer = h * later * spring.stiffness + spring.damping;
  row.slope = span.beta * h * answer;
  row.impulse =
      -h * spring.stiffness * begin.stretch - answer * (end.stretch - begin.stretch + grown * change);
  return row;
}

/// c = 1 - β keeps the energy of soft springs, c = 1 brings stiff ones to rest.
double BulkSprings::later_share(const Spring& spring, const Span& span, double mobility) {
  const double stiff = span.h * (span.h * spring.stiffness + spring.damping) * mobility;
  return (1 - span.beta) + span.beta * stiff / (4 + stiff);
}

std::vector<BulkSprings::Row> BulkSprings::rows_of(const BulkBodies& bodies, const Span& span,
                                                   const Accelerations& accelerations) const {
  std::vector<Row> rows;
  for (const Spring& spring : springs_) {
    rows.push_back(row_of(spring, bodies, span, accelerations));
    if (!(rows.back().mobility > 0 && rows.back().slope > 0)) rows.pop_back();
  }
  return rows;
}

/// The function of the accelerations that is least where the forces are those of their laws:
///   β h² |a - a_others|²_M / 2, the energies of the springs, and what dampers take.
double BulkSprings::merit(const BulkBodies& bodies, const Span& span, const Motions& others,
                          const Motions& all) const {
  const double h = span.h, beta = span.beta;
  double sum = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] == others[i]) continue;
    const Body& body = model_->body(static_cast<int>(i));
    const Vec3 a = (all[i] - others[i]).head<3>();
    const Vec3 alpha = bodies.q[i].conjugate() * (all[i] - others[i]).tail<3>();
    sum += 0.5 * beta * h * h * (body.mass * a.squaredNorm() + body.moments.dot(alpha.cwiseAbs2()));
  }
  for (const Spring& spring : springs_) {
    const Place begin = begin_of(spring, bodies), end = end_of(spring, bodies, span, all);
    const double later = later_share(spring, span, line_up(spring, begin, bodies).mobility);
    const double longer = end.stretch - begin.stretch;
    sum += spring.stiffness * longer * (begin.stretch + 0.5 * later * longer) +
           0.5 * spring.damping / h * longer * longer;
  }
  return sum;
}

/// Solves (1/slope + A) ν = impulse/slope, A = J M⁻¹ Jᵀ with the rows J of the lines.
VecX BulkSprings::impulses_of(const std::vector<Row>& rows, std::size_t body_count) const {
  // The rows that meet at each body couple.
  std::vector<std::vector<std::pair<int, const End*>>> at_body(body_count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const End* end : {&rows[i].A, &rows[i].B}) {
      if (end->body != world_body && !end->dv.isZero(0))
        at_body[at(end->body)].emplace_back(static_cast<int>(i), end);
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  VecX right = VecX::Zero(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int k = static_cast<int>(i);
    entries.emplace_back(k, k, 1 / rows[i].slope);
    right[k] = rows[i].impulse / rows[i].slope;
  }
  for (const auto& ends : at_body) {
    for (const auto& [i, end] : ends) {
      for (const auto& [j, other] : ends) {
        if (j <= i) entries.emplace_back(i, j, end->direction.dot(other->dv) + end->moment.dot(other->dw));
      }
    }
  }

  // Rows are scaled to a diagonal of 1, since masses and stiffnesses go over many orders of magnitude.
  Eigen::SparseMatrix<double> matrix(right.size(), right.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  const VecX scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
  // Springs that hold the same motion are told apart by their softness, or by a rounding.
  constexpr double rounding = 1e-14;
  for (Eigen::Index k = 0; k < right.size(); ++k) matrix.coeffRef(k, k) += rounding;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  return scale.cwiseProduct(VecX(solver.solve(scale.cwiseProduct(right))));
}

void BulkSprings::add(const BulkBodies& bodies, double h, int substeps,
                      std::vector<MotionRow>& accelerations) const {
  if (springs_.empty()) return;
  Motions others(accelerations.size());
  for (std::size_t i = 0; i < others.size(); ++i) {
    const float* const a = accelerations[i].data();
    others[i] << vector_of(a), vector_of(a + 4);
  }
  const Motions all = solve(bodies, {h, 0.5 * (substeps + 1) / substeps}, others);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] == others[i]) continue;
    for (int k = 0; k < 3; ++k) {
      accelerations[i][at(k)] = static_cast<float>(all[i][k]);
      accelerations[i][at(4 + k)] = static_cast<float>(all[i][3 + k]);
    }
  }
}

/// Lines turn in a step: Gauss and Newton's method for where stiff springs are at its end.
BulkSprings::Motions BulkSprings::solve(const BulkBodies& bodies, const Span& span,
                                        const Motions& others) const {
  constexpr int rounds = 12;
  constexpr double stiff = 0.04;
  Motions found = others;
  double least = 0;
  for (int round = 0; round < rounds; ++round) {
    // Impulses act evenly through the step.
    const std::vector<Row> rows = rows_of(bodies, span, {others, found});
    if (rows.empty()) return others;
    const VecX impulses = impulses_of(rows, others.size());
    Motions next = others;
    for (std::size_t i = 0; i < rows.size(); ++i)
      apply_force(rows[i], impulses[static_cast<Eigen::Index>(i)] / span.h, next);
    // Soft springs are right at once.
    const auto is_stiff = [](const Row& row) { return row.stiff > stiff; };
    if (std::none_of(rows.begin(), rows.end(), is_stiff)) return next;

    // A shorter step where the whole one leads away.
    if (round == 0) least = merit(bodies, span, others, found);
    const double reached = approach(bodies, span, {others, found}, next);
    if (!(reached < least)) return found;
    constexpr double done = 1e-9;
    const bool is_done = least - reached < done * std::abs(least);
    least = reached;
    found = next;
    if (is_done) break;
  }
  return found;
}

/// Halves the way from `before` to `next` until the merit is less than at its beginning; returns it.
double BulkSprings::approach(const BulkBodies& bodies, const Span& span, const Accelerations& accelerations,
                             Motions& next) const {
  constexpr int halvings = 8;
  const double least = merit(bodies, span, accelerations.others, accelerations.before);
  double reached = merit(bodies, span, accelerations.others, next);
  for (int k = 0; k < halvings && !(reached < least); ++k) {
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = 0.5 * (next[i] + accelerations.before[i]);
    reached = merit(bodies, span, accelerations.others, next);
  }
  return reached;
}

void BulkSprings::apply_force(const Row& spring, double force, Motions& accelerations) {
  for (const End* end : {&spring.A, &spring.B}) {
    if (end->body == world_body) continue;
    auto& row = accelerations[at(end->body)];
    row.head<3>() += force * end->dv;
    row.tail<3>() += force * end->dw;
  }
}

}  // namespace rigor
