#include "rigor/model/carried_state.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/force.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <type_traits>

namespace rigor {

namespace {

/// Whether a phase means the same for both bodies.
bool has_same_inertia(const Body& a, const Body& b) {
  return a.motion == b.motion && a.mass == b.mass && a.moments == b.moments && a.X_BU.R == b.X_BU.R &&
         a.X_BU.p == b.X_BU.p;
}

/// Whether contacts mean the same too; shapes are compared by type, size and pose only.
bool has_same_shapes(const Body& a, const Body& b) {
  return std::equal(a.shapes.begin(), a.shapes.end(), b.shapes.begin(), b.shapes.end(),
                    [](const BodyShape& s, const BodyShape& t) {
                      return s.shape.index() == t.shape.index() && s.radius == t.radius &&
                             s.X_BS.R == t.X_BS.R && s.X_BS.p == t.X_BS.p;
                    });
}

/// Copies the `width` numbers of a body to its place in the new State.
void copy_bits(const std::vector<double>& from, int old_body, std::size_t width, int body,
               std::vector<double>& to) {
  std::copy_n(&from[width * at(old_body)], width, &to[width * at(body)]);
}

/// For each body of the new model its index in the old one (-1: it is new), and the inverse.
struct BodyMap {
  std::vector<int> old_of, new_of;
  std::vector<bool> is_same;  ///< For new indices: the body is unchanged, with its shapes.
};

BodyMap map_bodies(const Model& now, const Model& next) {
  BodyMap map{std::vector<int>(next.bodies().size(), -1), std::vector<int>(now.bodies().size(), -1),
              std::vector<bool>(next.bodies().size(), false)};
  for (int i = 0; i < next.body_count(); ++i) {
    // Most keep their index, or are shifted by removed bodies before them.
    const int guess = i == 0 ? 0 : map.old_of[at(i - 1)] + 1;
    const bool is_guess = guess < now.body_count() && now.body(guess).name == next.body(i).name;
    const int old = is_guess ? guess : now.find_body(next.body(i).name).value_or(-1);
    if (old < 0) continue;
    map.old_of[at(i)] = old;
    map.new_of[at(old)] = i;
    map.is_same[at(i)] =
        has_same_inertia(now.body(old), next.body(i)) && has_same_shapes(now.body(old), next.body(i));
  }
  return map;
}

void carry_body(const Model& now, const State& state, int old, const Model& next, int body, State& carried) {
  const Body &from = now.body(old), &to = next.body(body);
  if (has_same_inertia(from, to)) {
    copy_bits(state.x, old, 3, body, carried.x);
    copy_bits(state.q, old, 4, body, carried.q);
    copy_bits(state.P, old, 3, body, carried.P);
    copy_bits(state.L, old, 3, body, carried.L);
    copy_bits(state.epoch, old, 1, body, carried.epoch);
    copy_bits(state.anchor, old, 13, body, carried.anchor);
    return;
  }
  // The user's frame stays where it is; the centre of mass and the principal axes may be others in it.
  const Pose X_WU = Pose{rotation_matrix(state.orientation(old)), state.position(old)} * from.X_BU;
  const Pose X_WB = X_WU * to.X_BU.inverse();
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();
  if (to.motion == MotionType::dynamic) {
    const Vec3 w = angular_velocity(now, state, old);
    // The motion goes on, so that momenta are those of the new mass at the new centre.
    const Vec3 v = linear_velocity(now, state, old) + w.cross(X_WB.p - state.position(old));
    P = to.mass * v;
    L = X_WB.R * to.moments.cwiseProduct(X_WB.R.transpose() * w);
  }
  carried.set_body(body, X_WB.p, quaternion_of(X_WB.R), P, L);
}

/// The contacts between unchanged bodies whose order is unchanged, sorted by key. Bodies that lose a contact
/// wake.
template <class Memories>
Memories carry_contacts(const Memories& contacts, const BodyMap& map, State& carried) {
  using Memory = std::decay_t<decltype(*contacts.begin())>;
  std::vector<Memory> kept;
  for (const Memory& contact : contacts) {
    const int a = map.new_of[at(contact.body_A)], b = map.new_of[at(contact.body_B)];
    // What was remembered is of a contact between two bodies in this order, with their features.
    const bool continues = a >= 0 && b >= 0 && a < b && map.is_same[at(a)] && map.is_same[at(b)];
    if (continues) {
      kept.push_back(contact);
      kept.back().body_A = a;
      kept.back().body_B = b;
    } else if (!carried.quiet_time.empty()) {
      for (const int body : {a, b}) {
        if (body >= 0) carried.quiet_time[at(body)] = 0;
      }
    }
  }
  const auto is_before = [](const Memory& x, const Memory& y) { return x.key() < y.key(); };
  if (!std::is_sorted(kept.begin(), kept.end(), is_before)) std::sort(kept.begin(), kept.end(), is_before);
  return kept;
}

/// Whether the surroundings wake no body: gravity, joints, kinematic and fixed bodies are the same, and there
/// are no forces.
bool has_same_surroundings(const Model& now, const Model& next, const BodyMap& map) {
  if (now.g_W() != next.g_W() || !now.forces().empty() || !next.forces().empty()) return false;
  for (int i = 0; i < next.body_count(); ++i) {
    if (next.body(i).motion != MotionType::dynamic && !map.is_same[at(i)]) return false;
  }
  return std::equal(now.joints().begin(), now.joints().end(), next.joints().begin(), next.joints().end(),
                    [&](const Joint& a, const Joint& b) {
                      const auto is_same = [&](int old, int body) {
                        return old == world_body ? body == world_body
                                                 : body != world_body && map.new_of[at(old)] == body;
                      };
                      return a.name == b.name && is_same(a.body_A, b.body_A) && is_same(a.body_B, b.body_B);
                    });
}

std::vector<float> carry_joint_impulses(const Model& now, const std::vector<float>& impulses,
                                        const Model& next) {
  constexpr std::size_t width = 6;
  std::vector<float> carried(width * next.joints().size(), 0);
  std::map<std::string_view, std::size_t> number_of;
  // Joints are the same if name and type are; others begin without impulses.
  for (std::size_t i = 0; i < now.joints().size(); ++i) number_of[now.joints()[i].name] = i;
  for (std::size_t i = 0; i < next.joints().size(); ++i) {
    const auto old = number_of.find(next.joints()[i].name);
    if (old == number_of.end() || now.joints()[old->second].type != next.joints()[i].type) continue;
    std::copy_n(&impulses[width * old->second], width, &carried[width * i]);
  }
  return carried;
}

}  // namespace

State carried_state(const Model& now, const State& state, const Model& next) {
  const BodyMap map = map_bodies(now, next);
  State carried = make_initial_state(next);
  carried.t = state.t;
  for (int i = 0; i < next.body_count(); ++i) {
    carried.anchor_body(i);
    if (next.body(i).motion != MotionType::kinematic) continue;
    const PrescribedMotion motion = prescribed_motion(next.body(i), state.t);
    carried.set_body(i, motion.p_WB, motion.q_WB, Vec3::Zero(), Vec3::Zero());
  }
  if (!state.quiet_time.empty()) carried.quiet_time.assign(next.bodies().size(), 0);
  // Bodies sleep on only where nothing about them has changed.
  const bool stay_asleep = !state.quiet_time.empty() && has_same_surroundings(now, next, map);
  for (int i = 0; i < next.body_count(); ++i) {
    const int old = map.old_of[at(i)];
    if (old < 0) continue;
    carry_body(now, state, old, next, i, carried);
    if (map.is_same[at(i)] && stay_asleep) carried.quiet_time[at(i)] = state.quiet_time[at(old)];
  }
  carried.contacts = carry_contacts(state.contacts, map, carried);
  carried.manifolds = carry_contacts(state.manifolds, map, carried);
  if (state.joint_impulses.size() == 6 * now.joints().size() && !now.joints().empty())
    carried.joint_impulses = carry_joint_impulses(now, state.joint_impulses, next);
  return carried;
}

}  // namespace rigor
