#include "rigor/sim/penalty/penalty_touching.hpp"

#include "rigor/contact/impact/joint_stops.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/sim/method/resting_choice.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/sim/pairs/ground_planes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rigor {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// How many times the weight of a body presses its contact by the depth, in reserve for bodies on top of it.
constexpr double weights_on_top = 100;
/// Share of 1/ω by which a step may miss the instant at which a contact begins or ends: in an impact that
/// costs a share of ½ (0.02)² of the energy. Bodies at rest may miss it by a whole step.
constexpr double miss_share = 0.02, resting_share = 0.2;

/// Springs whose stiffness follows from the depth harden beyond it; implicit steps take each as a straight
/// line.
PenaltyChoice choice_of(const Method& method, TouchingForm form) {
  PenaltyChoice choice;
  choice.law =
      method.penalty_law == PenaltyLaw::linear ? PenaltyNormalLaw::linear : PenaltyNormalLaw::hunt_crossley;
  choice.depth = method.penalty_depth;
  if (method.stiffness > 0) choice.stiffness = method.stiffness;
  if (method.damping > 0) choice.damping = method.damping;
  choice.hardens = method.stiffness == 0 && form == TouchingForm::overlapping;
  return choice;
}

ContactMemory empty_memory(const Contact& contact) {
  return {.body_A = contact.body_A,
          .body_B = contact.body_B,
          .shape_A = contact.shape_A,
          .shape_B = contact.shape_B,
          .feature = contact.point.feature};
}

/// The gap at which a contact begins to press [m]: 0, or more where it began pressed.
double first_force(const PenaltyContact& spring) {
  return std::max(0.0, -spring.offset);
}

/// The same for what the State remembers of a contact.
double first_force(const State& state, const PenaltyChoice& choice, const Contact& contact) {
  const ContactKey key = contact.key();
  double gap = 0;
  for (auto place = std::partition_point(state.contacts.begin(), state.contacts.end(),
                                         [&](const ContactMemory& memory) { return memory.key() < key; });
       place != state.contacts.end() && place->key() == key; ++place)
    gap = std::max(gap, first_force(penalty_contact(choice, *place)));
  return gap;
}

void put_in_order(std::vector<ContactMemory>& memories) {
  std::stable_sort(memories.begin(), memories.end(),
                   [](const ContactMemory& a, const ContactMemory& b) { return a.key() < b.key(); });
}

}  // namespace

PenaltyTouching::PenaltyTouching(const Model& model, const Environment& environment,
                                 const ContactSystemAssembler& assembler, const Method& method,
                                 TouchingForm form)
    : model_(model),
      environment_(environment),
      assembler_(assembler),
      contact_tolerance_(method.contact_tolerance),
      resting_velocity_(method.resting_velocity),
      slip_tolerance_(slip_tolerance(method)),
      resting_(resting_choice(method)),
      choice_(choice_of(method, form)),
      form_(form),
      finder_(model, method.broad_phase) {
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion == MotionType::dynamic) bodies_.push_back(i);
  }
}

std::vector<BodyPhase> PenaltyTouching::phases(const State& state) const {
  std::vector<BodyPhase> phases;
  for (const int i : bodies_) {
    phases.push_back(
        {state.position(i), state.orientation(i), state.linear_momentum(i), state.angular_momentum(i)});
  }
  return phases;
}

double PenaltyTouching::least_speed(const Contact& contact) const {
  const double a = std::max(environment_.steady_acceleration(contact.body_A).norm(),
                            environment_.steady_acceleration(contact.body_B).norm());
  // k d = 100 m a, with k = m v²/d².
  return std::max(resting_velocity_, std::sqrt(weights_on_top * a * choice_.depth));
}

std::vector<double> PenaltyTouching::reaches(const State& state, double horizon) const {
  std::vector<double> reaches;
  for (int i = 0; i < model_.body_count(); ++i) {
    const Body& body = model_.body(i);
    const double radius = std::isfinite(body.bounding_radius) ? body.bounding_radius : 0;
    const double speed = linear_velocity(model_, state, i).norm() +
                         angular_velocity(model_, state, i).norm() * radius +
                         0.5 * horizon * environment_.steady_acceleration(i).norm();
    // The boxes of bodies at rest that touch within the tolerance must meet too.
    reaches.push_back(contact_tolerance_ + horizon * speed);
  }
  return reaches;
}

