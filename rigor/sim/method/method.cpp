#include "rigor/sim/method/method.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rigor {

namespace {

/// Position of the value among all values of its key, which is the number of its enumerator.
std::optional<int> value_index(std::string_view key, std::string_view value) {
  int index = 0;
  for (const MethodChoice& choice : method_choices()) {
    if (choice.key != key) continue;
    if (choice.value == value) return index;
    ++index;
  }
  return std::nullopt;
}

/// Calls f with the member that holds the choice of the key; false for an unknown key.
template <typename MethodType, typename F>
bool visit_choice(MethodType& method, std::string_view key, F f) {
  if (key == "scheme") return f(method.scheme), true;
  if (key == "integrator") return f(method.integrator), true;
  if (key == "orientation") return f(method.orientation), true;
  if (key == "broad_phase") return f(method.broad_phase), true;
  if (key == "distance") return f(method.distance), true;
  if (key == "toi") return f(method.toi), true;
  if (key == "impact") return f(method.impact), true;
  if (key == "simultaneous") return f(method.simultaneous), true;
  if (key == "resting") return f(method.resting), true;
  if (key == "lcp") return f(method.lcp), true;
  if (key == "micro_collisions") return f(method.micro_collisions), true;
  if (key == "penalty") return f(method.penalty), true;
  if (key == "penalty_law") return f(method.penalty_law), true;
  if (key == "solver") return f(method.solver), true;
  if (key == "cone") return f(method.cone), true;
  if (key == "last_resort") return f(method.last_resort), true;
  if (key == "sleeping") return f(method.sleeping), true;
  return false;
}

/// Choices that would change nothing, though who makes them wants to see what they do.
void check_collision_choices(const Method& method, std::vector<std::string>& messages) {
  const bool is_open = method.scheme == Scheme::automatic;
  const std::string scheme = "scheme '" + method_choice(method, "scheme") + "'";
  if (method.micro_collisions == MicroCollisionMethod::plain && !is_open &&
      method.scheme != Scheme::impulse_based) {
    messages.push_back("micro_collisions 'plain' does not go with " + scheme +
                       ", which has none; schemes that do: impulse-based");
  }
  const bool is_projection =
      method.simultaneous == SimultaneousLaw::projection || method.simultaneous == SimultaneousLaw::moreau;
  if (!is_projection) return;
  const std::string law = "simultaneous '" + method_choice(method, "simultaneous") + "'";
  if (method.scheme == Scheme::penalty || method.scheme == Scheme::impulse_based) {
    messages.push_back(law + " does not go with " + scheme +
                       ", which never solves several impacts together; schemes that do: event-driven, "
                       "time-stepping, hybrid");
  }
  if (method.scheme == Scheme::time_stepping && method.solver == SolverMethod::substep) {
    messages.push_back(law +
                       " does not go with solver 'substep', whose contacts are soft; solvers that do: "
                       "exact, pgs");
  }
}

}  // namespace

std::span<const MethodNumber> method_numbers() {
  static const std::array<MethodNumber, 9> numbers = {{
      {"contact_tolerance",
       "m",
       "1e-6",
       {1e-15, 1e6},
       "pairs closer than this touch",
       &Method::contact_tolerance},
      {"time_tolerance",
       "s",
       "1e-12",
       {1e-18, 1},
       "width of the interval around a time of impact",
       &Method::time_tolerance},
      {"resting_velocity",
       "m/s",
       "1e-3",
       {0, 1e6},
       "slower approaches do not bounce",
       &Method::resting_velocity},
      {"tolerance",
       "",
       "1e-10",
       {1e-14, 0.1},
       "relative local error of dopri5 and dop853",
       &Method::tolerance},
      {"penalty_depth",
       "m",
       "1e-4",
       {1e-12, 1e3},
       "depth to which an impact compresses a penalty contact",
       &Method::penalty_depth},
      {"stiffness",
       "N/m",
       "0",
       {0, 1e15},
       "of penalty contacts; 0: from `penalty_depth`",
       &Method::stiffness},
      {"damping",
       "N s/m",
       "0",
       {0, 1e15},
       "of penalty contacts; 0: from the pair's restitution",
       &Method::damping},
      {"substeps",
       "",
       "0",
       {0, 1e6},
       "per step: least number for the penalty scheme, number for solver substep; 0: 1 or 6",
       &Method::substeps},
      {"iterations",
       "",
       "50",
       {1, 1e6},
       "sweeps of `solver: pgs` in each contact problem",
       &Method::iterations},
  }};
  return numbers;
}

