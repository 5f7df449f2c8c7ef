#include "rigor/contact/system/contact_system.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

int ContactSystem::local_index(int body) const {
  const auto place = std::lower_bound(bodies.begin(), bodies.end(), body);
  RIGOR_ASSERT(place != bodies.end() && *place == body);
  return static_cast<int>(place - bodies.begin());
}

namespace {

/// u = Cᵀ (v_B + ω_B × r_B - v_A - ω_A × r_A).
ContactJacobian rows_of_contact(const Contact& contact, const Mat3& C, const BodyKinetics& A,
                                const BodyKinetics& B) {
  ContactJacobian rows;
  rows.A.leftCols<3>() = -C.transpose();
  rows.A.rightCols<3>() = C.transpose() * skew(contact.p_W() - A.x);
  rows.B.leftCols<3>() = C.transpose();
  rows.B.rightCols<3>() = -C.transpose() * skew(contact.p_W() - B.x);
  return rows;
}

double mobility_along(const BodyKinetics& body, const Vec6& J) {
  return body.inverse_mass * J.head<3>().squaredNorm() + J.tail<3>().dot(body.inverse_inertia * J.tail<3>());
}

/// The rows of a joint's stop: its coordinate is the normal (limits) or the first tangent.
ContactJacobian rows_of_stop(const Model& model, const JointStop& stop, const ContactSystem& system) {
  const Joint& joint = model.joint(stop.joint);
  const JointAxis& axis = joint.axes[at(stop.axis)];
  const JointCoordinate coordinate =
      joint_coordinate(joint, stop.axis, motion_of(joint.body_A, system.bodies, system.kinetics),
                       motion_of(joint.body_B, system.bodies, system.kinetics));

  // Which of the three rows the coordinate is, and its sign.
  const bool is_bounded = stop.kind == JointStop::Kind::friction || stop.kind == JointStop::Kind::motor;
  const Eigen::Index row = is_bounded ? 0 : 2;
  const double sign = stop.kind == JointStop::Kind::upper ? -1 : 1;

  // The Jacobian of the coordinate.
  ContactJacobian rows;
  // Of a joint to the world the only body takes the side of B, or of A if it is A.
  if (joint.body_A != world_body) rows.A.row(row) = sign * coordinate.J_A.transpose();
  if (joint.body_B != world_body) rows.B.row(row) = sign * coordinate.J_B.transpose();
  rows.bias[row] = sign * coordinate.bias;

  // Dry friction and motors: the largest force, and a normal row that carries it.
  if (!is_bounded) return rows;
  const bool is_motor = stop.kind == JointStop::Kind::motor;
  rows.load = is_motor ? axis.motor->max_force : axis.friction;
  if (is_motor) rows.rate[0] = axis.motor->velocity;
  for (const auto& [body, J] :
       {std::pair{joint.body_A, coordinate.J_A}, std::pair{joint.body_B, coordinate.J_B}}) {
    if (body != world_body) rows.mobility += mobility_along(system.of(body), J);
  }
  return rows;
}

}  // namespace

ContactSystem make_contact_system(std::vector<Contact> contacts, std::vector<int> bodies,
                                  std::vector<BodyKinetics> kinetics) {
  ContactSystem system{std::move(contacts), std::move(bodies), std::move(kinetics), {}, {}, {}};
  RIGOR_ASSERT(system.bodies.size() == system.kinetics.size());
  for (const Contact& contact : system.contacts) {
    RIGOR_ASSERT(!contact.stop);
    system.frames.push_back(frame_with_z(contact.point.n_W));
    system.rows.push_back(
        rows_of_contact(contact, system.frames.back(), system.of(contact.body_A), system.of(contact.body_B)));
  }
  return system;
}

ContactSystem make_contact_system(const Model& model, std::vector<Contact> contacts, std::vector<int> bodies,
                                  std::vector<BodyKinetics> kinetics,
                                  std::shared_ptr<const JointSystem> joints) {
  ContactSystem system{std::move(contacts), std::move(bodies), std::move(kinetics), {}, {},
                       std::move(joints)};
  RIGOR_ASSERT(system.bodies.size() == system.kinetics.size());
  for (const Contact& contact : system.contacts) {
    system.frames.push_back(contact.stop ? Mat3::Identity() : frame_with_z(contact.point.n_W));
    system.rows.push_back(contact.stop
                              ? rows_of_stop(model, *contact.stop, system)
                              : rows_of_contact(contact, system.frames.back(), system.of(contact.body_A),
                                                system.of(contact.body_B)));
  }
  return system;
}

