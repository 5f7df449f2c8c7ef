#include "rigor/model/state_check.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/model/limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace rigor {

namespace {

constexpr std::size_t phase_numbers = 13;  // x 3, q 4, P 3, L 3.
constexpr std::size_t impulses_of_joint = 6;
constexpr double unit_tolerance = 1e-4;  // of |q|², far above what 32 bits round

/// Whether all numbers are finite, and their squares too: energies are sums of squares.
bool have_squares(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v * v); });
}

template <typename Values>
bool are_finite(const Values& values) {
  return std::all_of(values.begin(), values.end(), [](auto v) { return std::isfinite(v); });
}

std::string of_body(const Model& model, int body) {
  return "body " + quoted_text(model.body(body).name) + ": its ";
}

/// x, q, P and L of a body at one instant.
std::string phase_error(std::span<const double> x, std::span<const double> q, std::span<const double> P,
                        std::span<const double> L) {
  if (!have_squares(x)) return "position is not finite";
  if (!have_squares(q)) return "orientation is not finite";
  if (!have_squares(P)) return "momentum is not finite";
  if (!have_squares(L)) return "angular momentum is not finite";
  double square = 0;
  for (const double part : q) square += part * part;
  if (std::abs(square - 1) > unit_tolerance) return "orientation is not a unit quaternion";
  return {};
}

std::string body_error(const Model& model, const State& state, int body) {
  const std::size_t i = at(body);
  // The phase at t, and the one at the anchor.
  const std::span x(state.x), q(state.q), P(state.P), L(state.L), anchor(state.anchor);
  if (const std::string error =
          phase_error(x.subspan(3 * i, 3), q.subspan(4 * i, 4), P.subspan(3 * i, 3), L.subspan(3 * i, 3));
      !error.empty())
    return of_body(model, body) + error;
  const std::span own = anchor.subspan(phase_numbers * i, phase_numbers);
  if (const std::string error =
          phase_error(own.subspan(0, 3), own.subspan(3, 4), own.subspan(7, 3), own.subspan(10, 3));
      !error.empty())
    return of_body(model, body) + "anchor's " + error;

  // Anchors lie in the past.
  if (!(state.epoch[i] >= 0 && state.epoch[i] <= state.t))
    return of_body(model, body) + "anchor is not between 0 and the State's time";
  const bool has_momentum = !state.linear_momentum(body).isZero(0) || !state.angular_momentum(body).isZero(0);
  if (model.body(body).motion != MotionType::dynamic && has_momentum)
    return of_body(model, body) + "momentum is not 0, though its motion is prescribed";
  return {};
}

bool is_body(const Model& model, int body) {
  return body >= 0 && body < model.body_count();
}

/// Whether the indices name shapes of two different bodies.
bool are_shapes(const Model& model, const ContactKey& key) {
  const auto is_shape = [&](int body, int shape) {
    return is_body(model, body) && shape >= 0 && at(shape) < model.body(body).shapes.size();
  };
  return key.body_A != key.body_B && is_shape(key.body_A, key.shape_A) && is_shape(key.body_B, key.shape_B);
}

/// A stop of a joint has negative numbers instead of shapes, and may be fastened to the world.
bool is_stop(const Model& model, const ContactMemory& contact) {
  const auto is_side = [&](int body) { return body == world_body || is_body(model, body); };
  return contact.shape_A < 0 && contact.shape_B < 0 && is_side(contact.body_A) && is_side(contact.body_B);
}

std::string contact_error(const Model& model, const State& state) {
  for (const ContactMemory& contact : state.contacts) {
    if (!are_shapes(model, contact.key()) && !is_stop(model, contact))
      return "a remembered contact is between shapes that do not exist";
    if (!have_squares(contact.values) || !std::isfinite(contact.energy))
      return "a remembered contact holds a number that is not finite";
  }
  for (const ContactMemory& contact : state.events.contacts) {
    if (!are_shapes(model, contact.key())) return "a contact that lasts is between shapes that do not exist";
    if (!have_squares(contact.values) || contact.energy != 0)
      return "a contact that lasts holds a number that is not finite, or energy";
    const double mode = contact.values[EventMemory::mode];
    if (!(mode >= 0 && mode < EventMemory::mode_count && mode == std::floor(mode)))
      return "a contact that lasts has a mode that does not exist";
  }
  for (const ManifoldMemory& manifold : state.manifolds) {
    if (!are_shapes(model, manifold.key()))
      return "a remembered manifold is between shapes that do not exist";
    if (manifold.part < 0 || manifold.point_count < 0 || manifold.point_count > ManifoldMemory::max_points)
      return "a remembered manifold has a number of points or parts that cannot be";
    if (!are_finite(manifold.normal_impulse) || !are_finite(manifold.friction_impulse_W) ||
        !are_finite(manifold.rolling_impulse_W) || !std::isfinite(manifold.twist_impulse) ||
        !std::isfinite(manifold.energy))
      return "a remembered manifold holds an impulse that is not finite";
  }
  return {};
}

/// Lists that some schemes keep for all bodies or joints, and others not at all.
std::string list_error(const Model& model, const State& state) {
  const std::size_t n = at(model.body_count());
  if (!state.quiet_time.empty() && state.quiet_time.size() != n)
    return "it has " + std::to_string(state.quiet_time.size()) + " quiet times for " + std::to_string(n) +
           " bodies";
  if (!state.joint_impulses.empty() &&
      state.joint_impulses.size() != impulses_of_joint * model.joints().size())
    return "it has " + std::to_string(state.joint_impulses.size()) + " joint impulses for " +
           std::to_string(model.joints().size()) + " joints";
  if (!are_finite(state.joint_impulses)) return "a joint impulse is not finite";
  // Infinite for bodies that sleep.
  if (!std::all_of(state.quiet_time.begin(), state.quiet_time.end(), [](float t) { return t >= 0; }))
    return "a quiet time is not a time";
  return {};
}

}  // namespace

std::string state_error(const Model& model, const State& state) {
  if (state.body_count() != model.body_count())
    return "it has " + std::to_string(state.body_count()) + " bodies, and the scene has " +
           std::to_string(model.body_count());
  if (!(state.t >= 0 && state.t <= limits::time.highest)) return "its time is " + number_text(state.t) + " s";
  for (int body = 0; body < model.body_count(); ++body) {
    if (std::string error = body_error(model, state, body); !error.empty()) return error;
  }
  if (std::string error = list_error(model, state); !error.empty()) return error;
  constexpr double most_work = 1e18;
  for (const double effort : {state.handover.owed, state.handover.price, state.handover.owed_by_steps}) {
    if (!(effort >= 0 && effort <= most_work))
      return "the work that it remembers is negative or beyond any run";
  }
  const bool is_soft = state.handover.carrier == HandoverMemory::Carrier::soft_steps;
  if (!(state.handover.soft_step >= 0 && state.handover.soft_step <= limits::time.highest &&
        is_soft == (state.handover.soft_step > 0)))
    return "the length of its soft steps is " + number_text(state.handover.soft_step) + " s";
  return contact_error(model, state);
}

}  // namespace rigor
