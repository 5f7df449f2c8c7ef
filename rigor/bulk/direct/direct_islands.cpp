#include "rigor/bulk/direct/direct_islands.hpp"

#include "rigor/bulk/direct/direct_problem.hpp"
#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <variant>

namespace rigor {

using Eigen::Index;

namespace {

constexpr int most_bodies = 64;
constexpr double least_mass_ratio = 10;
/// The part of an overlap that is put back in a step.
constexpr double put_back = 0.2;
/// Overlaps that stay, as a part of the size of the smallest body.
constexpr double tolerated_overlap = 1e-5;

void set_floats(const Vec3& a, float* p) {
  for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(a[k]);
}

/// Rows: two tangents and the normal.
Mat3 contact_frame(const Vec3& n) {
  Mat3 frame;
  const Vec3 t1 = n.unitOrthogonal();
  frame << t1.transpose(), n.cross(t1).transpose(), n.transpose();
  return frame;
}

Mat6 block_diagonal(double linear, const Mat3& angular) {
  Mat6 block = Mat6::Zero();
  block.diagonal().head<3>().setConstant(linear);
  block.bottomRightCorner<3, 3>() = angular;
  return block;
}

/// Rows of J for one body: the velocity at r from its centre along the axes of the frame, positive for B.
ContactRows::Block rows_of(const Mat3& frame, const Vec3& r, double sign) {
  ContactRows::Block J;
  for (Index k = 0; k < 3; ++k) {
    const Vec3 axis = sign * frame.row(k).transpose();
    J.row(k) << axis.transpose(), r.cross(axis).transpose();
  }
  return J;
}

/// Velocity of a body at r from its centre.
Vec3 velocity_at(const BulkBodies& bodies, int body, const Vec3& r) {
  const MotionRecord& m = bodies.motion[at(body)];
  return vector_of(m.v) + vector_of(m.w).cross(r);
}

/// Impulses of the points of a manifold over the whole step, in the frame, as they are remembered: the
/// friction is shared out in proportion to the normal impulses.
std::vector<Vec3> step_impulses(const ManifoldMemories::View& memory, const ManifoldView& manifold,
                                const Mat3& frame, int substeps) {
  // Normal impulses, which are remembered of one substep and by the features of the points.
  std::vector<Vec3> impulses(at(manifold.point_count), Vec3::Zero());
  if (!memory.is_there()) return impulses;
  double pressed = 0;
  for (std::size_t k = 0; k < impulses.size(); ++k) {
    impulses[k].z() = substeps * static_cast<double>(remembered_impulse(memory, manifold.points[k].feature));
    pressed += impulses[k].z();
  }
  if (!(pressed > 0)) return impulses;

  // Friction, which is remembered of the manifold.
  const Vec3 friction = substeps * (frame * vector_of(memory.friction_impulse_W));
  for (Vec3& impulse : impulses) impulse.head<2>() = impulse.z() / pressed * friction.head<2>();
  return impulses;
}

/// The contact of a manifold without its impulses; approach_speed: at the present velocities of the bodies.
BulkContact contact_of(const StepManifolds& manifolds, std::size_t i, const BulkBodies& bodies) {
  const ShapePair& pair = manifolds.pair(i);
  const ManifoldView manifold = manifolds.view(i);
  BulkContact contact;
  contact.body_A = pair.body_A, contact.body_B = pair.body_B;
  contact.shape_A = pair.shape_A, contact.shape_B = pair.shape_B;
  contact.part = manifolds.part(i);
  contact.n_W = vector_of(manifold.normal);
  contact.point_count = manifold.point_count;
  contact.center_W = contact.friction_impulse_W = contact.friction_moment_W = Vec3::Zero();

  // The points, their centre, and the fastest approach of one of them.
  const Vec3& x_A = bodies.x[at(pair.body_A)];
  const Vec3& x_B = bodies.x[at(pair.body_B)];
  contact.approach_speed = 0;
  for (int k = 0; k < contact.point_count; ++k) {
    const ManifoldPoint& point = manifold.points[at(k)];
    const Vec3 p_W = x_A + vector_of(point.p);
    contact.points[at(k)] = {p_W, static_cast<double>(point.gap), 0};
    contact.center_W += p_W / contact.point_count;
    const Vec3 u = velocity_at(bodies, pair.body_B, p_W - x_B) - velocity_at(bodies, pair.body_A, p_W - x_A);
    contact.approach_speed = std::max(contact.approach_speed, -contact.n_W.dot(u));
  }
  contact.is_new = manifolds.is_new(i);
  return contact;
}

/// Whether one of the bodies moves as it must: its work is not known here.
bool is_driven(const ShapePair& pair, const BulkBodies& bodies) {
  const auto moves = [&](int body) { return !bodies.is_dynamic(body) && bodies.has_velocity(body); };
  return moves(pair.body_A) || moves(pair.body_B);
}

/// Gives a contact the impulses of its points: lambda has three each, along the rows of the frame.
void set_impulses(const VecX& lambda, const Mat3& frame, BulkContact& contact) {
  bool is_pressed = false;
  for (int k = 0; k < contact.point_count; ++k) {
    const Vec3 of_point = lambda.segment<3>(3 * static_cast<Index>(k));
    const Vec3 friction = frame.topRows<2>().transpose() * of_point.head<2>();
    contact.points[at(k)].normal_impulse = of_point.z();
    contact.friction_impulse_W += friction;
    contact.friction_moment_W += (contact.points[at(k)].p_W - contact.center_W).cross(friction);
    is_pressed = is_pressed || of_point.z() > 0;
  }
  if (!is_pressed) contact.approach_speed = 0;
}

}  // namespace

DirectIslands::DirectIslands(const Model& model)
    : model_(&model), towers_(model), is_tied_(at(model.body_count()), false), islands_(model) {
  for (const Body& body : model.bodies()) masses_.push_back(body.mass);
  compare_masses();
  find_tied();
}

void DirectIslands::change(const ChangedBodies& changed) {
  for (const int body : changed.bodies) {
    towers_.set_body(*model_, body);
    masses_[at(body)] = model_->body(body).mass;
  }
  compare_masses();
  if (changed.are_ties_new) find_tied();
  islands_.change(*model_, changed);
}

void DirectIslands::compare_masses() {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const double mass : masses_) {
    if (!(mass > 0)) continue;
    least = std::min(least, mass);
    most = std::max(most, mass);
  }
  masses_differ_ = most >= least_mass_ratio * least;
}

