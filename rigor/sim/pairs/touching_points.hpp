#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/model/contact_key.hpp"
#include "rigor/model/state.hpp"

#include <vector>

namespace rigor {

enum class ContactMode;

/// A point where two bodies touch, as a picture shows it.
struct TouchingPoint {
  enum class Mode {
    open,     ///< Touches without a force: is about to part, or has just met.
    stick,    ///< Carries a force and does not slip.
    slide,    ///< Carries a force and slips.
    unknown,  ///< Its force is not known (NaN): it was not solved for, or is an impulse of a step.
  };
  int body_A, body_B;           ///< Model indices, body_A < body_B.
  Vec3 p_W = Vec3::Zero();      ///< [m].
  Vec3 n_W = Vec3::UnitZ();     ///< Unit normal from A to B.
  double gap = 0;               ///< [m], negative when overlapping.
  Vec3 force_W = Vec3::Zero();  ///< On B [N]: normal part along n_W, friction across it.
  Vec3 u_W = Vec3::Zero();      ///< Velocity of B against A at the point [m/s].
  Mode mode = Mode::open;
};

/// The force that a scheme found at a contact.
struct ContactForce {
  ContactKey key;
  Vec3 p_W;      ///< Where it was then [m].
  Vec3 force_W;  ///< On B [N]; NaN where the mode is unknown.
  TouchingPoint::Mode mode;
};

TouchingPoint::Mode mode_of(ContactMode mode);

/// All contacts of the State closer than the tolerance [m]; those of a pair in the order of shapes and
/// features.
std::vector<Contact> touching_contacts(const Model& model, const State& state, double tolerance);

/// The points of these contacts of the State in the order of their bodies, each with its force. A force
/// whose contact is not among them any more, because other features meet now, is that of the nearest point of
/// its pair of bodies; if the pair has none, it has parted.
std::vector<TouchingPoint> touching_points(const Model& model, const State& state,
                                           std::vector<Contact> contacts,
                                           const std::vector<ContactForce>& forces);

}  // namespace rigor
