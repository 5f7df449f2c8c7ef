// Bullet on the scenes of many bodies: its world made of the Model, with its own defaults (sequential
// impulses, 10 iterations, margins of 4 cm about hulls), but never sleeping.

#include "bulk_engines.hpp"

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/rotation.hpp"

#include <btBulletDynamicsCommon.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace rigor::bench {

namespace {

btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
Vec3 from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
btQuaternion to_bullet(const Quat& q) {
  return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
          static_cast<btScalar>(q.w())};
}
btTransform to_bullet(const Pose& X) {
  return btTransform(to_bullet(quaternion_of(X.R)), to_bullet(X.p));
}

class BulletBulkEngine : public BulkEngine {
 public:
  explicit BulletBulkEngine(std::shared_ptr<const Model> model);
  ~BulletBulkEngine() override;
  void step(double h) override;
  State state() const override;

 private:
  btRigidBody& at(int body) const { return *bodies_[static_cast<std::size_t>(body)]; }
  btCollisionShape* shape_of(const Shape& shape);
  btCollisionShape* shape_of(const Mesh& mesh);
  btCollisionShape* shape_of(const Body& body);
  void add_body(const Body& body);
  void add_joint(const Joint& joint);

  std::shared_ptr<const Model> model_;
  State start_;
  double t_ = 0;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  /// Equal shapes are one: type, numbers.
  std::map<std::array<double, 4>, btCollisionShape*> equal_shapes_;
  std::map<const void*, btCollisionShape*> shared_shapes_;  ///< Of hulls and meshes.
  std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

BulletBulkEngine::BulletBulkEngine(std::shared_ptr<const Model> model)
    : model_(std::move(model)), start_(make_initial_state(*model_)) {
  world_.setGravity(to_bullet(model_->g_W()));
  for (const Body& body : model_->bodies()) add_body(body);
  for (const Joint& joint : model_->joints()) add_joint(joint);
}

BulletBulkEngine::~BulletBulkEngine() {
  for (const std::unique_ptr<btTypedConstraint>& joint : joints_) world_.removeConstraint(joint.get());
  for (const std::unique_ptr<btRigidBody>& body : bodies_) world_.removeRigidBody(body.get());
}

std::unique_ptr<btCollisionShape> new_shape(const Shape& shape) {
  if (const Sphere* sphere = std::get_if<Sphere>(&shape)) {
    return std::make_unique<btSphereShape>(static_cast<btScalar>(sphere->radius));
  }
  if (const Box* box = std::get_if<Box>(&shape)) {
    return std::make_unique<btBoxShape>(to_bullet(box->half_extents));
  }
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) {
    return std::make_unique<btCapsuleShapeZ>(static_cast<btScalar>(capsule->radius),
                                             static_cast<btScalar>(2 * capsule->half_length));
  }
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    return std::make_unique<btCylinderShapeZ>(
        to_bullet(Vec3(cylinder->radius, cylinder->radius, cylinder->half_length)));
  }
  if (const Cone* cone = std::get_if<Cone>(&shape)) {
    return std::make_unique<btConeShapeZ>(static_cast<btScalar>(cone->radius),
                                          static_cast<btScalar>(2 * cone->half_length));
  }
  if (const Ellipsoid* ellipsoid = std::get_if<Ellipsoid>(&shape)) {
    // Bullet's ellipsoids are balls that are scaled along the axes.
    const btVector3 center(0, 0, 0);
    const btScalar radius = 1;
    std::unique_ptr<btMultiSphereShape> ball = std::make_unique<btMultiSphereShape>(&center, &radius, 1);
    ball->setLocalScaling(to_bullet(ellipsoid->radii));
    return ball;
  }
  std::unique_ptr<btConvexHullShape> hull = std::make_unique<btConvexHullShape>();
  for (const Vec3& vertex : std::get<Convex>(shape).hull->vertices) hull->addPoint(to_bullet(vertex), false);
  hull->recalcLocalAabb();
  return hull;
}

/// Only of bodies that stand still.
btCollisionShape* BulletBulkEngine::shape_of(const Mesh& mesh) {
  btCollisionShape*& found = shared_shapes_[mesh.mesh.get()];
  if (found != nullptr) return found;
  meshes_.push_back(std::make_unique<btTriangleMesh>());
  for (const std::array<int, 3>& triangle : mesh.mesh->triangles) {
    const auto corner = [&](std::size_t k) {
      return to_bullet(mesh.mesh->vertices[static_cast<std::size_t>(triangle[k])]);
    };
    meshes_.back()->addTriangle(corner(0), corner(1), corner(2));
  }
  shapes_.push_back(std::make_unique<btBvhTriangleMeshShape>(meshes_.back().get(), true));
  return found = shapes_.back().get();
}