double PenaltyTouching::time_to_touch(const ContactSystem& system, std::size_t contact, double u,
                                      double lag) const {
  // Bound of the relative acceleration: steady forces, and the rotation of the arms.
  const Contact& geometry = system.contacts[contact];
  double a = 0;
  for (const int body : {geometry.body_A, geometry.body_B}) {
    const BodyKinetics& of_body = system.of(body);
    a += environment_.steady_acceleration(body).norm() +
         of_body.w.squaredNorm() * (geometry.p_W() - of_body.x).norm();
  }
  // Solve gap = u t + ½ a t² for t, u: speed of approach, in the form without cancellation.
  u += a * lag;
  const double gap = std::max(0.0, geometry.point.gap);
  const double root = std::sqrt(u * u + 2 * a * gap);
  const double until_touch =
      u > 0 ? (u + root > 0 ? 2 * gap / (u + root) : infinite) : (a > 0 ? (root - u) / a : infinite);
  // Frequency of the spring that this contact will get.
  const ContactMobility mobility = contact_mobility(system, contact);
  if (!(mobility.normal > 0)) return infinite;
  const double speed = std::max(root, least_speed(geometry));
  const double stretch = geometry.friction > 0 ? std::max(1.0, mobility.tangential / mobility.normal) : 1;
  double frequency = speed / choice_.depth * std::sqrt(stretch);
  if (choice_.stiffness) frequency = std::sqrt(*choice_.stiffness * mobility.normal * stretch);
  const bool is_impact = root > least_speed(geometry);
  // The flight ends just before the contact begins: otherwise its first force would act over half the flight.
  const double miss = (is_impact ? miss_share : resting_share) / frequency;
  return until_touch > miss ? until_touch - 0.5 * miss : miss;
}

bool PenaltyTouching::asks_for_steps(const Contact& contact, double approach) const {
  if (form_ == TouchingForm::overlapping) return true;
  return contact.restitution > 0 && approach > calm_share * least_speed(contact);
}

double PenaltyTouching::time_to_part(const Touching& touching, std::size_t contact, double u) const {
  const PenaltyContact& spring = touching.springs[contact];
  const double depth = pressed_depth(spring, touching.system.contacts[contact].point.gap);
  if (!(u > least_speed(touching.system.contacts[contact])) || !(depth > 0)) return infinite;
  const double until_part = depth / u, miss = miss_share * choice_.depth / spring.speed;
  return until_part > miss ? until_part - 0.5 * miss : miss;
}

/// Time until the contact is a fifth of its hardening length deep in the range where it hardens: beyond, its
/// force grows by more than sub-steps of its present frequency resolve.
double PenaltyTouching::time_to_harden(const Touching& touching, std::size_t contact, double u) {
  constexpr double share = 0.2;
  const PenaltyContact& spring = touching.springs[contact];
  if (!(u > 0)) return infinite;
  const double depth = pressed_depth(spring, touching.system.contacts[contact].point.gap);
  return (std::max(0.0, spring.spring.limit - depth) + share * hardening_length(spring.spring)) / u;
}

Touching PenaltyTouching::find(const State& state, double horizon, double lag, const PosesBefore* before) {
  Touching touching;
  touching.free_time = horizon;

  // Contacts of shapes within reach, and stops of the joints.
  const std::vector<BodyPhase> now = phases(state);
  std::vector<Contact> near = finder_.find(state, reaches(state, horizon), contact_tolerance_);
  GroundPlanes(model_, state, near).take_out_hidden(near);
  const std::vector<int> joints = assembler_.joints_of(bodies_);
  if (!joints.empty()) {
    const ContactSystem held = assembler_.assemble(state.t, bodies_, now, {});
    const std::vector<Contact> stops = joint_stops(model_, joints, held.bodies, held.kinetics, infinite);
    near.insert(near.end(), stops.begin(), stops.end());
  }

  // Active contacts, and how long the others leave the bodies free.
  ContactSystem all = assembler_.assemble(state.t, bodies_, now, near);
  const VecX u = relative_velocities(all);
  std::vector<Contact> active;
  for (std::size_t i = 0; i < all.contacts.size(); ++i) {
    const bool overlaps = all.contacts[i].point.gap <= first_force(state, choice_, all.contacts[i]);
    if (overlaps || form_ == TouchingForm::reachable) active.push_back(all.contacts[i]);
    const double approach = -u[3 * static_cast<Eigen::Index>(i) + 2];
    if (overlaps || !asks_for_steps(all.contacts[i], approach)) continue;
    touching.free_time = std::min(touching.free_time, time_to_touch(all, i, approach, lag));
  }
  if (active.size() == all.contacts.size()) {
    touching.system = std::move(all);
  } else {
    all.joints.reset();
    touching.system = assembler_.assemble(state.t, bodies_, now, std::move(active));
  }
  add_springs(state, touching, before);
  // Contacts that part or harden end the step, too.
  const VecX u_active = relative_velocities(touching.system);
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    if (touching.system.contacts[i].is_bounded_force()) continue;
    if (touching.springs[i].speed == 0) continue;  // Where nothing can move, there is no force.
    if (!asks_for_steps(touching.system.contacts[i], touching.springs[i].speed)) continue;
    const double parting = u_active[3 * static_cast<Eigen::Index>(i) + 2];
    touching.free_time = std::min(
        {touching.free_time, time_to_part(touching, i, parting), time_to_harden(touching, i, -parting)});
  }
  return touching;
}