/// Finds the bodies that joints or springs hold.
void DirectIslands::find_tied() {
  const Model& model = *model_;
  is_tied_.assign(is_tied_.size(), false);
  for (int i = 0; i < static_cast<int>(model.joints().size()); ++i) {
    for (const int body : model.bodies_of_joint(i)) is_tied_[at(body)] = true;
  }
  for (const Force& force : model.forces()) {
    const Spring* const spring = std::get_if<Spring>(&force);
    if (spring == nullptr) continue;
    for (const int body : {spring->body_A, spring->body_B}) {
      if (body != world_body) is_tied_[at(body)] = true;
    }
  }
}

bool DirectIslands::may_be_needed(const ManifoldMemories& memory, double substep) {
  return towers_.may_be_there(memory, substep) || masses_differ_;
}

std::vector<DirectIslands::Island> DirectIslands::find_islands(const StepManifolds& manifolds,
                                                               const BulkBodies& bodies) {
  islands_.build(manifolds);

  struct Summary {
    int body_count = 0;
    double least_mass = std::numeric_limits<double>::infinity(), most_mass = 0, mass = 0;
    double mass_of_tower = std::numeric_limits<double>::infinity();  // From which on one would be slender.
    int number = -1;                                                 // Among those found.
  };

  // The number of bodies of each island.
  std::vector<Summary> summaries(at(bodies.count()));  // By the lowest body.
  for (int i = 0; i < bodies.count(); ++i) {
    if (bodies.is_dynamic(i)) ++summaries[at(islands_.island_of(i))].body_count;
  }

  // The masses of those that are small enough. (Masses lie far from each other in memory, so only these are
  // read.)
  std::vector<int> candidates;
  for (int i = 0; i < bodies.count(); ++i) {
    if (!bodies.is_dynamic(i)) continue;
    Summary& island = summaries[at(islands_.island_of(i))];
    if (island.body_count < 2 || island.body_count > most_bodies) continue;
    candidates.push_back(i);
    const double mass = model_->body(i).mass;
    island.mass += mass;
    island.least_mass = std::min(island.least_mass, mass);
    island.most_mass = std::max(island.most_mass, mass);
    island.mass_of_tower = std::min(island.mass_of_tower, towers_.least_mass(i));
  }

  // Islands of heavy bodies on light ones, or with the weight of a slender tower, and their bodies.
  std::vector<Island> found;
  for (const int i : candidates) {
    Summary& island = summaries[at(islands_.island_of(i))];
    const bool is_heavy_on_light = island.most_mass >= least_mass_ratio * island.least_mass;
    if (!is_heavy_on_light && island.mass < island.mass_of_tower) continue;
    if (island.number < 0) {
      island.number = static_cast<int>(found.size());
      found.emplace_back().is_heavy_on_light = is_heavy_on_light;
    }
    found[at(island.number)].bodies.push_back(i);
  }
  if (found.empty()) return found;

  // Their manifolds.
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    const int body = bodies.is_dynamic(manifolds.body_A(i)) ? manifolds.body_A(i) : manifolds.body_B(i);
    const int number = summaries[at(islands_.island_of(body))].number;
    if (number >= 0) found[at(number)].manifolds.push_back(i);
  }
  return found;
}

