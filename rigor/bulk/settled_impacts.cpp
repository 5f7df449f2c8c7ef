#include "rigor/bulk/settled_impacts.hpp"

#include "rigor/bulk/contacts/manifold_bounce.hpp"
#include "rigor/bulk/graph/disjoint_sets.hpp"
#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace rigor {

namespace {

/// Rounds over all contacts that struck, and the part of the speed of an impact by which the last one may
/// still change it.
constexpr int most_rounds = 16;
constexpr double settled = 1e-5;

/// Energies in between, while arms stay and inertia may be raised, are known to about this factor.
constexpr double known_to = 2;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Directions in which joints leave less than this part of the mobility of the bodies alone are held: what is
/// left of it is the rounding of joints in 32 bits.
constexpr double least_mobility = 1e-4;

/// The response of the bodies of a manifold alone to a wrench.
Mat6 response_alone(const SolvedManifold& manifold, const BulkBodies& bodies) {
  Mat6 K = Mat6::Zero();
  for (const bool is_B : {false, true}) {
    const int body = is_B ? manifold.body_B : manifold.body_A;
    if (!bodies.is_dynamic(body)) continue;
    const ManifoldFrame& f = manifold.frame;
    K += response_of(bodies.inertia[at(body)], f, is_B ? f.rB : f.rA).K;
  }
  return K;
}

/// What a wrench on body B, and its opposite on A, does to them alone.
void apply(const SolvedManifold& manifold, const Vec6& wrench, BulkBodies& bodies) {
  for (const bool is_B : {false, true}) {
    const int body = is_B ? manifold.body_B : manifold.body_A;
    if (!bodies.is_dynamic(body)) continue;
    const ManifoldFrame& f = manifold.frame;
    const WrenchResponse response = response_of(bodies.inertia[at(body)], f, is_B ? f.rB : f.rA);
    const Vec3 dv = (is_B ? 1 : -1) * response.dv * wrench, dw = (is_B ? 1 : -1) * response.dw * wrench;
    MotionRecord& motion = bodies.motion[at(body)];
    for (int k = 0; k < 3; ++k) {
      motion.v[k] += static_cast<float>(dv[k]);
      motion.w[k] += static_cast<float>(dw[k]);
    }
  }
}

/// The fastest approach of a point that struck [m/s].
double speed_of_impact(const SolvedManifold& manifold) {
  double speed = 0;
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    if (strikes(manifold, k)) speed = std::max(speed, -manifold.points[k].first_speed);
  }
  return speed;
}

}  // namespace

SettledImpacts::SettledImpacts(const Model& model) : model_(&model) {
  find_jointed();
}

void SettledImpacts::settle(const Step& step, BulkJoints& joints, BulkContacts& contacts,
                            BulkBodies& bodies) {
  list_struck(step, contacts, bodies);
  if (struck_.empty()) return;
  // In the order of keys: that of blocks depends on the steps before.
  std::sort(struck_.begin(), struck_.end(),
            [](const Struck& a, const Struck& b) { return a.number < b.number; });
  find_groups();
  std::vector<int> groups;
  for (const Struck& struck : struck_) groups.push_back(struck.group);
  for (const int group : sorted_unique(std::move(groups))) settle_group(group, step, joints, bodies);
  for (const Struck& struck : struck_)
    contacts.add(struck.number, struck.added, impulse_to_keep(struck, step));
}

/// Impacts of one group of bodies, together with their joints. All others keep their bits.
void SettledImpacts::settle_group(int group, const Step& step, BulkJoints& joints, BulkBodies& bodies) {
  motion_.assign(bodies.motion.begin(), bodies.motion.end());
  joints.keep_impulses();
  // What the bodies have, and what the impacts took: they cannot give back more.
  double most = kinetic_energy(group, bodies);
  for (const Struck& struck : struck_) {
    if (struck.group == group) most += energy_taken(struck.manifold, step.accelerations, bodies);
  }
  for (const Struck& struck : struck_) {
    if (struck.group == group) pull_joints(struck, step.executor, joints, bodies);
  }
  joints.raise_inertia(bodies);
  for (Struck& struck : struck_) {
    if (struck.group == group) struck.K = find_response(struck, step.executor, joints, bodies);
  }

  // The last sweep over contacts came after the joints.
  hold_joints(group, step.executor, joints, bodies);
  // One contact after the other, until none changes.
  bool has_changed = true;
  for (int round = 0; has_changed && round < most_rounds; ++round) {
    has_changed = false;
    for (Struck& struck : struck_) {
      if (struck.group != group || !change_motion(struck, step.accelerations, bodies)) continue;
      has_changed = true;
      hold_joints(group, step.executor, joints, bodies);
    }
  }
  if (!has_changed && kinetic_energy(group, bodies) <= known_to * most) {
    joints.take_back_impulses([&](int joint) {
      const std::vector<int> own = model_->bodies_of_joint(joint);
      return std::none_of(own.begin(), own.end(), [&](int body) { return group_[at(body)] == group; });
    });
    return;
  }
  // Very heavy bodies on light ones do not come to an end so, and joints that contradict each other may let
  // rounds grow, also beyond all numbers: such groups are left as the sweeps have left them.
  take_back(joints, bodies);
  for (Struck& struck : struck_) {
    if (struck.group != group) continue;
    struck.added = {};
    struck.kept = infinity;
  }
}

