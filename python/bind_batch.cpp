#include "binding.hpp"
#include "signals.hpp"

#include <rigor/core/range.hpp>
#include <rigor/model/limits.hpp>

#include <atomic>
#include <memory>
#include <thread>

namespace rigor::python {

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Ctrl-C within a call of a batch: the thread of the call asks Python, the others look at what it was told.
class BatchInterrupt {
 public:
  explicit BatchInterrupt(Batch& batch) : batch_(batch) {
    const auto wanted = std::make_shared<std::atomic<bool>>(false);
    const auto watch = std::make_shared<SignalWatch>();
    batch_.set_interrupt([wanted, watch, caller = std::this_thread::get_id()] {
      if (!*wanted && std::this_thread::get_id() == caller && (*watch)()) *wanted = true;
      return wanted->load();
    });
  }
  ~BatchInterrupt() { batch_.set_interrupt({}); }
  BatchInterrupt(const BatchInterrupt&) = delete;
  BatchInterrupt& operator=(const BatchInterrupt&) = delete;

 private:
  Batch& batch_;
};

/// Sets a function of Python as the controller of every world; it takes the lock of the interpreter.
void set_controller(Batch& batch, const py::object& function, double period) {
  if (function.is_none()) return batch.set_controller({}, period);
  const std::shared_ptr<py::object> shared = shared_function(function);
  batch.set_controller(
      [shared, &batch](int index, Simulation& world) {
        const py::gil_scoped_acquire lock;
        // Who keeps the world keeps the batch.
        const py::object owner = py::cast(&batch, py::return_value_policy::reference);
        (*shared)(index, py::cast(&world, py::return_value_policy::reference_internal, owner));
      },
      period);
}

// Whatever is given for all worlds is looked at before anything is set in one of them.

/// One number, or `columns` numbers, for each world.
void require_shape(const Batch& batch, const Numbers& numbers, py::ssize_t columns, const char* what) {
  const bool fits =
      columns == 1 ? numbers.ndim() == 1 && numbers.shape(0) == batch.size()
                   : numbers.ndim() == 2 && numbers.shape(0) == batch.size() && numbers.shape(1) == columns;
  if (fits) return;
  throw InputError(std::string(what) + " must be an array of shape (" + std::to_string(batch.size()) +
                   (columns == 1 ? ",)" : ", " + std::to_string(columns) + ")"));
}

void require_in(const Numbers& numbers, const char* quantity, const Range& range, const char* unit) {
  for (py::ssize_t i = 0; i < numbers.size(); ++i) {
    const std::string fault = range_error(quantity, numbers.data()[i], range, unit);
    if (!fault.empty()) throw InputError(fault);
  }
}

/// The worlds that a list of indices, or an array of one flag for each world, stands for.
std::vector<int> worlds_of(const Batch& batch, const py::object& which) {
  constexpr const char* allowed = "worlds are an index, a list of indices, or an array of flags";
  if (PyIndex_Check(which.ptr()) != 0 && !py::isinstance<py::array>(which)) return {index_of(which)};
  const py::array array = py::array::ensure(which);
  if (!array) PyErr_Clear();
  if (!array || array.ndim() != 1) throw py::type_error(allowed);
  if (!py::isinstance<py::array_t<bool>>(array)) {
    std::vector<int> worlds;
    for (const py::handle index : array.attr("tolist")()) {
      if (PyIndex_Check(index.ptr()) == 0) throw py::type_error(allowed);
      worlds.push_back(index_of(index));
    }
    return worlds;
  }
  if (array.ndim() != 1 || array.shape(0) != batch.size())
    throw InputError("the flags must be an array of shape (" + std::to_string(batch.size()) + ",)");
  const auto flags = py::cast<std::vector<bool>>(array.attr("tolist")());
  std::vector<int> worlds;
  for (int i = 0; i < batch.size(); ++i) {
    if (flags[static_cast<std::size_t>(i)]) worlds.push_back(i);
  }
  return worlds;
}

py::array_t<double> of_joint(Batch& batch, const std::string& joint, int coordinate, bool is_rate) {
  py::array_t<double> numbers(batch.size());
  double* out = numbers.mutable_data();
  const JointHandle handle = batch.world(0).joint(joint);
  const int count = static_cast<int>(batch.world(0).model().joint(handle.index).axes.size());
  if (coordinate < 0 || coordinate >= count)
    throw InputError("joint '" + joint + "' has " + std::to_string(count) + " coordinates");
  const py::gil_scoped_release release;
  batch.for_each([&](int i, Simulation& world) {
    const JointReaction motion = world.joint_motion(handle);
    out[i] = (is_rate ? motion.rates : motion.coordinates)[static_cast<std::size_t>(coordinate)];
  });
  return numbers;
}

}  // namespace