namespace {

struct Side {
  Eigen::Index contact;
  const Eigen::Matrix<double, 3, 6>* J;
};

/// For each body of the system the contacts that act on it.
std::vector<std::vector<Side>> sides_by_body(const ContactSystem& system) {
  std::vector<std::vector<Side>> sides(system.bodies.size());
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const Eigen::Index index = static_cast<Eigen::Index>(i);
    sides[at(system.local_index(contact.body_A))].push_back({index, &system.rows[i].A});
    sides[at(system.local_index(contact.body_B))].push_back({index, &system.rows[i].B});
  }
  return sides;
}

bool is_held(const ContactSystem& system, std::size_t body) {
  return system.joints && system.joints->holds(body);
}

/// M⁻¹ Jᵀ of a body without joints.
Eigen::Matrix<double, 6, 3> response(const BodyKinetics& body, const Eigen::Matrix<double, 3, 6>& J) {
  Eigen::Matrix<double, 6, 3> result;
  result.topRows<3>() = body.inverse_mass * J.leftCols<3>().transpose();
  result.bottomRows<3>() = body.inverse_inertia * J.rightCols<3>().transpose();
  return result;
}

/// Adds to A the response of the bodies that joints hold.
void add_held(const ContactSystem& system, const std::vector<std::vector<Side>>& sides, MatX& A) {
  const std::vector<std::size_t>& held = system.joints->held_bodies();
  // The contacts of held bodies.
  std::vector<Eigen::Index> touching;
  for (const std::size_t b : held) {
    for (const Side& side : sides[b]) touching.push_back(side.contact);
  }
  touching = sorted_unique(std::move(touching));
  if (touching.empty()) return;

  // J: one block per contact and held body.
  MatX J =
      MatX::Zero(3 * static_cast<Eigen::Index>(touching.size()), 6 * static_cast<Eigen::Index>(held.size()));
  for (std::size_t n = 0; n < held.size(); ++n) {
    for (const Side& side : sides[held[n]]) {
      const Eigen::Index i =
          std::lower_bound(touching.begin(), touching.end(), side.contact) - touching.begin();
      J.block<3, 6>(3 * i, 6 * static_cast<Eigen::Index>(n)) += *side.J;
    }
  }

  // A += J (M⁻¹ - M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁺ G M⁻¹) Jᵀ, of J the blocks that are there.
  count_work(held.size() * at(J.rows()));
  const MatX response = system.joints->respond(MatX(J.transpose()));
  for (std::size_t n = 0; n < held.size(); ++n) {
    for (const Side& side : sides[held[n]]) {
      const Eigen::Matrix<double, 3, Eigen::Dynamic> rates =
          side.J->lazyProduct(response.middleRows<6>(6 * static_cast<Eigen::Index>(n)));
      for (std::size_t k = 0; k < touching.size(); ++k)
        A.block<3, 3>(3 * side.contact, 3 * touching[k]) +=
            rates.middleCols<3>(3 * static_cast<Eigen::Index>(k));
    }
  }
}

}  // namespace

MatX delassus(const ContactSystem& system) {
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(system.contacts.size());
  MatX A = MatX::Zero(size, size);

  // A_ik = Σ J_i M⁻¹ J_kᵀ over the bodies that contacts i and k share: the lower triangle.
  const std::vector<std::vector<Side>> sides = sides_by_body(system);
  for (std::size_t b = 0; b < sides.size(); ++b) {
    const BodyKinetics& body = system.kinetics[b];
    if (body.inverse_mass == 0 || is_held(system, b)) continue;
    for (const Side& of_k : sides[b]) {
      const Eigen::Matrix<double, 6, 3> by_k = response(body, *of_k.J);
      for (const Side& of_i : sides[b]) {
        if (of_k.contact > of_i.contact) continue;
        A.block<3, 3>(3 * of_i.contact, 3 * of_k.contact) += *of_i.J * by_k;
      }
    }
  }

  // Bodies that joints hold respond together; loads have a mobility of their own.
  if (system.joints) add_held(system, sides, A);
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    const Eigen::Index normal = 3 * static_cast<Eigen::Index>(i) + 2;
    A(normal, normal) += system.rows[i].mobility;
  }
  // Exactly symmetric: the upper triangle is the lower one.
  A.triangularView<Eigen::StrictlyUpper>() = A.transpose();
  return A;
}