/// Of the bodies of a group [J].
double SettledImpacts::kinetic_energy(int group, const BulkBodies& bodies) const {
  double energy = 0;
  for (int i = 0; i < bodies.count(); ++i) {
    if (group_[at(i)] == group && bodies.is_dynamic(i)) energy += kinetic_energy_now(*model_, i, bodies);
  }
  return energy;
}

/// Lets joints hold what they connect with bodies of a group.
void SettledImpacts::hold_joints(int group, const Executor& executor, BulkJoints& joints,
                                 BulkBodies& bodies) const {
  const auto is_own = [&](std::size_t i) {
    return jointed_.contains(static_cast<int>(i)) && group_[i] == group;
  };
  bool has_joints = false;
  for (std::size_t i = 0; i < group_.size(); ++i) has_joints = has_joints || is_own(i);
  if (!has_joints) return;
  joints.solve(JointPass::rates, executor);
  for (std::size_t i = 0; i < motion_.size(); ++i) {
    if (jointed_.contains(static_cast<int>(i)) && !is_own(i)) bodies.motion[i] = motion_[i];
  }
}

/// Bodies that joints or contacts that struck connect.
void SettledImpacts::find_groups() {
  group_ = jointed_.groups();
  const auto is_dynamic = [&](int body) { return model_->body(body).motion == MotionType::dynamic; };
  for (const Struck& struck : struck_) {
    const int a = struck.manifold.body_A, b = struck.manifold.body_B;
    if (!is_dynamic(a) || !is_dynamic(b)) continue;
    join_sets(group_, a, b);
  }
  for (int& group : group_) group = find_root(group_, group);
  for (Struck& struck : struck_)
    struck.group =
        group_[at(is_dynamic(struck.manifold.body_A) ? struck.manifold.body_A : struck.manifold.body_B)];
}

/// What forces give the bodies of a contact in two substeps stops this impulse.
double SettledImpacts::impulse_to_keep(const Struck& struck, const Step& step) const {
  constexpr double forces = 2;
  if (struck.kept > 0 || !(struck.K(0, 0) > 0)) return struck.kept;
  double most = 0;
  for (const int body : {struck.manifold.body_A, struck.manifold.body_B}) {
    if (model_->body(body).motion == MotionType::dynamic)
      most = std::max(most, vector_of(step.accelerations[at(body)].data()).norm());
  }
  return forces * most * step.substep / struck.K(0, 0);
}

/// The contacts that struck, and what they are to end with.
void SettledImpacts::list_struck(const Step& step, const BulkContacts& contacts, const BulkBodies& bodies) {
  struck_.clear();
  contacts.for_contacts([&](const SolvedManifold& manifold, std::size_t number) {
    const auto moves = [&](int body) { return bodies.is_dynamic(body) && !step.held.contains(body); };
    if (!strikes(manifold) || !(moves(manifold.body_A) || moves(manifold.body_B))) return;
    Struck& struck = struck_.emplace_back(Struck{number, manifold, {}, Mat6::Zero(), {}, -1, 0});
    struck.aim.may_take_back = true;
    const Vec6 u = motion_at(manifold, bodies);
    const bool is_alone = !are_jointed(manifold.body_A, manifold.body_B);
    // What is moved by the program goes on pushing.
    const auto is_driven = [&](int body) { return model_->body(body).motion == MotionType::kinematic; };
    const bool is_pushed = is_driven(manifold.body_A) || is_driven(manifold.body_B);
    struck.kept = is_alone && (is_pushed || !contacts.manifolds().is_new(number)) ? infinity : 0;
    for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
      double& speed = struck.aim.speeds[k];
      speed = -manifold.restitution * meeting_speed(manifold, k, step.accelerations, bodies);
      // Bodies without joints have bounced as far as their energy allows.
      if (is_alone) speed = std::min(speed, std::max(0.0, u.dot(row_of(manifold.points[k]))));
    }
  });
}

