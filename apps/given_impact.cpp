#include "apps/given_impact.hpp"

#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/contact/system/collision_matrix.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/range.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr double most_friction = 1e9;
/// Bound that keeps all products of the given numbers in the range of doubles.
constexpr double most_velocity = 1e30, most_mobility = 1e30, least_mobility = 1e-30;

std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

/// Numbers separated by commas, none of them beyond `most`. Throws UsageError.
std::vector<double> parse_list(const std::string& option, const std::string& text, double most) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    const std::optional<double> number = number_of(part);
    if (!number) {
      throw UsageError(
          fmt::format("{} {}: {} is not a number", option, quoted_text(text), quoted_text(part)));
    }
    const std::string wrong = range_error("a value", *number, {-most, most}, "");
    if (!wrong.empty()) throw UsageError(fmt::format("{} {}: {}", option, quoted_text(text), wrong));
    numbers.push_back(*number);
    at = end + 1;
  }
  return numbers;
}

Mat3 parse_matrix(const std::string& text) {
  const std::vector<double> k = parse_list("--K", text, most_mobility);
  Mat3 K;
  if (k.size() == 6) {
    K << k[0], k[1], k[2], k[1], k[3], k[4], k[2], k[4], k[5];
  } else if (k.size() == 9) {
    K << k[0], k[1], k[2], k[3], k[4], k[5], k[6], k[7], k[8];
  } else {
    throw UsageError(
        fmt::format("--K: {} numbers, must be 6 (K11,K12,K13,K22,K23,K33) or 9 (row by row)", k.size()));
  }
  const std::string wrong = check_collision_matrix(K);
  if (!wrong.empty()) throw UsageError("--K: " + wrong);
  if (K(2, 2) < least_mobility) {
    throw UsageError(
        fmt::format("--K: K[2][2] is {:g}, must be at least {:g} 1/kg", K(2, 2), least_mobility));
  }
  return 0.5 * (K + K.transpose());
}

Vec3 parse_velocity(const std::string& text) {
  const std::vector<double> u = parse_list("--u", text, most_velocity);
  if (u.size() != 3) throw UsageError(fmt::format("--u: {} numbers, must be 3 (X,Y,Z)", u.size()));
  return Vec3::Map(u.data());
}

/// Whether a scene is given; throws UsageError if neither a scene nor numbers are given, or both.
bool is_of_scene(const ImpactOptions& options) {
  const bool has_numbers = !options.K.empty() || !options.u.empty();
  if (options.scene.empty()) {
    if (options.K.empty() || options.u.empty())
      throw UsageError("give either --K and --u, or SCENE BODY_A BODY_B");
    if (options.mu.empty() || options.e.empty()) throw UsageError("--K and --u need --mu and --e");
    if (options.contact || options.tolerance || !options.overrides.empty())
      throw UsageError("--contact, --tolerance and --set need a scene");
    return false;
  }
  if (has_numbers) throw UsageError("a scene and --K or --u do not go together: the scene has them");
  if (options.body_A.empty() || options.body_B.empty())
    throw UsageError("SCENE needs the names of two bodies: rigor impact SCENE BODY_A BODY_B");
  return true;
}

int find_body(const Model& model, const std::string& name) {
  if (const std::optional<int> body = model.find_body(name)) return *body;
  std::vector<std::string> names;
  for (const Body& body : model.bodies()) names.push_back(body.name);
  throw UsageError(fmt::format("the scene has no body {}{}", quoted_text(name), suggestion(name, names)));
}

BodyKinetics kinetics_at_start(const Model& model, const State& state, int body) {
  if (model.body(body).motion != MotionType::dynamic) return prescribed_kinetics(model.body(body), state.t);
  return dynamic_kinetics(model.body(body), {state.position(body), state.orientation(body),
                                             state.linear_momentum(body), state.angular_momentum(body)});
}

std::string point_list(const std::vector<Contact>& contacts) {
  constexpr std::size_t most_listed = 12;
  std::string list;
  for (std::size_t k = 0; k < std::min(contacts.size(), most_listed); ++k) {
    const Vec3 p = contacts[k].p_W();
    list += fmt::format("{}{} at [{:.6g}, {:.6g}, {:.6g}] m", k == 0 ? "" : ", ", k + 1, p.x(), p.y(), p.z());
  }
  return contacts.size() > most_listed ? list + ", ..." : list;
}

/// The selected contact; throws UsageError if the selection is ambiguous.
std::size_t choose_contact(const std::vector<Contact>& contacts, const std::optional<int>& wanted,
                           const std::string& pair) {
  if (!wanted && contacts.size() == 1) return 0;
  if (!wanted) {
    throw UsageError(fmt::format("{} touch at {} points; choose one with --contact N: {}", pair,
                                 contacts.size(), point_list(contacts)));
  }
  if (static_cast<std::size_t>(*wanted) > contacts.size()) {
    throw UsageError(fmt::format("--contact {}: {} touch at {} point{}: {}", *wanted, pair, contacts.size(),
                                 contacts.size() == 1 ? "" : "s", point_list(contacts)));
  }
  return static_cast<std::size_t>(*wanted - 1);
}