namespace {

Vec6 velocity(const BodyKinetics& body) {
  Vec6 V;
  V << body.v, body.w;
  return V;
}

}  // namespace

VecX relative_velocities(const ContactSystem& system) {
  VecX u(3 * static_cast<Eigen::Index>(system.contacts.size()));
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const BodyKinetics &A = system.of(contact.body_A), &B = system.of(contact.body_B);
    const ContactJacobian& rows = system.rows[i];
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    if (contact.stop) {
      u.segment<3>(row) = rows.A * velocity(A) + rows.B * velocity(B) - rows.rate;
    } else {
      const Vec3 p_W = contact.p_W();
      u.segment<3>(row) = system.frames[i].transpose() * (B.velocity_at(p_W) - A.velocity_at(p_W));
    }
  }
  return u;
}

Vec3 world_impulse(const ContactSystem& system, const VecX& lambda, int i) {
  return system.frames[at(i)] * lambda.segment<3>(3 * i);
}

std::vector<Wrench> contact_wrenches(const ContactSystem& system, const VecX& lambda) {
  std::vector<Wrench> wrenches(system.bodies.size());
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];

    // The bodies that the impulse acts on, with opposite signs.
    Wrench& on_A = wrenches[at(system.local_index(contact.body_A))];
    Wrench& on_B = wrenches[at(system.local_index(contact.body_B))];
    if (contact.stop) {
      const Vec3 own = lambda.segment<3>(3 * static_cast<Eigen::Index>(i));
      on_A.f_W += system.rows[i].A.leftCols<3>().transpose() * own;
      on_A.tau_W += system.rows[i].A.rightCols<3>().transpose() * own;
      on_B.f_W += system.rows[i].B.leftCols<3>().transpose() * own;
      on_B.tau_W += system.rows[i].B.rightCols<3>().transpose() * own;
      continue;
    }

    // The impulse in W, at its arm from each centre of mass.
    const Vec3 j_W = world_impulse(system, lambda, static_cast<int>(i));
    on_A.f_W -= j_W;
    on_A.tau_W -= (contact.p_W() - system.of(contact.body_A).x).cross(j_W);
    on_B.f_W += j_W;
    on_B.tau_W += (contact.p_W() - system.of(contact.body_B).x).cross(j_W);
  }
  return wrenches;
}

namespace {

std::vector<Vec6> stacked(const std::vector<Wrench>& wrenches) {
  std::vector<Vec6> result(wrenches.size());
  for (std::size_t b = 0; b < wrenches.size(); ++b) result[b] << wrenches[b].f_W, wrenches[b].tau_W;
  return result;
}

/// Forces with the gyroscopic torque -ω × I ω.
std::vector<Vec6> with_gyroscopic(const ContactSystem& system, const std::vector<Wrench>& wrenches) {
  std::vector<Vec6> f = stacked(wrenches);
  for (std::size_t b = 0; b < f.size(); ++b) {
    const BodyKinetics& body = system.kinetics[b];
    f[b].tail<3>() -= body.w.cross(body.inertia * body.w);
  }
  return f;
}

}  // namespace

void apply_impulses(const VecX& lambda, ContactSystem& system) {
  // Jᵀ λ on every body, and the response of those that joints hold.
  const std::vector<Wrench> impulses = contact_wrenches(system, lambda);
  std::vector<Vec6> of_held;
  if (system.joints)
    of_held = system.joints->respond(stacked(impulses), VecX::Zero(system.joints->residuals().size())).a;

  // V += M⁻¹ Jᵀ λ.
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    BodyKinetics& body = system.kinetics[b];
    if (is_held(system, b)) {
      body.v += of_held[b].head<3>();
      body.w += of_held[b].tail<3>();
    } else {
      body.v += body.inverse_mass * impulses[b].f_W;
      body.w += body.inverse_inertia * impulses[b].tau_W;
    }
  }
}

