#pragma once

#include "bench.hpp"
#include "rigor/math/types.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rigor::bench {

/// A dynamic body; SI units, components in W.
struct PeerBody {
  enum class Shape { none, sphere, box, capsule, cylinder };
  Shape shape = Shape::none;
  /// Half edges of the box; the sphere's radius is half.x(). Capsules and cylinders, about their z axis, have
  /// the radius half.x() and the half length half.z(), of capsules without their caps.
  Vec3 half = Vec3::Zero();
  double mass = 1;
  Vec3 moments = Vec3::Ones();
  Vec3 p = Vec3::Zero();
  Quat q = Quat::Identity();  ///< Heaps alone begin with rotated bodies: of the other peers none reads it.
  Vec3 v = Vec3::Zero();
  Vec3 w = Vec3::Zero();
};

/// Fixed half-space n·x ≤ d.
struct PeerPlane {
  Vec3 n = Vec3::UnitZ();
  double d = 0;
};

struct PeerWall {
  Vec3 half;
  Vec3 p;
};

/// What every engine builds its own world from; one pair of coefficients for all contacts.
struct PeerScene {
  double step = 1e-3;
  Vec3 gravity = Vec3::Zero();
  double friction = 0;
  double restitution = 0;
  std::vector<PeerBody> bodies;
  std::vector<PeerPlane> planes;
  std::vector<PeerWall> walls;
};

class PeerWorld {
 public:
  PeerWorld() = default;
  PeerWorld(const PeerWorld&) = delete;
  PeerWorld& operator=(const PeerWorld&) = delete;
  virtual ~PeerWorld() = default;
  virtual void step() = 0;
  virtual Vec3 position(int body) const = 0;
  virtual Quat orientation(int body) const = 0;
  virtual Vec3 velocity(int body) const = 0;
};

/// An engine with its settings, and the name that the table shows, with {} for the step.
struct Peer {
  std::string name;
  std::function<std::unique_ptr<PeerWorld>(const PeerScene&)> make;
};

Row free_top(const Peer& peer, double step);
Row bounce(const Peer& peer, double step);
Row block_sticks(const Peer& peer);
Row block_slides(const Peer& peer);
Row slide_to_roll(const Peer& peer);
Row gas(const Peer& peer);
Row fast_ball(const Peer& peer);

}  // namespace rigor::bench
