#pragma once

#include "rigor/contact/resting/resting.hpp"
#include "rigor/sim/method/method.hpp"

namespace rigor {

/// How the method solves for contact forces.
RestingChoice resting_choice(const Method& method);
/// Slower slip than this counts as sticking [m/s].
double slip_tolerance(const Method& method);
/// Contacts that part more slowly than this last, where forces are told of a State [m/s].
double parting_tolerance(const Method& method);
/// Slower slip than this keeps, within a step, the direction that it began with [m/s]: towards its end and
/// after its start the direction of u_t is the quotient of two numbers near zero, and slip runs straight
/// there.
double direction_tolerance(const Method& method);

}  // namespace rigor