std::vector<Vec6> accelerations(const ContactSystem& system, const std::vector<Wrench>& wrenches) {
  // M a = f - ω × I ω + Gᵀ λ with G a = -bias, for the bodies that joints hold.
  const std::vector<Vec6> f = with_gyroscopic(system, wrenches);
  std::vector<Vec6> result(f.size());
  if (system.joints) result = system.joints->respond(f, -system.joints->biases()).a;

  // M a = f - ω × I ω for the others.
  for (std::size_t b = 0; b < f.size(); ++b) {
    if (is_held(system, b)) continue;
    result[b] << system.kinetics[b].inverse_mass * f[b].head<3>(),
        system.kinetics[b].inverse_inertia * f[b].tail<3>();
  }
  return result;
}

JointReactions with_joint_reactions(const ContactSystem& system, std::vector<Wrench> wrenches) {
  // The forces of the joints with which G a = -bias.
  const JointSystem::Response response =
      system.joints->respond(with_gyroscopic(system, wrenches), -system.joints->biases());

  // The sum of all wrenches on a held body, from its acceleration: f = m a, τ = I α + ω × I ω.
  for (const std::size_t b : system.joints->held_bodies()) {
    const BodyKinetics& body = system.kinetics[b];
    wrenches[b].f_W = response.a[b].head<3>() / body.inverse_mass;
    wrenches[b].tau_W = body.inertia * response.a[b].tail<3>() + body.w.cross(body.inertia * body.w);
  }
  return {std::move(wrenches), response.lambda};
}

JointReactions with_joint_impulses(const ContactSystem& system, std::vector<Wrench> impulses,
                                   const VecX& change) {
  // The impulses of the joints with which G ΔV = change.
  const JointSystem::Response response = system.joints->respond(stacked(impulses), change);

  // The sum of all impulses on a held body, from its change of velocity: f = m Δv, τ = I Δω.
  for (const std::size_t b : system.joints->held_bodies()) {
    const BodyKinetics& body = system.kinetics[b];
    impulses[b] = {response.a[b].head<3>() / body.inverse_mass, body.inertia * response.a[b].tail<3>()};
  }
  return {std::move(impulses), response.lambda};
}

Wrench external_wrench(const ContactSystem& system, const VecX& lambda, const VecX& joint_lambda) {
  Wrench sum;
  const auto add = [&](std::size_t body, const Vec6& wrench) {
    sum.f_W += wrench.head<3>();
    sum.tau_W += wrench.tail<3>() + system.kinetics[body].x.cross(wrench.head<3>());
  };

  // Contacts between dynamic bodies cancel; of the others the dynamic side counts.
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const std::size_t a = at(system.local_index(contact.body_A));
    const std::size_t b = at(system.local_index(contact.body_B));
    const bool is_A = system.kinetics[a].inverse_mass > 0, is_B = system.kinetics[b].inverse_mass > 0;
    if (a != b && is_A && is_B) continue;
    const Vec3 own = lambda.segment<3>(3 * static_cast<Eigen::Index>(i));
    if (is_A) add(a, system.rows[i].A.transpose() * own);
    if (is_B) add(b, system.rows[i].B.transpose() * own);
  }

  // Joints to prescribed bodies and the world.
  if (!system.joints) return sum;
  const std::vector<Vec6> of_joints = system.joints->external_wrenches(joint_lambda);
  for (std::size_t b = 0; b < of_joints.size(); ++b) add(b, of_joints[b]);
  return sum;
}

double kinetic_energy(const ContactSystem& system) {
  double energy = 0;
  for (const BodyKinetics& body : system.kinetics) {
    if (body.inverse_mass == 0) continue;
    energy += 0.5 * body.v.squaredNorm() / body.inverse_mass + 0.5 * body.w.dot(body.inertia * body.w);
  }
  return energy;
}

double work_of_prescribed(const ContactSystem& system, const VecX& lambda) {
  double work = 0;
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const ContactJacobian& rows = system.rows[i];
    const Vec3 own = lambda.segment<3>(3 * static_cast<Eigen::Index>(i));
    const BodyKinetics& A = system.of(contact.body_A);
    const BodyKinetics& B = system.of(contact.body_B);

    // λ · velocity of each prescribed side.
    if (A.inverse_mass == 0) work -= own.dot(rows.A * velocity(A));
    if (B.inverse_mass == 0) work -= own.dot(rows.B * velocity(B));
  }
  return work;
}

}  // namespace rigor
