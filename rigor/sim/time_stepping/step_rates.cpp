#include "rigor/sim/time_stepping/step_rates.hpp"

#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace rigor {

namespace {

using Rotations = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// The point nearest to `wanted` in the span of the columns. Those of which others leave less than a share do
/// not count: Gram and Schmidt's method, the longest remaining column first, its rest made orthogonal twice.
VecX nearest_in_span(Rotations columns, const VecX& wanted) {
  constexpr double dependent = 1e-9;
  const double least = dependent * columns.colwise().norm().maxCoeff();
  VecX nearest = VecX::Zero(wanted.size());
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    Eigen::Index longest = 0;
    const double length = columns.rightCols(columns.cols() - k).colwise().norm().maxCoeff(&longest);
    if (!(length > least)) break;
    if (longest > 0) columns.col(k).swap(columns.col(k + longest));

    // The unit column, and what is left of the later ones.
    for (Eigen::Index i = 0; i < k; ++i)
      columns.col(k) -= columns.col(i).dot(columns.col(k)) * columns.col(i);
    columns.col(k).normalize();
    for (Eigen::Index i = k + 1; i < columns.cols(); ++i)
      columns.col(i) -= columns.col(k).dot(columns.col(i)) * columns.col(k);
    nearest += columns.col(k).dot(wanted) * columns.col(k);
  }
  return nearest;
}

/// Replaces the accelerations at several contacts of one pair of bodies by the nearest that a rigid motion
/// can have. The difference is of second order, and contacts that hold could not all obey it.
void make_rigid(const ContactSystem& system, const std::vector<std::size_t>& contacts, VecX& accelerations) {
  // Centre of the contacts, and their largest distance from it as the unit of length.
  Vec3 centre = Vec3::Zero();
  for (const std::size_t i : contacts)
    centre += system.contacts[i].p_W() / static_cast<double>(contacts.size());
  double radius = 0;
  for (const std::size_t i : contacts) radius = std::max(radius, (system.contacts[i].p_W() - centre).norm());
  if (!(radius > 0)) radius = 1;

  // Least squares: accelerations at the contacts of all rigid motions, against those wanted. Rotations about
  // the centre are square to translations, whose nearest is the mean.
  Rotations rotations(3 * static_cast<Eigen::Index>(contacts.size()), 3);
  VecX wanted(rotations.rows());
  Vec3 mean = Vec3::Zero();
  for (Eigen::Index k = 0; 3 * k < wanted.size(); ++k) {
    const std::size_t i = contacts[static_cast<std::size_t>(k)];
    rotations.middleRows<3>(3 * k) = -skew((system.contacts[i].p_W() - centre) / radius);
    wanted.segment<3>(3 * k) = system.frames[i] * accelerations.segment<3>(normal_row(i) - 2);
    mean += wanted.segment<3>(3 * k) / static_cast<double>(contacts.size());
  }
  for (Eigen::Index k = 0; 3 * k < wanted.size(); ++k) wanted.segment<3>(3 * k) -= mean;

  // The nearest of them, in the frames of the contacts.
  const VecX turning = nearest_in_span(std::move(rotations), wanted);
  for (Eigen::Index k = 0; 3 * k < wanted.size(); ++k) {
    const std::size_t i = contacts[static_cast<std::size_t>(k)];
    accelerations.segment<3>(normal_row(i) - 2) =
        system.frames[i].transpose() * (mean + turning.segment<3>(3 * k));
  }
}

/// Whether the geometry of the contact goes round much faster than the bodies rotate, such as that of two
/// edges that become parallel, or of a rim that comes to lie flat: over half a step its rate then says
/// nothing.
bool turns_over(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B, double h) {
  constexpr double small_angle = 0.1, much = 4;
  const double rate = feature_rate(contact, A, B);
  return 0.5 * h * rate > small_angle && rate > much * (A.w.norm() + B.w.norm());
}

}  // namespace

VecX velocity_biases(const ContactSystem& system, double h) {
  VecX biases(3 * static_cast<Eigen::Index>(system.contacts.size()));
  std::map<std::pair<int, int>, std::vector<std::size_t>> pairs;
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    Vec3 bias = system.rows[i].bias;
    if (!contact.stop) {
      const BodyKinetics &A = system.of(contact.body_A), &B = system.of(contact.body_B);
      bias = turns_over(contact, A, B, h) ? Vec3(Vec3::Zero()) : acceleration_bias(contact, A, B);
    }
    biases.segment<3>(normal_row(i) - 2) = bias;
    if (!contact.stop) pairs[{contact.body_A, contact.body_B}].push_back(i);
  }
  for (const auto& [pair, contacts] : pairs) {
    if (contacts.size() > 1) make_rigid(system, contacts, biases);
  }
  return biases;
}

VecX closing_rates(const std::vector<Contact>& contacts, const ContactSystem& system, double h,
                   double resolution) {
  // g⁺/h of each contact.
  VecX rates = VecX::Zero(3 * static_cast<Eigen::Index>(contacts.size()));
  std::map<std::pair<int, int>, std::vector<std::size_t>> pairs;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].is_bounded_force()) continue;
    rates[normal_row(i)] = std::max(0.0, contacts[i].point.gap) / h;
    if (!contacts[i].stop) pairs[{contacts[i].body_A, contacts[i].body_B}].push_back(i);
  }

  // As one rigid motion closes them, where that is near.
  for (const auto& [pair, of_pair] : pairs) {
    const bool is_apart =
        std::any_of(of_pair.begin(), of_pair.end(), [&](std::size_t i) { return rates[normal_row(i)] > 0; });
    if (of_pair.size() < 2 || !is_apart) continue;
    std::vector<Vec3> given;
    for (const std::size_t i : of_pair) given.emplace_back(rates.segment<3>(normal_row(i) - 2));
    make_rigid(system, of_pair, rates);
    double largest = 0;
    for (std::size_t k = 0; k < given.size(); ++k) {
      const Vec3 change = rates.segment<3>(normal_row(of_pair[k]) - 2) - given[k];
      largest = std::max(largest, change.cwiseAbs().maxCoeff());
    }
    if (largest <= resolution) continue;
    for (std::size_t k = 0; k < given.size(); ++k) rates.segment<3>(normal_row(of_pair[k]) - 2) = given[k];
  }
  return rates;
}

}  // namespace rigor