void bind_batch(py::module_& module) {
  py::class_<Batch>(module, "Batch")
      .def(py::init<const Scene&, int, int>(), py::arg("scene"), py::arg("count"), py::arg("threads") = 0)
      .def("__len__", &Batch::size)
      .def_property_readonly("threads", &Batch::threads, "Number of threads.")
      .def(
          "step",
          [](Batch& b) {
            const py::gil_scoped_release release;
            const BatchInterrupt interrupt(b);
            b.step();
          },
          "One step of every world. Ctrl-C ends it; the worlds may then be at different times.")
      .def(
          "advance_to",
          [](Batch& b, double t) {
            const py::gil_scoped_release release;
            const BatchInterrupt interrupt(b);
            b.advance_to(t);
          },
          py::arg("t"), "Advances every world to t [s]. Ctrl-C ends it likewise.")
      .def("set_controller", &set_controller, py::arg("controller"), py::arg("period") = 0.0,
           "A function controller(index, world) called at every multiple of period [s] (0: of the step) "
           "before "
           "a world goes on; None ends it. The threads wait for each other in it.")
      .def(
          "set_states",
          [](Batch& b, const Numbers& states) {
            const py::ssize_t bodies = b.world(0).body_count();
            const bool fits = states.ndim() == 3 && states.shape(0) == b.size() &&
                              states.shape(1) == bodies && states.shape(2) == 13;
            if (!fits) {
              throw InputError("states must be an array of shape (" + std::to_string(b.size()) + ", " +
                               std::to_string(bodies) + ", 13)");
            }
            const py::gil_scoped_release release;
            b.set_states({states.data(), static_cast<std::size_t>(states.size())});
          },
          py::arg("states"),
          "Puts all bodies where `states` says, in its order; of a kinematic body the velocities are left "
          "out.")
      .def(
          "set_frictions",
          [](Batch& b, const std::string& material, const Numbers& numbers) {
            require_shape(b, numbers, 1, "frictions");
            require_in(numbers, "friction", limits::friction, "");
            for (int i = 0; i < b.size(); ++i) b.world(i).set_friction(material, *numbers.data(i));
          },
          py::arg("material"), py::arg("frictions"), "Of a material in each world.")
      .def(
          "set_restitutions",
          [](Batch& b, const std::string& material, const Numbers& numbers) {
            require_shape(b, numbers, 1, "restitutions");
            require_in(numbers, "restitution", limits::restitution, "");
            for (int i = 0; i < b.size(); ++i) b.world(i).set_restitution(material, *numbers.data(i));
          },
          py::arg("material"), py::arg("restitutions"), "Of a material in each world.")
      .def(
          "set_gravities",
          [](Batch& b, const Numbers& numbers) {
            require_shape(b, numbers, 3, "gravities");
            require_in(numbers, "gravity", limits::gravity, "m/s²");
            for (int i = 0; i < b.size(); ++i) b.world(i).set_gravity(Vec3::Map(numbers.data(i, 0)));
          },
          py::arg("gravities"), "In each world [m/s²].")
      .def_property_readonly(
          "times",
          [](const Batch& b) {
            py::array_t<double> times(b.size());
            for (int i = 0; i < b.size(); ++i) times.mutable_data()[i] = b.world(i).time();
            return times;
          },
          "Of each world [s].")
      .def(
          "world", [](Batch& b, int i) -> Simulation& { return b.world(i); }, py::arg("index"),
          py::return_value_policy::reference_internal, "A world, as a Simulation.")
      .def_property_readonly("stops", &Batch::stops, "Why each world has stopped; empty where it has not.")
      .def_property_readonly(
          "states",
          [](const py::object& self) {
            Batch& batch = py::cast<Batch&>(self);
            const std::vector<double>& numbers = batch.states();
            return view(numbers.data(), {batch.size(), batch.world(0).body_count(), 13}, self);
          },
          "Position, quaternion w x y z, velocity, angular velocity (worlds x bodies x 13): a "
          "view that is refreshed each time it is asked for.")
      .def(
          "apply_forces",
          [](Batch& b, const std::string& body, const Numbers& forces) {
            require_shape(b, forces, 3, "forces");
            require_in(forces, "force", limits::force, "N");
            const BodyHandle handle = b.world(0).body(body);
            for (int i = 0; i < b.size(); ++i) b.world(i).apply_force(handle, Vec3::Map(forces.data(i, 0)));
          },
          py::arg("body"), py::arg("forces"),
          "A force [N] on a body in each world, until the next step ends.")
      .def(
          "set_motor_efforts",
          [](Batch& b, const std::string& joint, const Numbers& efforts, int k) {
            require_shape(b, efforts, 1, "efforts");
            require_in(efforts, "effort of the motor", limits::force, "N or N m");
            const JointHandle handle = b.world(0).joint(joint);
            for (int i = 0; i < b.size(); ++i) b.world(i).set_motor_effort(handle, *efforts.data(i), k);
          },
          py::arg("joint"), py::arg("efforts"), py::arg("coordinate") = 0,
          "Of a joint's motor in each world.")
      .def(
          "joint_coordinates", [](Batch& b, const std::string& j, int k) { return of_joint(b, j, k, false); },
          py::arg("joint"), py::arg("coordinate") = 0, "In each world [rad] or [m].")
      .def(
          "joint_rates", [](Batch& b, const std::string& j, int k) { return of_joint(b, j, k, true); },
          py::arg("joint"), py::arg("coordinate") = 0, "In each world [rad/s] or [m/s].")
      .def(
          "reset",
          [](Batch& b, const py::object& which) {
            const std::vector<int> worlds = worlds_of(b, which);
            for (const int i : worlds) b.world(i);
            for (const int i : worlds) b.reset(i);
          },
          py::arg("index"),
          "Returns worlds to t = 0: one, a list of indices, or those where an array of flags is true.");
}

}  // namespace rigor::python