/// Throws InputError for a body without shapes.
void check_shapes(const Body& A, const Body& B) {
  for (const Body* body : {&A, &B}) {
    if (body->shapes.empty()) throw InputError(fmt::format("body {} has no shapes", quoted_text(body->name)));
  }
}

std::vector<Contact> touching_points(const Model& model, int a, int b,
                                     const std::array<BodyKinetics, 2>& kinetics, double tolerance) {
  std::vector<Contact> contacts =
      find_contacts(model, a, b, kinetics[0].pose(), kinetics[1].pose(), tolerance);
  const std::string pair =
      fmt::format("bodies {} and {}", quoted_text(model.body(a).name), quoted_text(model.body(b).name));
  if (contacts.empty()) {
    throw InputError(
        fmt::format("{} do not touch at t = 0: they are farther apart than {:g} m (--tolerance); "
                    "'rigor distance' tells how far",
                    pair, tolerance));
  }
  for (const Contact& contact : contacts) {
    if (contact.point.gap < -tolerance) {
      throw InputError(fmt::format("{} overlap at t = 0 by {:g} m, at most {:g} m is allowed (--tolerance)",
                                   pair, -contact.point.gap, tolerance));
    }
  }
  return contacts;
}

GivenImpact problem_of_scene(const ImpactOptions& options) {
  const Scene scene = read_scene(options.scene, options.overrides);
  for (const std::string& warning : scene.warnings) print_warning(warning);
  const Model& model = *scene.model;
  const int a = find_body(model, options.body_A), b = find_body(model, options.body_B);
  if (a == b) throw UsageError("BODY_A and BODY_B are the same body; give two");
  if (model.body(a).motion != MotionType::dynamic && model.body(b).motion != MotionType::dynamic)
    throw InputError("neither of the two bodies is dynamic: an impact changes nothing");
  check_shapes(model.body(a), model.body(b));
  const State state = make_initial_state(model);
  const std::array<BodyKinetics, 2> kinetics = {kinetics_at_start(model, state, a),
                                                kinetics_at_start(model, state, b)};
  const double tolerance = options.tolerance.value_or(scene.method.contact_tolerance);
  const std::vector<Contact> contacts = touching_points(model, a, b, kinetics, tolerance);
  const std::string pair =
      fmt::format("bodies {} and {}", quoted_text(options.body_A), quoted_text(options.body_B));
  const std::size_t chosen = choose_contact(contacts, options.contact, pair);

  std::vector<int> bodies = {a, b};
  std::vector<BodyKinetics> of_bodies(kinetics.begin(), kinetics.end());
  if (a > b) std::swap(bodies[0], bodies[1]), std::swap(of_bodies[0], of_bodies[1]);
  const Contact& contact = contacts[chosen];
  SceneContact of_scene{{options.body_A, options.body_B},
                        static_cast<int>(chosen) + 1,
                        static_cast<int>(contacts.size()),
                        make_contact_system({contact}, bodies, of_bodies)};
  const Mat3 K = delassus(of_scene.system);
  const Vec3 u = relative_velocities(of_scene.system);
  return {{{K, contact.friction}, u, contact.restitution}, std::move(of_scene)};
}

}  // namespace

double parse_number(const std::string& option, const std::string& text, double lowest, double highest,
                    bool may_be_infinite) {
  if (may_be_infinite && text == "inf") return std::numeric_limits<double>::infinity();
  const std::optional<double> number = number_of(text);
  if (!number) {
    throw UsageError(
        fmt::format("{}: {} is not a number{}", option, quoted_text(text), may_be_infinite ? " or inf" : ""));
  }
  const std::string wrong = range_error(option, *number, {lowest, highest}, "");
  if (!wrong.empty()) throw UsageError(wrong + (may_be_infinite ? ", or inf" : ""));
  return *number;
}

GivenImpact read_given_impact(const ImpactOptions& options) {
  // Options are checked first, so that an invalid one is reported without reading a scene.
  const bool has_scene = is_of_scene(options);
  std::optional<double> mu, e;
  if (!options.mu.empty()) mu = parse_number("--mu", options.mu, 0, most_friction, true);
  if (!options.e.empty()) e = parse_number("--e", options.e, 0, 1);
  GivenImpact problem = has_scene
                            ? problem_of_scene(options)
                            : GivenImpact{{{parse_matrix(options.K), 0}, parse_velocity(options.u), 0}, {}};
  if (mu) problem.collision.matrix.mu = *mu;
  if (e) problem.collision.restitution = *e;
  return problem;
}

}  // namespace rigor
