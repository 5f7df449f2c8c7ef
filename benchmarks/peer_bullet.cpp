// Bullet (double precision) on the reference scenes: sequential impulses in semi-implicit steps.

#include "peer_cases.hpp"

#include <btBulletDynamicsCommon.h>

#include <cmath>

namespace rigor::bench {

namespace {

/// shipped: as it comes, without sleeping. tuned: 200 iterations, restitution at every speed, both friction
/// directions. elastic: tuned, and no position correction.
enum class BulletSettings { shipped, tuned, elastic };

btVector3 to_bullet(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
Vec3 from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

class BulletWorld : public PeerWorld {
 public:
  BulletWorld(const PeerScene& scene, BulletSettings settings);
  ~BulletWorld() override;
  void step() override { world_.stepSimulation(step_, 0); }
  Vec3 position(int body) const override { return from_bullet(at(body).getCenterOfMassPosition()); }
  Vec3 velocity(int body) const override { return from_bullet(at(body).getLinearVelocity()); }
  Quat orientation(int body) const override {
    const btQuaternion q = at(body).getOrientation();
    return {q.w(), q.x(), q.y(), q.z()};
  }

 private:
  const btRigidBody& at(int body) const { return *bodies_[static_cast<std::size_t>(body)]; }
  void tune(BulletSettings settings);
  btRigidBody& add(const PeerBody& given, std::unique_ptr<btCollisionShape> shape);

  double step_, friction_, restitution_;
  bool every_approach_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

std::unique_ptr<btCollisionShape> shape_of(const PeerBody& body) {
  switch (body.shape) {
    case PeerBody::Shape::sphere:
      return std::make_unique<btSphereShape>(body.half.x());
    case PeerBody::Shape::box:
      return std::make_unique<btBoxShape>(to_bullet(body.half));
    case PeerBody::Shape::capsule:
      return std::make_unique<btCapsuleShapeZ>(body.half.x(), 2 * body.half.z());
    case PeerBody::Shape::cylinder:
      return std::make_unique<btCylinderShapeZ>(to_bullet(body.half));
    case PeerBody::Shape::none:
      break;
  }
  return std::make_unique<btSphereShape>(1);
}

BulletWorld::BulletWorld(const PeerScene& scene, BulletSettings settings)
    : step_(scene.step),
      friction_(scene.friction),
      restitution_(scene.restitution),
      every_approach_(settings == BulletSettings::shipped || scene.restitution == 0) {
  world_.setGravity(to_bullet(scene.gravity));
  tune(settings);
  for (const PeerBody& body : scene.bodies) {
    btRigidBody& added = add(body, shape_of(body));
    added.setLinearVelocity(to_bullet(body.v));
    added.setAngularVelocity(to_bullet(body.w));
  }
  PeerBody fixed;
  fixed.mass = 0;
  for (const PeerPlane& plane : scene.planes) {
    add(fixed, std::make_unique<btStaticPlaneShape>(to_bullet(plane.n), plane.d));
  }
  for (const PeerWall& wall : scene.walls) {
    fixed.p = wall.p;
    add(fixed, std::make_unique<btBoxShape>(to_bullet(wall.half)));
  }
}

BulletWorld::~BulletWorld() {
  for (const std::unique_ptr<btRigidBody>& body : bodies_) world_.removeRigidBody(body.get());
}

void BulletWorld::tune(BulletSettings settings) {
  if (settings == BulletSettings::shipped) return;
  btContactSolverInfo& info = world_.getSolverInfo();
  info.m_numIterations = 200;
  info.m_restitutionVelocityThreshold = 0;
  info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  if (settings == BulletSettings::tuned) return;
  info.m_erp = 0;
  info.m_erp2 = 0;
  info.m_splitImpulse = 0;
}

/// A pair has the product of its bodies' coefficients.
btRigidBody& BulletWorld::add(const PeerBody& given, std::unique_ptr<btCollisionShape> shape) {
  const btVector3 moments = given.mass > 0 ? to_bullet(given.moments) : btVector3(0, 0, 0);
  btRigidBody::btRigidBodyConstructionInfo info(given.mass, nullptr, shape.get(), moments);
  info.m_startWorldTransform.setOrigin(to_bullet(given.p));
  info.m_friction = std::sqrt(friction_);
  info.m_restitution = std::sqrt(restitution_);
  bodies_.push_back(std::make_unique<btRigidBody>(info));
  shapes_.push_back(std::move(shape));
  btRigidBody& body = *bodies_.back();
  if (given.mass > 0) body.setActivationState(DISABLE_DEACTIVATION);
  if (!every_approach_) body.setContactProcessingThreshold(0);
  world_.addRigidBody(&body);
  return body;
}

Peer make_peer(const std::string& name, BulletSettings settings) {
  return {name,
          [settings](const PeerScene& scene) { return std::make_unique<BulletWorld>(scene, settings); }};
}

}  // namespace

std::vector<Row> bullet_rows() {
  const Peer shipped = make_peer("Bullet {}", BulletSettings::shipped);
  const Peer tuned = make_peer("Bullet {} (tuned)", BulletSettings::tuned);
  const Peer elastic = make_peer("Bullet {} (ERP0)", BulletSettings::elastic);
  return {free_top(shipped, 1e-3), bounce(shipped, 1e-3), bounce(elastic, 1e-3), bounce(elastic, 1e-4),
          block_sticks(shipped),   block_sticks(tuned),   block_slides(shipped), block_slides(tuned),
          slide_to_roll(shipped),  slide_to_roll(tuned),  gas(shipped),          gas(elastic),
          fast_ball(shipped)};
}

}  // namespace rigor::bench