void PenaltyTouching::update_velocities(double t, const std::vector<BodyPhase>& phases,
                                        Touching& touching) const {
  if (touching.system.joints) {
    // Given back first, the equations of the joints are updated: what is the same at the same poses stays.
    std::vector<Contact> contacts = std::move(touching.system.contacts);
    touching.system.joints.reset();
    touching.system = assembler_.assemble(t, bodies_, phases, std::move(contacts));
    // Of a joint with what is asked about it, whether or not its equations are new: five rods in a row take 3
    // µs.
    constexpr std::uint64_t operations = 30;
    count_work(operations * touching.system.joints->joints().size());
    return;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    BodyKinetics& kinetics = touching.system.of(bodies_[i]);
    kinetics.v = phases[i].P * kinetics.inverse_mass;
    kinetics.w = kinetics.inverse_inertia * phases[i].L;
  }
}

void PenaltyTouching::soften(double h, Touching& touching) const {
  if (choice_.stiffness) return;
  constexpr double slowness = 50;  // Time constant of softening in 1/ω.
  const VecX u = relative_velocities(touching.system);
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    PenaltyContact& spring = touching.springs[i];
    const Contact& contact = touching.system.contacts[i];
    const double least = least_speed(contact);
    if (contact.is_bounded_force() || contact.point.gap > 0 || !(spring.speed > 0)) continue;
    // Only springs that have calmed down: (depth/d)² + (rate/v)² is small.
    const double pressed = pressed_depth(spring, contact.point.gap) / choice_.depth;
    const double moving = u[3 * static_cast<Eigen::Index>(i) + 2] / spring.speed;
    if (pressed * pressed + moving * moving > calm_share * calm_share) continue;
    if (!choice_.damping) spring = damped_for_rest(spring, choice_.depth);
    if (spring.speed <= least) continue;
    const double share = h * spring.speed / (slowness * choice_.depth);
    spring = made_for_speed(spring, std::max(least, spring.speed / (1 + share)));
  }
}

std::vector<ContactMemory> PenaltyTouching::memories(const Touching& touching) const {
  std::vector<ContactMemory> memories;
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    const Contact& contact = touching.system.contacts[i];
    if (contact.point.gap > first_force(touching.springs[i])) continue;
    ContactMemory memory = empty_memory(contact);
    remember(touching.springs[i], memory);
    memory.energy =
        normal_energy(touching.springs[i], contact.point.gap) + bristle_energy(contact, touching.springs[i]);
    memories.push_back(memory);
  }
  put_in_order(memories);
  return memories;
}

std::vector<ContactMemory> PenaltyTouching::pressed_at_rest(const State& state) {
  Cluster cluster{.t = state.t, .bodies = bodies_, .phases = phases(state)};
  cluster.contacts = finder_.find(state, reaches(state, 0), contact_tolerance_);
  GroundPlanes(model_, state, cluster.contacts).take_out_hidden(cluster.contacts);
  std::erase_if(cluster.contacts,
                [this](const Contact& contact) { return std::abs(contact.point.gap) > contact_tolerance_; });
  std::vector<ContactMemory> memories;
  for (const Cluster& part : connected_parts(cluster, cluster.contacts, environment_)) {
    if (!part.contacts.empty() && assembler_.joints_of(part.bodies).empty()) add_pressed(part, memories);
  }
  put_in_order(memories);
  return memories;
}

void PenaltyTouching::add_pressed(const Cluster& part, std::vector<ContactMemory>& memories) const {
  if (part.contacts.size() > most_contacts_at_rest) return;

  // Contacts that stay closed.
  const ContactSystem touching = assembler_.assemble(part, part.contacts);
  const VecX u = relative_velocities(touching);
  std::vector<Contact> pressed;
  for (std::size_t i = 0; i < part.contacts.size(); ++i) {
    const double u_n = u[3 * static_cast<Eigen::Index>(i) + 2];
    if (std::abs(u_n) <= still_speed(resting_velocity_)) pressed.push_back(part.contacts[i]);
  }
  if (pressed.empty()) return;

  // The forces of rigid contact at rest.
  const ContactSystem system = assembler_.assemble(part, std::move(pressed));
  const CoulombSolution forces =
      solve_resting(system, assembler_.environment_wrenches(system, part.t), slip_tolerance_, resting_)
          .forces;
  if (!forces.converged) return;
  // Springs pressed by just these forces.
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const Vec3 force = forces.lambda.segment<3>(3 * static_cast<Eigen::Index>(i));
    PenaltyChoice choice = choice_;
    choice.least_speed = least_speed(contact);
    const PenaltyContact fresh = make_penalty_contact(contact, contact_mobility(system, i), choice, 0, 0);
    if (!(force.z() > 0) || !(fresh.spring.stiffness > 0)) continue;
    const PenaltyContact spring = pressed_by(fresh, force, system.frames[i], contact.point.gap);
    ContactMemory& memory = memories.emplace_back(empty_memory(contact));
    remember(spring, memory);
    memory.energy = normal_energy(spring, contact.point.gap) + bristle_energy(contact, spring);
  }
}

}  // namespace rigor