/// Wrenches of the size of the impact, each along one axis: they give the bodies alone about its speed,
/// rotations by the radius of gyration. 0 along axes that move nothing.
Vec6 SettledImpacts::wrench_sizes(const SolvedManifold& manifold, const BulkBodies& bodies) {
  const Mat6 alone = response_alone(manifold, bodies);
  Vec6 sizes = Vec6::Zero();
  for (Eigen::Index k = 0; k < 6; ++k) {
    if (!(alone(k, k) > 0)) continue;
    const double radius = k < 3 ? 1 : std::sqrt(alone(0, 0) / alone(k, k));
    sizes[k] = speed_of_impact(manifold) / (radius * alone(k, k));
  }
  return sizes;
}

/// Joints hold as tautly as an impact of this size pulls at them: light bodies between heavy ones would be
/// thrown about by the least bend.
void SettledImpacts::pull_joints(const Struck& struck, const Executor& executor, BulkJoints& joints,
                                 BulkBodies& bodies) {
  const SolvedManifold& manifold = struck.manifold;
  if (!are_jointed(manifold.body_A, manifold.body_B)) return;
  const Vec6 sizes = wrench_sizes(manifold, bodies);
  for (Eigen::Index k = 0; k < 6; ++k) {
    for (const double sign : {-1.0, 1.0}) {
      apply(manifold, sign * sizes[k] * Vec6::Unit(k), bodies);
      joints.solve(JointPass::rates, executor);
      joints.hold_tauter();
      take_back(joints, bodies);
    }
  }
}

/// What the bodies of a contact, with all that joints hold to them, answer to a wrench: they are tried.
Mat6 SettledImpacts::find_response(const Struck& struck, const Executor& executor, BulkJoints& joints,
                                   BulkBodies& bodies) {
  const SolvedManifold& manifold = struck.manifold;
  if (!are_jointed(manifold.body_A, manifold.body_B)) return response_alone(manifold, bodies);
  const Vec6 untouched = try_wrench(manifold, Vec6::Zero(), executor, joints, bodies);
  const Vec6 sizes = wrench_sizes(manifold, bodies);
  Mat6 K = Mat6::Zero();
  for (Eigen::Index k = 0; k < 6; ++k) {
    if (!(sizes[k] > 0)) continue;
    K.col(k) =
        (try_wrench(manifold, sizes[k] * Vec6::Unit(k), executor, joints, bodies) - untouched) / sizes[k];
  }
  return 0.5 * (K + K.transpose());
}

/// How the bodies would move after a wrench, held by their joints; nothing stays changed.
Vec6 SettledImpacts::try_wrench(const SolvedManifold& manifold, const Vec6& wrench, const Executor& executor,
                                BulkJoints& joints, BulkBodies& bodies) {
  apply(manifold, wrench, bodies);
  joints.solve(JointPass::rates, executor);
  Vec6 u = motion_at(manifold, bodies);
  take_back(joints, bodies);
  return u;
}

void SettledImpacts::take_back(BulkJoints& joints, BulkBodies& bodies) const {
  std::copy(motion_.begin(), motion_.end(), bodies.motion.begin());
  joints.take_back_impulses([](int) { return true; });
}

/// Gives a contact what it lacks, or takes back what it did too much; whether that was more than rounding.
bool SettledImpacts::change_motion(Struck& struck, const std::vector<MotionRow>& accelerations,
                                   BulkBodies& bodies) const {
  SolvedManifold& manifold = struck.manifold;
  if (struck.K(0, 0) < least_mobility * response_alone(manifold, bodies)(0, 0)) return false;
  const Vec6 u = motion_at(manifold, bodies);
  const ImpactImpulses found = find_impact(manifold, struck.aim, u, struck.K);

  // What the change costs, and the part of it that what the impact took pays for.
  const Vec6 change = struck.K * found.wrench;
  const ImpactCost cost{0.5 * found.wrench.dot(change), found.wrench.dot(u)};
  const double e = manifold.restitution;
  const double part = cost.affordable_part(e * e * energy_taken(manifold, accelerations, bodies));
  if (!(part * change.head<3>().norm() > settled * speed_of_impact(manifold))) return false;
  apply(manifold, part * found.wrench, bodies);
  const ManifoldImpulses impulses = found.part(part);
  struck.added += impulses;
  manifold.impulses += impulses;
  return true;
}

}  // namespace rigor