std::vector<std::string> method_choice_keys() {
  std::vector<std::string> keys;
  for (const MethodChoice& choice : method_choices()) {
    if (keys.empty() || keys.back() != choice.key) keys.emplace_back(choice.key);
  }
  return keys;
}

std::vector<std::string> method_values(std::string_view key) {
  std::vector<std::string> values;
  for (const MethodChoice& choice : method_choices()) {
    if (choice.key == key) values.emplace_back(choice.value);
  }
  return values;
}

std::string set_method_choice(std::string_view key, std::string_view value, Method& method) {
  const std::optional<int> index = value_index(key, value);
  if (!index) {
    const std::vector<std::string> values = method_values(key);
    if (values.empty()) return "unknown choice " + quoted_text(key) + suggestion(key, method_choice_keys());
    return "unknown " + std::string(key) + " " + quoted_text(value) + suggestion(value, values);
  }
  visit_choice(method, key,
               [&](auto& choice) { choice = static_cast<std::decay_t<decltype(choice)>>(*index); });
  return {};
}

std::string method_choice(const Method& method, std::string_view key) {
  std::size_t index = 0;
  if (!visit_choice(method, key, [&](const auto& choice) { index = at(choice); })) return {};
  // Asked for every run of a study: the list of all values is not made for it.
  for (const MethodChoice& choice : method_choices()) {
    if (choice.key == key && index-- == 0) return std::string(choice.value);
  }
  return {};
}

std::string scheme_name(Scheme scheme) {
  Method method;
  method.scheme = scheme;
  return method_choice(method, "scheme");
}

std::vector<std::string> check_combination(const Method& method) {
  std::vector<std::string> messages;
  const bool is_on_group =
      method.integrator == IntegratorMethod::exact || method.integrator == IntegratorMethod::lie_rk4;
  if (method.orientation == OrientationForm::matrix && is_on_group) {
    messages.push_back(
        "orientation 'matrix' does not go with integrator '" + method_choice(method, "integrator") +
        "', which integrates quaternions; integrators that do: euler, semi-implicit-euler, midpoint, rk4, "
        "dopri5, dop853");
  }
  if (method.scheme == Scheme::penalty) {
    const bool is_local = method.penalty == PenaltyMethod::local;
    const bool is_known = method.integrator == IntegratorMethod::exact ||
                          (is_local && method.integrator == IntegratorMethod::semi_implicit_euler);
    if (!is_known) {
      std::string message = "scheme 'penalty' with penalty '";
      message += method_choice(method, "penalty");
      message += "' does not go with integrator '";
      message += method_choice(method, "integrator");
      message += "'; integrators that do: exact";
      if (is_local) message += ", semi-implicit-euler";
      messages.push_back(message);
    } else if (method.orientation == OrientationForm::matrix && !is_on_group) {
      std::string message = "scheme 'penalty' integrates quaternions; it does not go with";
      message += " orientation 'matrix'";
      messages.push_back(message);
    }
  }
  if (method.iterations != std::floor(method.iterations))
    messages.push_back("iterations is " + number_text(method.iterations) + ", must be a whole number");
  if (method.solver != SolverMethod::exact && method.cone != ConeMethod::exact) {
    messages.push_back("solver '" + method_choice(method, "solver") + "' does not go with cone '" +
                       method_choice(method, "cone") + "'; cones that do: exact");
  }
  check_collision_choices(method, messages);
  return messages;
}

}  // namespace rigor
