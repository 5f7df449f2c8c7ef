#include "rigor/sim/time_stepping/implicit_springs.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace rigor {

using Eigen::Index;

namespace {

/// The line of a spring: its unit direction from A to B, and its length [m].
struct Line {
  Vec3 direction;
  double length;
};

Line line_of(const Vec3& p_WA, const Vec3& p_WB) {
  const Vec3 d = p_WB - p_WA;
  const double length = d.norm();
  return {length > 0 ? Vec3(d / length) : Vec3(Vec3::Zero()), length};
}

/// Change of the velocity of an end along the line per unit impulse along it [1/kg].
double mobility_of(const BodyKinetics& body, const Vec3& p_W, const Vec3& direction) {
  const Vec3 moment = (p_W - body.x).cross(direction);
  return body.inverse_mass + moment.dot(body.inverse_inertia * moment);
}

}  // namespace

ImplicitSprings::ImplicitSprings(const Model& model) : model_(model) {
  for (const Force& force : model.forces()) {
    if (const Spring* spring = std::get_if<Spring>(&force)) springs_.push_back(spring);
  }
}

std::vector<const Spring*> ImplicitSprings::springs_of(const std::vector<int>& bodies) const {
  std::vector<const Spring*> result;
  std::copy_if(springs_.begin(), springs_.end(), std::back_inserter(result), [&](const Spring* spring) {
    return std::binary_search(bodies.begin(), bodies.end(), spring->body_A) ||
           std::binary_search(bodies.begin(), bodies.end(), spring->body_B);
  });
  return result;
}

BodyKinetics ImplicitSprings::end_body(int body, double t, const ContactSystem& system) const {
  if (body == world_body) return {};
  const bool is_dynamic = model_.body(body).motion == MotionType::dynamic;
  return is_dynamic ? system.of(body) : prescribed_kinetics(model_.body(body), t);
}

bool ImplicitSprings::are_stiff(const StepSpan& span, const std::vector<int>& bodies,
                                const ContactSystem& begin) const {
  // A period of ninety steps, which the midpoint rule makes half a thousandth too long.
  constexpr double stiff = 5e-3, bearable_across = 0.5;
  bool is_any_stiff = false;
  for (const Spring* const spring : springs_of(bodies)) {
    // The line of the spring at the beginning, and the mobility of its ends along it.
    const BodyKinetics A = end_body(spring->body_A, span.t, begin),
                       B = end_body(spring->body_B, span.t, begin);
    const Vec3 p_WA = A.x + A.R * spring->p_AP, p_WB = B.x + B.R * spring->p_BQ;
    const auto [direction, length] = line_of(p_WA, p_WB);
    if (length == 0) return false;
    const double mobility = mobility_of(A, p_WA, direction) + mobility_of(B, p_WB, direction);
    // Its force turns the line: across the line it acts as a stiffness f/l, which the rows do not have.
    const double force = spring->stiffness * std::abs(length - spring->length);
    if (span.h * span.h * force / length * mobility > bearable_across) return false;
    // h² k + h c, in units of the mass that moves.
    is_any_stiff |= span.h * (span.h * spring->stiffness + spring->damping) * mobility > stiff;
  }
  return is_any_stiff;
}

/// With the rate u of the length and the stretch s at the beginning, the force is
///   f = -k (s + θ h ((1 - θ) u + θ u⁺)) - c ((1 - θ) u + θ u⁺)
/// and ν = h f: for θ = ½ the implicit midpoint rule, for θ = 1 the implicit Euler method.
SpringRows ImplicitSprings::rows(const StepSpan& span, const std::vector<int>& bodies,
                                 const ContactSystem& begin, const ContactSystem& middle) const {
  const double h = span.h, theta = span.theta, half = span.t + 0.5 * h;
  const std::vector<const Spring*> springs = springs_of(bodies);
  SpringRows rows;
  rows.softness = rows.drive = rows.rates = VecX::Zero(static_cast<Index>(springs.size()));
  for (const Spring* const spring : springs) {
    const Index i = static_cast<Index>(rows.count());

    // Ends of the spring half way through the step, and at its beginning.
    const BodyKinetics A = end_body(spring->body_A, half, middle), B = end_body(spring->body_B, half, middle);
    const BodyKinetics A_begin = end_body(spring->body_A, span.t, begin),
                       B_begin = end_body(spring->body_B, span.t, begin);
    const Vec3 p_WA = A.x + A.R * spring->p_AP, p_WB = B.x + B.R * spring->p_BQ;
    // Stretch at the beginning, and its rate with the arms half way: there the mean of the rates over the
    // step is the change of the length.
    const auto rate_of = [](const BodyKinetics& moving, const BodyKinetics& placed, const Vec3& p_W) {
      return Vec3(moving.v + moving.w.cross(p_W - placed.x));
    };
    const Vec3 begin_A = A_begin.x + A_begin.R * spring->p_AP, begin_B = B_begin.x + B_begin.R * spring->p_BQ;
    const Vec3 line = line_of(p_WA, p_WB).direction;
    const double stretch = (begin_B - begin_A).norm() - spring->length;
    const double rate = line.dot(rate_of(B_begin, B, p_WB) - rate_of(A_begin, A, p_WA));

    // The row along the line, with its rate at the end of the step without springs and contacts.
    rows.ends_A.push_back({spring->body_A, p_WA, A.velocity_at(p_WA)});
    rows.ends_B.push_back({spring->body_B, p_WB, B.velocity_at(p_WB)});
    rows.lines.push_back(line);
    rows.rates(i) = line.dot(rows.ends_B.back().v_W - rows.ends_A.back().v_W);

    // Softness and drive: ν = h f, the mean force, solved for u⁺.
    const double answer = theta * h * spring->stiffness + spring->damping;
    if (!(answer > 0)) {
      // A spring without stiffness and damping: ν = 0.
      rows.lines.back().setZero();
      rows.rates(i) = 0;
      rows.softness(i) = 1;
      continue;
    }
    rows.softness(i) = 1 / (h * theta * answer);
    rows.drive(i) = (spring->stiffness * stretch + answer * (1 - theta) * rate) / (theta * answer);
  }
  return rows;
}

OutsideImpulse add_spring_impulses(const SpringRows& rows, const VecX& nu, const ContactSystem& system,
                                   std::vector<Wrench>& impulses) {
  OutsideImpulse outside;
  const auto push = [&](const SpringRows::End& end, const Vec3& j_W) {
    const bool is_listed = std::binary_search(system.bodies.begin(), system.bodies.end(), end.body);
    if (is_listed && system.of(end.body).inverse_mass > 0) {
      Wrench& wrench = impulses[at(system.local_index(end.body))];
      wrench.f_W += j_W;
      wrench.tau_W += (end.p_W - system.of(end.body).x).cross(j_W);
    } else {
      outside.impulse.f_W -= j_W;
      outside.impulse.tau_W -= end.p_W.cross(j_W);
      outside.work -= j_W.dot(end.v_W);
    }
  };
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const Vec3 j_W = nu(static_cast<Index>(i)) * rows.lines[i];
    push(rows.ends_A[i], -j_W);
    push(rows.ends_B[i], j_W);
  }
  return outside;
}

}  // namespace rigor
