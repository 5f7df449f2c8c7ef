// ODE on the reference scenes: first-order steps with a box-friction LCP.

#include "peer_cases.hpp"

#include <ode/ode.h>

#include <array>

namespace rigor::bench {

namespace {

struct OdeSettings {
  bool quick = false;      ///< dWorldQuickStep with 20 iterations instead of Dantzig's method.
  bool correction = true;  ///< ERP and CFM as shipped, or both 0.
};

class OdeWorld : public PeerWorld {
 public:
  OdeWorld(const PeerScene& scene, const OdeSettings& settings);
  ~OdeWorld() override;
  void step() override;
  Vec3 position(int body) const override { return vector_of(dBodyGetPosition(at(body))); }
  Vec3 velocity(int body) const override { return vector_of(dBodyGetLinearVel(at(body))); }
  Quat orientation(int body) const override {
    const dReal* q = dBodyGetQuaternion(at(body));
    return {q[0], q[1], q[2], q[3]};
  }

 private:
  static Vec3 vector_of(const dReal* v) { return {v[0], v[1], v[2]}; }
  dBodyID at(int body) const { return bodies_[static_cast<std::size_t>(body)]; }
  void add_body(const PeerBody& given);
  dGeomID shape_of(const PeerBody& given) const;
  void add_contacts(dGeomID a, dGeomID b);

  OdeSettings settings_;
  double step_, friction_, restitution_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  std::vector<dBodyID> bodies_;
};

OdeWorld::OdeWorld(const PeerScene& scene, const OdeSettings& settings)
    : settings_(settings), step_(scene.step), friction_(scene.friction), restitution_(scene.restitution) {
  dInitODE2(0);
  world_ = dWorldCreate();
  space_ = dHashSpaceCreate(nullptr);
  contacts_ = dJointGroupCreate(0);
  dWorldSetGravity(world_, scene.gravity.x(), scene.gravity.y(), scene.gravity.z());
  if (!settings.correction) {
    dWorldSetERP(world_, 0);
    dWorldSetCFM(world_, 0);
  }
  for (const PeerBody& body : scene.bodies) add_body(body);
  for (const PeerPlane& plane : scene.planes) {
    dCreatePlane(space_, plane.n.x(), plane.n.y(), plane.n.z(), plane.d);
  }
  for (const PeerWall& wall : scene.walls) {
    const dGeomID box = dCreateBox(space_, 2 * wall.half.x(), 2 * wall.half.y(), 2 * wall.half.z());
    dGeomSetPosition(box, wall.p.x(), wall.p.y(), wall.p.z());
  }
}

OdeWorld::~OdeWorld() {
  dJointGroupDestroy(contacts_);
  dSpaceDestroy(space_);
  dWorldDestroy(world_);
  dCloseODE();
}

void OdeWorld::add_body(const PeerBody& given) {
  const dBodyID body = dBodyCreate(world_);
  dMass mass;
  const Vec3& I = given.moments;
  dMassSetParameters(&mass, given.mass, 0, 0, 0, I.x(), I.y(), I.z(), 0, 0, 0);
  dBodySetMass(body, &mass);
  dBodySetPosition(body, given.p.x(), given.p.y(), given.p.z());
  dBodySetLinearVel(body, given.v.x(), given.v.y(), given.v.z());
  dBodySetAngularVel(body, given.w.x(), given.w.y(), given.w.z());
  bodies_.push_back(body);
  if (const dGeomID shape = shape_of(given)) dGeomSetBody(shape, body);
}

/// The body's shape in the space; nothing if it has none.
dGeomID OdeWorld::shape_of(const PeerBody& given) const {
  const Vec3& half = given.half;
  switch (given.shape) {
    case PeerBody::Shape::sphere:
      return dCreateSphere(space_, half.x());
    case PeerBody::Shape::box:
      return dCreateBox(space_, 2 * half.x(), 2 * half.y(), 2 * half.z());
    case PeerBody::Shape::capsule:
      return dCreateCapsule(space_, half.x(), 2 * half.z());
    case PeerBody::Shape::cylinder:
      return dCreateCylinder(space_, half.x(), 2 * half.z());
    case PeerBody::Shape::none:
      break;
  }
  return nullptr;
}

void OdeWorld::add_contacts(dGeomID a, dGeomID b) {
  const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
  if (body_a == nullptr && body_b == nullptr) return;
  std::array<dContactGeom, 16> points;
  const int count = dCollide(a, b, static_cast<int>(points.size()), points.data(), sizeof(dContactGeom));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    dContact contact{};
    contact.geom = points[i];
    contact.surface.mode = dContactApprox1 | (restitution_ > 0 ? dContactBounce : 0);
    contact.surface.mu = friction_;
    contact.surface.bounce = restitution_;
    dJointAttach(dJointCreateContact(world_, contacts_, &contact), body_a, body_b);
  }
}

void OdeWorld::step() {
  const auto near = [](void* self, dGeomID a, dGeomID b) {
    static_cast<OdeWorld*>(self)->add_contacts(a, b);
  };
  dSpaceCollide(space_, this, near);
  if (settings_.quick) {
    dWorldQuickStep(world_, step_);
  } else {
    dWorldStep(world_, step_);
  }
  dJointGroupEmpty(contacts_);
}

Peer make_peer(const std::string& name, const OdeSettings& settings) {
  return {name, [settings](const PeerScene& scene) { return std::make_unique<OdeWorld>(scene, settings); }};
}

}  // namespace

std::vector<Row> ode_rows() {
  const Peer shipped = make_peer("ODE dWorldStep {}", {});
  const Peer exact = make_peer("ODE dWorldStep {} ERP0", {.correction = false});
  const Peer quick = make_peer("ODE QuickStep {}", {.quick = true});
  const Peer quick_exact = make_peer("ODE QuickStep {} ERP0", {.quick = true, .correction = false});
  return {free_top(shipped, 1e-3), bounce(shipped, 1e-3),
          bounce(exact, 1e-3),     bounce(exact, 1e-4),
          block_sticks(shipped),   block_slides(shipped),
          block_sticks(quick),     block_slides(quick),
          slide_to_roll(shipped),  gas(quick),
          gas(quick_exact),        fast_ball(shipped)};
}

}  // namespace rigor::bench