btCollisionShape* BulletBulkEngine::shape_of(const Shape& shape) {
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) return shape_of(*mesh);
  std::array<double, 4> key = {static_cast<double>(shape.index()), 0, 0, 0};
  if (const Sphere* sphere = std::get_if<Sphere>(&shape)) key[1] = sphere->radius;
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) {
    key[1] = capsule->radius;
    key[2] = capsule->half_length;
  }
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    key[1] = cylinder->radius;
    key[2] = cylinder->half_length;
  }
  if (const Cone* cone = std::get_if<Cone>(&shape)) {
    key[1] = cone->radius;
    key[2] = cone->half_length;
  }
  if (const Ellipsoid* ellipsoid = std::get_if<Ellipsoid>(&shape)) {
    for (std::size_t k = 0; k < 3; ++k) key[k + 1] = ellipsoid->radii[static_cast<Eigen::Index>(k)];
  }
  if (const Box* box = std::get_if<Box>(&shape)) {
    for (std::size_t k = 0; k < 3; ++k) key[k + 1] = box->half_extents[static_cast<Eigen::Index>(k)];
  }
  const Convex* convex = std::get_if<Convex>(&shape);
  btCollisionShape*& found = convex ? shared_shapes_[convex->hull.get()] : equal_shapes_[key];
  if (!found) {
    shapes_.push_back(new_shape(shape));
    found = shapes_.back().get();
  }
  return found;
}

/// In the body frame B. Shapes that are not at its origin, and several of them, make a compound.
btCollisionShape* BulletBulkEngine::shape_of(const Body& body) {
  const Pose& first = body.shapes.front().X_BS;
  if (body.shapes.size() == 1 && first.R.isIdentity(0) && first.p.isZero(0)) {
    return shape_of(body.shapes.front().shape);
  }
  std::unique_ptr<btCompoundShape> compound = std::make_unique<btCompoundShape>();
  for (const BodyShape& part : body.shapes) {
    compound->addChildShape(to_bullet(part.X_BS), shape_of(part.shape));
  }
  shapes_.push_back(std::move(compound));
  return shapes_.back().get();
}

/// A pair has the product of its bodies' coefficients.
void BulletBulkEngine::add_body(const Body& body) {
  const Material& material = model_->materials()[static_cast<std::size_t>(body.shapes.front().material)];
  const bool is_dynamic = body.motion == MotionType::dynamic;
  btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(body.mass), nullptr, shape_of(body),
                                                to_bullet(body.moments));
  info.m_startWorldTransform = btTransform(to_bullet(body.q_WB), to_bullet(body.p_WB));
  info.m_friction = static_cast<btScalar>(std::sqrt(material.friction));
  info.m_restitution = static_cast<btScalar>(std::sqrt(material.restitution));
  bodies_.push_back(std::make_unique<btRigidBody>(info));
  btRigidBody& added = *bodies_.back();
  if (body.motion != MotionType::fixed) added.setActivationState(DISABLE_DEACTIVATION);
  if (is_dynamic) {
    added.setLinearVelocity(to_bullet(body.v_WB));
    added.setAngularVelocity(to_bullet(body.w_WB));
  }
  if (body.motion == MotionType::kinematic) {
    added.setCollisionFlags(added.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  }
  world_.addRigidBody(&added);
}

/// Ball joints and hinges with limits; their bodies do not collide.
void BulletBulkEngine::add_joint(const Joint& joint) {
  if (joint.type == JointType::hinge) {
    std::unique_ptr<btHingeConstraint> hinge = std::make_unique<btHingeConstraint>(
        at(joint.body_A), at(joint.body_B), to_bullet(joint.X_AF), to_bullet(joint.X_BK));
    // Bullet counts the angle the other way round.
    if (!joint.axes.empty() && joint.axes[0].is_limited())
      hinge->setLimit(static_cast<btScalar>(-joint.axes[0].upper),
                      static_cast<btScalar>(-joint.axes[0].lower));
    joints_.push_back(std::move(hinge));
  } else {
    joints_.push_back(std::make_unique<btPoint2PointConstraint>(
        at(joint.body_A), at(joint.body_B), to_bullet(joint.X_AF.p), to_bullet(joint.X_BK.p)));
  }
  world_.addConstraint(joints_.back().get(), true);
}

/// Bullet finds the velocity of a kinematic body from the poses that it is given.
void BulletBulkEngine::step(double h) {
  t_ += h;
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    if (body.motion != MotionType::kinematic) continue;
    const PrescribedMotion motion = prescribed_motion(body, t_);
    at(i).setWorldTransform(btTransform(to_bullet(motion.q_WB), to_bullet(motion.p_WB)));
  }
  world_.stepSimulation(static_cast<btScalar>(h), 0);
}

State BulletBulkEngine::state() const {
  State state = start_;
  state.t = t_;
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    const btTransform& X_WB = at(i).getWorldTransform();
    const btQuaternion turn = X_WB.getRotation();
    const Quat q_WB = Quat(turn.w(), turn.x(), turn.y(), turn.z()).normalized();
    Vec3 P = Vec3::Zero(), L = Vec3::Zero();
    if (body.motion == MotionType::dynamic) {
      const Vec3 w_B = q_WB.conjugate() * from_bullet(at(i).getAngularVelocity());
      P = body.mass * from_bullet(at(i).getLinearVelocity());
      L = q_WB * Vec3(body.moments.cwiseProduct(w_B));
    }
    state.set_body(i, from_bullet(X_WB.getOrigin()), q_WB, P, L);
  }
  return state;
}

}  // namespace

std::unique_ptr<BulkEngine> make_bullet_engine(std::shared_ptr<const Model> model) {
  return std::make_unique<BulletBulkEngine>(std::move(model));
}

}  // namespace rigor::bench