bool DirectIslands::is_taken(const StepManifolds& manifolds, const Island& island,
                             const BulkBodies& bodies) const {
  // Its bodies: free of joints and springs, heavy on light or a column.
  if (island.manifolds.empty()) return false;
  for (const int body : island.bodies) {
    if (is_tied_[at(body)]) return false;
  }
  if (!island.is_heavy_on_light && !is_column(manifolds, island, bodies)) return false;

  // Its manifolds: with laws that the problem has.
  return std::none_of(island.manifolds.begin(), island.manifolds.end(), [&](std::size_t i) {
    const ManifoldSurface& surface = manifolds.surface(i);
    return surface.rolling_friction > 0 || surface.torsional_friction > 0 ||
           is_driven(manifolds.pair(i), bodies);
  });
}

/// Whether each of its bodies touches at most two others of them.
bool DirectIslands::is_column(const StepManifolds& manifolds, const Island& island,
                              const BulkBodies& bodies) const {
  std::map<int, std::set<int>> neighbours;
  for (const std::size_t i : island.manifolds) {
    const int a = manifolds.body_A(i), b = manifolds.body_B(i);
    if (!bodies.is_dynamic(a) || !bodies.is_dynamic(b)) continue;
    neighbours[a].insert(b);
    neighbours[b].insert(a);
  }
  return std::all_of(neighbours.begin(), neighbours.end(),
                     [](const auto& of_body) { return of_body.second.size() <= 2; });
}

void DirectIslands::clear() {
  found_.clear();
  is_held_.clear();
  island_count_ = 0;
  ends_.clear();
  solved_.clear();
  contacts_.clear();
}

void DirectIslands::find(const StepManifolds& manifolds, const BulkBodies& bodies) {
  clear();
  if (manifolds.size() == 0) return;
  found_ = find_islands(manifolds, bodies);
  std::erase_if(found_, [&](const Island& island) { return !is_taken(manifolds, island, bodies); });
}

void DirectIslands::solve(const DirectStep& step, BulkBodies& bodies) {
  for (const Island& island : found_) {
    if (!solve_island(step, island, bodies)) continue;
    ++island_count_;
    is_held_.resize(at(bodies.count()), false);
    for (const int body : island.bodies) is_held_[at(body)] = true;
  }
}

