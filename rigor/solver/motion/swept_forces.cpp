#include "rigor/solver/motion/swept_forces.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/solver/linear/two_doubles.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace rigor {

using Eigen::Index;

namespace {

/// A contact with what its forces do to its bodies.
struct SweptContact {
  struct Side {
    Index node;                            ///< Place of its six numbers.
    Eigen::Matrix<double, 4, 6> J;         ///< By columns, with a row of zeros: two numbers at a time.
    Eigen::Matrix<double, 6, 3> response;  ///< M⁻¹ Jᵀ.
  };
  std::array<Side, 2> sides;
  int side_count = 0;
  double normal = 0, tangent = 0;  ///< 1 / A_nn and 1 / the trace of A_tt; 0 where nothing gives way.
};

SweptContact swept_contact(const ContactRows& rows, const ContactRows::Sides& sides) {
  SweptContact contact;
  Mat3 A = Mat3::Zero();
  for (const ContactRows::Side& side : sides) {
    if (side.node < 0 || contact.side_count == 2) continue;
    SweptContact::Side& own = contact.sides[at(contact.side_count++)];
    own.node = 6 * static_cast<Index>(side.node);
    own.J.topRows<3>() = side.J;
    own.J.row(3).setZero();
    own.response = rows.inverse_masses[at(side.node)] * side.J.transpose();
    A += side.J * own.response;
  }
  if (A(2, 2) > 0) contact.normal = 1 / A(2, 2);
  if (A(0, 0) + A(1, 1) > 0) contact.tangent = 1 / (A(0, 0) + A(1, 1));
  return contact;
}

/// w_n += the normal row of J V, to the last bit as add_rates() does it.
void add_normal_rate(const SweptContact::Side& side, const VecX& V, double& w_n) {
  const double *J = side.J.data() + 2, *v = V.data() + side.node;
  for (int c = 0; c < 6; ++c, J += 4) w_n += v[c] * *J;
}

/// w += J V.
void add_rates(const SweptContact::Side& side, const VecX& V, Vec3& w) {
  const double *J = side.J.data(), *v = V.data() + side.node;
  TwoDoubles tangents = two_of(w.data()), normal{w(2), 0};
  for (int c = 0; c < 6; ++c, J += 4) {
    tangents += v[c] * two_of(J);
    normal += v[c] * two_of(J + 2);
  }
  put_two(tangents, w.data());
  w(2) = normal[0];
}

/// V += M⁻¹ Jᵀ change.
void add_response(const SweptContact::Side& side, const Vec3& change, VecX& V) {
  const double* response = side.response.data();
  double* v = V.data() + side.node;
  for (int c = 0; c < 6; c += 2) {
    const TwoDoubles gained = change(0) * two_of(response + c) +
                              (change(1) * two_of(response + 6 + c) + change(2) * two_of(response + 12 + c));
    put_two(two_of(v + c) + gained, v + c);
  }
}

}  // namespace

VecX swept_forces(const MotionProblem& problem, int sweeps) {
  const CoulombProblem& laws = problem.laws;
  std::vector<SweptContact> contacts;
  contacts.reserve(laws.mu.size());
  for (const ContactRows::Sides& sides : problem.rows.contacts)
    contacts.push_back(swept_contact(problem.rows, sides));
  VecX lambda = VecX::Zero(laws.b.size());
  VecX V = VecX::Zero(6 * static_cast<Index>(problem.rows.node_count()));

  for (int sweep = 0; sweep < sweeps; ++sweep) {
    count_work(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const SweptContact& contact = contacts[i];
      Vec3 w = laws.b.segment<3>(3 * static_cast<Index>(i));
      auto own = lambda.segment<3>(3 * static_cast<Index>(i));
      // Half of the contacts of a heap are open, and stay so whatever their slips.
      if (own(2) == 0) {
        double w_n = w(2);
        for (int s = 0; s < contact.side_count; ++s) add_normal_rate(contact.sides[at(s)], V, w_n);
        if (w_n >= 0) continue;
      }
      // The rates as they are.
      for (int s = 0; s < contact.side_count; ++s) add_rates(contact.sides[at(s)], V, w);

      // The forces that they ask for, in their cone.
      Vec3 force(own(0) - contact.tangent * w(0), own(1) - contact.tangent * w(1),
                 std::max(0.0, own(2) - contact.normal * w(2)));
      const double length = force.head<2>().norm(), most = laws.mu[i] * force(2);
      if (length > most) force.head<2>() *= most / length;

      // What they change.
      const Vec3 change = force - own;
      if (change.isZero(0)) continue;
      own = force;
      for (int s = 0; s < contact.side_count; ++s) add_response(contact.sides[at(s)], change, V);
    }
  }
  return lambda;
}

}  // namespace rigor
