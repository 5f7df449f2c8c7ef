#include "binding.hpp"
#include "signals.hpp"

#include <rigor/io/trajectory/audit_json.hpp>
#include <rigor/io/trajectory/trajectory_writer.hpp>

namespace rigor::python {

namespace {

BodyHandle body_of(const Simulation& simulation, const py::handle& given) {
  if (py::isinstance<py::str>(given)) return simulation.body(text_of(given));
  if (!PyIndex_Check(given.ptr())) throw py::type_error("a body is its name or its index");
  return {index_of(given)};
}

JointHandle joint_of(const Simulation& simulation, const py::handle& given) {
  if (py::isinstance<py::str>(given)) return simulation.joint(text_of(given));
  if (!PyIndex_Check(given.ptr())) throw py::type_error("a joint is its name or its index");
  return {index_of(given)};
}

template <int columns>
py::array rows(const py::object& self, const Rows<columns>& (Simulation::*read)() const) {
  const Rows<columns>& table = (py::cast<Simulation&>(self).*read)();
  return view(table.data(), {table.rows(), columns}, self);
}

const char* mode_name(TouchingPoint::Mode mode) {
  switch (mode) {
    case TouchingPoint::Mode::open:
      return "open";
    case TouchingPoint::Mode::stick:
      return "stick";
    case TouchingPoint::Mode::slide:
      return "slide";
    case TouchingPoint::Mode::unknown:
      break;
  }
  return "unknown";
}

void bind_answers(py::module_& module) {
  py::class_<MotionEvent>(module, "Event", "Something that happened at an instant.")
      .def_property_readonly(
          "kind", [](const MotionEvent& e) { return event_kind_name(e.kind); },
          "'impact', 'rest', 'separation' or 'slip_to_stick'.")
      .def_readonly("time", &MotionEvent::time, "[s].")
      .def_readonly("body_a", &MotionEvent::body_A, "Index of a body.")
      .def_readonly("body_b", &MotionEvent::body_B, "Index of the other; -1: none.")
      .def_readonly("point", &MotionEvent::p_W, "Where an impact was [m].")
      .def_readonly("impulse", &MotionEvent::j_W, "Impulse of an impact on body_b [N s].")
      .def("__repr__", [](const MotionEvent& e) {
        return std::string("<Event ") + event_kind_name(e.kind) + " at " + std::to_string(e.time) + " s>";
      });
  py::class_<TouchingPoint>(module, "Contact", "A point where two bodies touch.")
      .def_readonly("body_a", &TouchingPoint::body_A, "Index of a body.")
      .def_readonly("body_b", &TouchingPoint::body_B, "Index of the other, larger than body_a.")
      .def_readonly("point", &TouchingPoint::p_W, "Where [m].")
      .def_readonly("normal", &TouchingPoint::n_W, "Unit, from body_a to body_b.")
      .def_readonly("gap", &TouchingPoint::gap, "[m], negative when overlapping.")
      .def_readonly("force", &TouchingPoint::force_W, "On body_b [N].")
      .def_readonly("velocity", &TouchingPoint::u_W, "Of body_b against body_a [m/s].")
      .def_property_readonly(
          "mode", [](const TouchingPoint& p) { return mode_name(p.mode); },
          "'open', 'stick', 'slide' or 'unknown'.");
  py::class_<JointReaction>(module, "JointState", "A joint at an instant.")
      .def_readonly("joint", &JointReaction::joint, "Index of the joint.")
      .def_property_readonly(
          "coordinates", [](const JointReaction& j) { return copied(j.coordinates); }, "[rad] or [m].")
      .def_property_readonly(
          "rates", [](const JointReaction& j) { return copied(j.rates); }, "[rad/s] or [m/s].")
      .def_property_readonly(
          "efforts", [](const JointReaction& j) { return copied(j.efforts); },
          "Of motors and servos [N m] or [N].")
      .def_readonly("anchor", &JointReaction::p_W, "On the second body [m].")
      .def_readonly("force", &JointReaction::force_W, "Reaction on the second body [N].")
      .def_readonly("torque", &JointReaction::torque_W, "The same about the anchor [N m].");
  py::class_<BodyRayHit>(module, "RayHit", "Where a ray meets a body.")
      .def_property_readonly(
          "body", [](const BodyRayHit& h) { return h.on.body; }, "Index of the body.")
      .def_property_readonly(
          "fraction", [](const BodyRayHit& h) { return h.hit.fraction; }, "Of the direction's length.")
      .def_property_readonly(
          "point", [](const BodyRayHit& h) { return h.hit.p_W; }, "[m].")
      .def_property_readonly(
          "normal", [](const BodyRayHit& h) { return h.hit.n_W; }, "Outward, unit.");
}

void bind_motion(py::class_<Simulation>& type) {
  const auto release = py::call_guard<py::gil_scoped_release>();
  type.def(
          "step",
          [](Simulation& s) {
            const InterruptibleCall call(s);
            s.step();
          },
          release, "Advances by one step, `run.step` of the scene.")
      .def(
          "advance_to",
          [](Simulation& s, double t) {
            const InterruptibleCall call(s);
            s.advance_to(t);
          },
          py::arg("t"), release,
          "Advances to t [s]. Ctrl-C ends it; the simulation stays at the last control instant.")
      .def("reset", &Simulation::reset, "Returns to t = 0.")
      .def_property_readonly("time", &Simulation::time, "[s].")
      .def_property_readonly("step_length", &Simulation::step_length, "[s].")
      .def_property_readonly("body_count", &Simulation::body_count, "Number of bodies.")
      .def_property_readonly("joint_count", &Simulation::joint_count, "Number of joints.")
      .def(
          "body", [](const Simulation& s, const std::string& name) { return s.body(name).index; },
          py::arg("name"), "Index of a body, which is quicker than its name.")
      .def(
          "joint", [](const Simulation& s, const std::string& name) { return s.joint(name).index; },
          py::arg("name"), "Index of a joint.")
      .def_property_readonly(
          "body_names",
          [](const Simulation& s) {
            std::vector<std::string> names;
            for (const Body& body : s.model().bodies()) names.push_back(body.name);
            return names;
          },
          "In the order of the arrays.")
      .def_property_readonly(
          "joint_names",
          [](const Simulation& s) {
            std::vector<std::string> names;
            for (const Joint& joint : s.model().joints()) names.push_back(joint.name);
            return names;
          },
          "In the order of the scene.")
      .def(
          "save", [](const Simulation& s) { return py::bytes(s.save()); },
          "All there is, as bytes: restore() continues with the same bits.")
      .def(
          "restore", [](Simulation& s, const py::bytes& bytes) { s.restore(std::string(bytes)); },
          py::arg("data"), "Continues from the bytes of save(), of a simulation of the same scene.")
      .def(
          "copy",
          [](const Simulation& s) {
            Simulation copy = s.clone();
            copy.set_controller({});
            return copy;
          },
          "An independent simulation that continues with the same bits, without the controller.");
}

void bind_places(py::class_<Simulation>& type) {
  type.def_property_readonly(
          "positions", [](const py::object& self) { return rows<3>(self, &Simulation::positions); },
          "Origins of the bodies' frames (n x 3) [m]: a view that is refreshed each time it is asked for.")
      .def_property_readonly(
          "orientations", [](const py::object& self) { return rows<4>(self, &Simulation::orientations); },
          "Quaternions w, x, y, z (n x 4), likewise.")
      .def_property_readonly(
          "velocities", [](const py::object& self) { return rows<3>(self, &Simulation::velocities); },
          "Of the centres of mass (n x 3) [m/s], likewise.")
      .def_property_readonly(
          "angular_velocities",
          [](const py::object& self) { return rows<3>(self, &Simulation::angular_velocities); },
          "In the world (n x 3) [rad/s], likewise.")
      .def(
          "pose",
          [](const Simulation& s, const py::object& b) { return pose_numbers(s.pose(body_of(s, b))); },
          py::arg("body"), "Position and quaternion w, x, y, z (7).")
      .def(
          "position", [](const Simulation& s, const py::object& b) { return s.position(body_of(s, b)); },
          py::arg("body"), "[m].")
      .def(
          "velocity", [](const Simulation& s, const py::object& b) { return s.velocity(body_of(s, b)); },
          py::arg("body"), "Of the centre of mass [m/s].")
      .def(
          "angular_velocity",
          [](const Simulation& s, const py::object& b) { return s.angular_velocity(body_of(s, b)); },
          py::arg("body"), "[rad/s].")
      .def(
          "is_asleep", [](const Simulation& s, const py::object& b) { return s.is_asleep(body_of(s, b)); },
          py::arg("body"), "Whether it sleeps (method.sleeping).");
}

void bind_actions(py::class_<Simulation>& type) {
  type.def(
          "apply_force",
          [](Simulation& s, const py::object& b, const Vec3& f, const std::optional<Vec3>& p) {
            p ? s.apply_force(body_of(s, b), f, *p) : s.apply_force(body_of(s, b), f);
          },
          py::arg("body"), py::arg("force"), py::arg("point") = py::none(),
          "A force [N] until the end of the next step, at the centre of mass or at a point [m].")
      .def(
          "apply_torque",
          [](Simulation& s, const py::object& b, const Vec3& t) { s.apply_torque(body_of(s, b), t); },
          py::arg("body"), py::arg("torque"), "A torque [N m] until the end of the next step.")
      .def(
          "apply_impulse",
          [](Simulation& s, const py::object& b, const Vec3& j, const std::optional<Vec3>& p) {
            p ? s.apply_impulse(body_of(s, b), j, *p) : s.apply_impulse(body_of(s, b), j);
          },
          py::arg("body"), py::arg("impulse"), py::arg("point") = py::none(), "An impulse [N s], at once.")
      .def(
          "apply_angular_impulse",
          [](Simulation& s, const py::object& b, const Vec3& l) {
            s.apply_angular_impulse(body_of(s, b), l);
          },
          py::arg("body"), py::arg("impulse"), "An angular impulse [N m s], at once.")
      .def(
          "set_pose",
          [](Simulation& s, const py::object& b, const py::object& x) {
            s.set_pose(body_of(s, b), pose_of(x));
          },
          py::arg("body"), py::arg("pose"), "Puts a dynamic or kinematic body there at once.")
      .def(
          "set_velocity",
          [](Simulation& s, const py::object& b, const Vec3& v, const Vec3& w) {
            s.set_velocity(body_of(s, b), v, w);
          },
          py::arg("body"), py::arg("velocity"), py::arg("angular_velocity") = Vec3(Vec3::Zero()),
          "Sets the velocities of a dynamic or kinematic body [m/s], [rad/s].")
      .def(
          "move_to",
          [](Simulation& s, const py::object& b, const py::object& x, double duration) {
            s.move_to(body_of(s, b), pose_of(x), duration);
          },
          py::arg("body"), py::arg("pose"), py::arg("duration"),
          "Leads a kinematic body there, in so long [s].")
      .def(
          "set_motor_velocity",
          [](Simulation& s, const py::object& j, double v, double f, int k) {
            s.set_motor_velocity(joint_of(s, j), v, f, k);
          },
          py::arg("joint"), py::arg("velocity"),
          py::arg("max_force") = std::numeric_limits<double>::infinity(), py::arg("coordinate") = 0,
          "A motor that holds a rate [rad/s] or [m/s], as far as its force [N m] or [N] goes.")
      .def(
          "set_motor_effort",
          [](Simulation& s, const py::object& j, double e, int k) {
            s.set_motor_effort(joint_of(s, j), e, k);
          },
          py::arg("joint"), py::arg("effort"), py::arg("coordinate") = 0,
          "A motor that gives this torque [N m] or force [N] on the second body.")
      .def(
          "set_motor_position",
          [](Simulation& s, const py::object& j, double target, double stiffness, double damping, int k,
             double max_force) {
            s.set_motor_position(joint_of(s, j), target, stiffness, damping, k, max_force);
          },
          py::arg("joint"), py::arg("target"), py::arg("stiffness"), py::arg("damping"),
          py::arg("coordinate") = 0, py::arg("max_force") = std::numeric_limits<double>::infinity(),
          "A servo: -stiffness (coordinate - target) - damping (rate), at most max_force [N m] or [N].")
      .def(
          "release_motor",
          [](Simulation& s, const py::object& j, int k) { s.release_motor(joint_of(s, j), k); },
          py::arg("joint"), py::arg("coordinate") = 0, "The laws of the scene hold again.")
      .def("set_gravity", &Simulation::set_gravity, py::arg("gravity"), "[m/s²].")
      .def(
          "set_friction", [](Simulation& s, const std::string& m, double mu) { s.set_friction(m, mu); },
          py::arg("material"), py::arg("friction"), "Of a material.")
      .def(
          "set_restitution", [](Simulation& s, const std::string& m, double e) { s.set_restitution(m, e); },
          py::arg("material"), py::arg("restitution"), "Of a material.")
      .def(
          "set_controller",
          [](Simulation& s, const py::object& f, double period) {
            if (f.is_none()) return s.set_controller({}, period);
            const std::shared_ptr<py::object> shared = shared_function(f);
            s.set_controller(
                [shared](Simulation& own) {
                  const py::gil_scoped_acquire lock;
                  (*shared)(py::cast(&own, py::return_value_policy::reference));
                },
                period);
          },
          py::arg("controller"), py::arg("period") = 0.0,
          "Calls controller(simulation) at every multiple of the period [s] (0: of the step) before the "
          "motion "
          "goes on; None ends it.");
}

void bind_questions(py::class_<Simulation>& type) {
  type.def("contacts", &Simulation::contacts, "Points that touch, with their forces, as a list of Contact.")
      .def(
          "joint_motion",
          [](const Simulation& s, const py::object& j) { return s.joint_motion(joint_of(s, j)); },
          py::arg("joint"), "Coordinates and rates of a joint, without forces.")
      .def(
          "joint_forces",
          [](const Simulation& s, const py::object& j) { return s.joint_forces(joint_of(s, j)); },
          py::arg("joint"), "The same with reaction and efforts, which are costly.")
      .def("take_events", &Simulation::take_events, "Events since the last call, as a list of Event.")
      .def_property_readonly("energy", &Simulation::energy,
                             "Mechanical energy, without the potential of forces that are applied [J].")
      .def(
          "audit",
          [](const Simulation& s) {
            const Audit audit = s.audit();
            return py::module_::import("rigor._simulation")
                .attr("Audit")(audit_json(audit), audit.violations);
          },
          "How far the run so far can be trusted, as an Audit.");
}

void bind_queries(py::module_& module, py::class_<Simulation>& type) {
  py::class_<BodyCastHit>(module, "CastHit", "Where a shape that is pushed meets a body.")
      .def_property_readonly(
          "body", [](const BodyCastHit& h) { return h.on.body; }, "Index of the body.")
      .def_property_readonly(
          "fraction", [](const BodyCastHit& h) { return h.hit.fraction; },
          "Of the way, which is proven free so far.")
      .def_property_readonly(
          "point", [](const BodyCastHit& h) { return h.hit.p_W; }, "[m].")
      .def_property_readonly(
          "normal", [](const BodyCastHit& h) { return h.hit.n_W; }, "From the shape to the body, unit.");
  type.def(
          "ray",
          [](const Simulation& s, const Vec3& origin, const Vec3& direction, double longest) {
            if (!(origin.allFinite() && direction.allFinite() && direction.norm() > 0))
              throw InputError("a ray needs a finite origin and a direction that is not zero");
            return s.queries().first_hit({origin, direction, longest});
          },
          py::arg("origin"), py::arg("direction"),
          py::arg("max_fraction") = std::numeric_limits<double>::infinity(),
          "The first surface that a ray crosses, as a RayHit, or None.")
      .def(
          "nearest",
          [](const Simulation& s, const Vec3& p, int k) {
            if (!p.allFinite() || k < 1)
              throw InputError("nearest() needs a finite point and k of at least 1");
            std::vector<std::pair<int, double>> found;
            for (const NearBody& near : s.queries().nearest(p, k))
              found.emplace_back(near.on.body, near.distance);
            return found;
          },
          py::arg("point"), py::arg("k") = 1,
          "The k bodies nearest to a point: pairs of index and signed distance [m].")
      .def(
          "cast",
          [](const Simulation& s, const Solid& shape, const py::object& pose, const Vec3& way) {
            if (!way.allFinite()) throw InputError("the way of a pushed shape must be finite");
            return s.queries().cast({&shape.shape, pose_of(pose), way});
          },
          py::arg("shape"), py::arg("pose"), py::arg("way"),
          "The first body that a shape meets which is pushed along a way [m], as a CastHit, or None.")
      .def(
          "overlapping",
          [](const Simulation& s, const Solid& shape, const py::object& pose) {
            return s.queries().overlapping(shape.shape, pose_of(pose));
          },
          py::arg("shape"), py::arg("pose"), "Indices of the bodies that a shape touches or overlaps there.");
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_answers(module);
  py::class_<Simulation> type(module, "Simulation");
  type.def(py::init<Scene, bool>(), py::arg("scene"), py::arg("separate") = false);
  bind_motion(type);
  bind_places(type);
  bind_actions(type);
  bind_questions(type);
  bind_queries(module, type);
}

}  // namespace rigor::python