DirectProblem DirectIslands::problem_of(const DirectStep& step, const Island& island,
                                        const BulkBodies& bodies) const {
  // The bodies: masses, and velocities at the end of the step without contacts.
  DirectProblem problem;
  for (const int i : island.bodies) {
    const Body& body = model_->body(i);
    const Mat3 R_WB = bodies.q[at(i)].toRotationMatrix();
    problem.motion.rows.masses.push_back(
        block_diagonal(body.mass, R_WB * body.moments.asDiagonal() * R_WB.transpose()));
    problem.motion.rows.inverse_masses.push_back(
        block_diagonal(1 / body.mass, R_WB * body.moments.cwiseInverse().asDiagonal() * R_WB.transpose()));
    const MotionRow change = step.free_change(i);
    append(vector_of(bodies.motion[at(i)].v), problem.V_begin);
    append(vector_of(bodies.motion[at(i)].w), problem.V_begin);
    append(problem.V_begin.tail<6>().head<3>() + vector_of(change.data()), problem.V);
    append(problem.V_begin.tail<3>() + vector_of(change.data() + 4), problem.V);
  }

  // The points: rows along two tangents and the normal on each dynamic body; other bodies move as prescribed.
  for (const std::size_t i : island.manifolds) {
    const ManifoldView manifold = step.manifolds.view(i);
    const int a = step.manifolds.body_A(i), b = step.manifolds.body_B(i);
    const Mat3 frame = contact_frame(vector_of(manifold.normal).normalized());
    const Vec3 between = bodies.x[at(b)] - bodies.x[at(a)];
    const std::vector<Vec3> start = step_impulses(step.manifolds.memory(i), manifold, frame, step.substeps);
    for (int k = 0; k < manifold.point_count; ++k) {
      const ManifoldPoint& point = manifold.points[at(k)];
      ContactRows::Sides sides;
      Vec3 prescribed = Vec3::Zero();
      for (const bool is_A : {true, false}) {
        const int body = is_A ? a : b;
        const Vec3 r = is_A ? vector_of(point.p) : Vec3(vector_of(point.p) - between);
        const double sign = is_A ? -1 : 1;
        ContactRows::Side& side = sides[is_A ? 0 : 1];
        if (bodies.is_dynamic(body)) {
          const auto found = std::lower_bound(island.bodies.begin(), island.bodies.end(), body);
          side.node = static_cast<int>(found - island.bodies.begin());
          side.J = rows_of(frame, r, sign);
        } else {
          prescribed += sign * frame * velocity_at(bodies, body, r);
        }
      }
      problem.add_point(frame, static_cast<double>(point.gap),
                        static_cast<double>(step.manifolds.surface(i).friction), sides, prescribed,
                        start[at(k)]);
      problem.restitutions.push_back(static_cast<double>(step.manifolds.surface(i).restitution));
    }
  }
  return problem;
}

/// The velocities without friction that put back a share of the overlaps; zero if they are not found.
VecX DirectIslands::find_push(DirectProblem& problem, double h, const VecX& V_end) {
  problem.motion.laws.mu.assign(problem.gaps.size(), 0.0);
  problem.motion.laws.b = problem.rates(V_end, h, put_back);
  const std::optional<VecX> push = solve_impulses(problem.motion, VecX::Zero(problem.motion.laws.b.size()));
  if (!push) return VecX::Zero(V_end.size());
  return problem.velocities_after(V_end, *push) - V_end;
}

/// The part of the impulses with which the next step may begin: so much that they change no body's velocity
/// by more than twice what forces do. Those of an impact would throw the bodies that it has stopped.
double DirectIslands::lasting_part(const DirectProblem& problem, const Island& island,
                                   const VecX& V_end) const {
  constexpr double most_share = 2;
  const auto largest_change = [&](const VecX& change) {
    double most = 0;
    for (std::size_t k = 0; k < island.bodies.size(); ++k) {
      const Index six = 6 * static_cast<Index>(k);
      const double radius = model_->body(island.bodies[k]).bounding_radius;
      most = std::max(most, change.segment<3>(six).norm() + radius * change.segment<3>(six + 3).norm());
    }
    return most;
  };
  const double by_contacts = largest_change(V_end - problem.V);
  const double by_forces = most_share * largest_change(problem.V - problem.V_begin);
  return by_contacts > by_forces ? by_forces / by_contacts : 1;
}

/// The size of its smallest body: the radius about the centre of mass [m].
double DirectIslands::size_of(const Island& island) const {
  double size = std::numeric_limits<double>::infinity();
  for (const int body : island.bodies) size = std::min(size, model_->body(body).bounding_radius);
  return size;
}

bool DirectIslands::solve_island(const DirectStep& step, const Island& island, BulkBodies& bodies) {
  DirectProblem problem = problem_of(step, island, bodies);
  std::vector<BulkContact> contacts;  // At the velocities of the beginning.
  for (const std::size_t i : island.manifolds) contacts.push_back(contact_of(step.manifolds, i, bodies));

  // Moreau's step: the velocities that Coulomb's law allows at the end of the step.
  problem.motion.laws.b = problem.rates(problem.V, step.h, 0);
  std::optional<VecX> lambda = solve_impulses(problem.motion, problem.start);
  if (!lambda) return false;
  // Where the mass ratio leaves an iterated solution too few digits, one of equations has them.
  if (problem.gain(problem.velocities_after(problem.V, *lambda)) > 0) {
    const std::optional<VecX> other = solve_impulses(problem.motion, VecX());
    if (other && problem.gain(problem.velocities_after(problem.V, *other)) <
                     problem.gain(problem.velocities_after(problem.V, *lambda)))
      lambda = other;
  }
  const VecX V_pressed = problem.affordable(problem.velocities_after(problem.V, *lambda));
  // Points that met fast part again, as in the sweeps once and after the displacements.
  VecX V_end = V_pressed;
  if (const std::optional<VecX> bounce = problem.bounce(*lambda, V_pressed, step.h)) {
    *lambda += *bounce;
    V_end = problem.velocities_after(V_pressed, *bounce);
  }

  // Overlaps are put back by displacements alone, which end with the step. What they lift is paid for by the
  // energy that the step takes, then by what the springs of the sweeps have left in the overlaps.
  VecX V_moved = V_pressed;
  double held = 0;
  for (const std::size_t i : island.manifolds) held += static_cast<double>(step.manifolds.energy(i));
  double kept = 0;  // The part of it that remains.
  if (*std::min_element(problem.gaps.begin(), problem.gaps.end()) < -tolerated_overlap * size_of(island)) {
    const VecX push = find_push(problem, step.h, V_pressed);
    const double taken = problem.kinetic(problem.V_begin) + problem.work(V_pressed) - problem.kinetic(V_end);
    const double lift = -problem.work(push), paid = std::max(0.0, taken) + held;
    const double part = lift > paid ? paid / lift : 1;
    V_moved += part * push;
    if (held > 0) kept = 1 - std::clamp((part * lift - std::max(0.0, taken)) / held, 0.0, 1.0);
  }

  // The bodies move with these; the velocities of the end wait for finish().
  for (std::size_t k = 0; k < island.bodies.size(); ++k) {
    const Index six = 6 * static_cast<Index>(k);
    EndVelocity& end = ends_.emplace_back();
    end.body = island.bodies[k];
    set_floats(V_end.segment<3>(six), end.v);
    set_floats(V_end.segment<3>(six + 3), end.w);
    MotionRecord& motion = bodies.motion[at(end.body)];
    set_floats(V_moved.segment<3>(six), motion.v);
    set_floats(V_moved.segment<3>(six + 3), motion.w);
  }

  // What acted at the contacts.
  const double lasting = lasting_part(problem, island, V_end);
  Index first = 0;
  for (std::size_t k = 0; k < island.manifolds.size(); ++k) {
    const Index rows = 3 * static_cast<Index>(contacts[k].point_count);
    set_impulses(lambda->segment(first, rows), problem.frames[at(static_cast<int>(first / 3))], contacts[k]);
    first += rows;
    solved_.push_back(
        {island.manifolds[k], lasting,
         static_cast<float>(kept * static_cast<double>(step.manifolds.energy(island.manifolds[k])))});
  }
  contacts_.insert(contacts_.end(), contacts.begin(), contacts.end());
  return true;
}

void DirectIslands::finish(BulkBodies& bodies) const {
  for (const EndVelocity& end : ends_) {
    MotionRecord& motion = bodies.motion[at(end.body)];
    std::copy_n(end.v, 3, motion.v);
    std::copy_n(end.w, 3, motion.w);
  }
}

void DirectIslands::remember(int substeps, bool keeps_energy, ManifoldMemories& memory) const {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const std::size_t number = solved_[i].manifold;
    if (keeps_energy) memory.set_energy(number, solved_[i].energy);
    const double lasting = solved_[i].lasting;
    ManifoldMemory remembered = memory[number];
    for (std::size_t k = 0; k < at(remembered.point_count); ++k)
      remembered.normal_impulse[k] =
          static_cast<float>(lasting * contacts_[i].points[k].normal_impulse / substeps);
    set_floats(lasting * contacts_[i].friction_impulse_W / substeps, remembered.friction_impulse_W.data());
    memory.put(number, remembered);
  }
}

}  // namespace rigor
