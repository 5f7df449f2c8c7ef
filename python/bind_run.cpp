#include "binding.hpp"
#include "signals.hpp"

#include <rigor/core/range.hpp>
#include <rigor/io/trajectory/audit_json.hpp>

#include <filesystem>
#include <memory>

namespace rigor::python {

namespace {

/// A scene with what belongs to its text.
struct TextScene {
  Scene scene;
  std::string text, file_name;
  std::vector<std::string> overrides;
};

TextScene parse(const std::string& text, const std::string& file_name, const std::string& folder,
                const std::vector<std::string>& overrides) {
  return {parse_scene(text, file_name, folder, overrides), text, file_name, overrides};
}

struct Record {
  RunRecord run;
  py::ssize_t bodies = 0, coordinates = 0;
};

std::unique_ptr<Record> record(const TextScene& given, const std::optional<double>& duration,
                               const std::optional<double>& output_interval, int threads, bool separate,
                               const std::vector<std::string>& files, const py::object& progress) {
  Scene scene = given.scene;
  if (duration) scene.run.duration = *duration;
  if (output_interval) scene.run.output_interval = *output_interval;
  scene.run.threads = threads;
  for (const auto& [name, value] :
       {std::pair{"duration", scene.run.duration}, std::pair{"output_interval", scene.run.output_interval}}) {
    const std::string fault = range_error(name, value, {0, 1e9, true}, "s");
    if (!fault.empty()) throw InputError(fault);
  }
  if (scene.run.duration / scene.run.output_interval > 1e8)
    throw InputError("duration / output_interval gives more than 100000000 outputs");
  RecordOptions options;
  options.separate = separate;
  options.interrupt = SignalWatch();
  options.scene_text = given.text;
  options.scene_file = std::filesystem::path(given.file_name).filename().string();
  options.overrides = given.overrides;
  for (const std::string& file : files) options.files.emplace_back(file);
  if (!progress.is_none()) {
    options.progress = [&progress](double t) {
      const py::gil_scoped_acquire lock;
      progress(t);
    };
  }
  auto result = std::make_unique<Record>();
  result->bodies = scene.model->body_count();
  for (const Joint& joint : scene.model->joints())
    result->coordinates += static_cast<py::ssize_t>(joint.axes.size());
  {
    const py::gil_scoped_release release;
    result->run = record_run(scene, options);
  }
  if (result->run.was_interrupted) throw Interrupted();
  return result;
}

py::array table(const py::object& self, const std::vector<double> RunRecord::*numbers, bool of_bodies,
                py::ssize_t columns) {
  const Record& own = py::cast<const Record&>(self);
  const auto times = static_cast<py::ssize_t>(own.run.time.size());
  const double* data = (own.run.*numbers).data();
  if (of_bodies) return view(data, {times, own.bodies, columns}, self);
  return columns == 0 ? view(data, {times}, self) : view(data, {times, columns}, self);
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<Scene>(module, "SceneData")
      .def_property_readonly("name", [](const Scene& s) { return s.name; })
      .def_property_readonly("warnings", [](const Scene& s) { return s.warnings; })
      .def_property_readonly("step", [](const Scene& s) { return s.run.step; })
      .def_property_readonly("duration", [](const Scene& s) { return s.run.duration; })
      .def_property_readonly("output_interval", [](const Scene& s) { return s.run.output_interval; })
      .def_property_readonly("bodies",
                             [](const Scene& s) {
                               std::vector<std::string> names;
                               for (const Body& body : s.model->bodies()) names.push_back(body.name);
                               return names;
                             })
      .def_property_readonly("masses",
                             [](const Scene& s) {
                               std::vector<double> masses;
                               for (const Body& body : s.model->bodies()) masses.push_back(body.mass);
                               return copied(masses);
                             })
      .def_property_readonly("joints", [](const Scene& s) {
        std::vector<std::pair<std::string, int>> joints;
        for (const Joint& joint : s.model->joints())
          joints.emplace_back(joint.name, static_cast<int>(joint.axes.size()));
        return joints;
      });
  py::class_<TextScene>(module, "TextScene")
      .def(py::init(&parse), py::arg("text"), py::arg("file_name"), py::arg("folder"), py::arg("overrides"))
      .def_property_readonly("scene", [](const TextScene& s) { return s.scene; });

  py::class_<Record> type(module, "Record");
  const auto add = [&type](const char* name, const std::vector<double> RunRecord::*numbers, bool of_bodies,
                           py::ssize_t columns) {
    type.def_property_readonly(name, [numbers, of_bodies, columns](const py::object& self) {
      return table(self, numbers, of_bodies, columns);
    });
  };
  add("time", &RunRecord::time, false, 0);
  add("position", &RunRecord::position, true, 3);
  add("orientation", &RunRecord::orientation, true, 4);
  add("velocity", &RunRecord::velocity, true, 3);
  add("angular_velocity", &RunRecord::angular_velocity, true, 3);
  add("kinetic", &RunRecord::kinetic, false, 0);
  add("potential", &RunRecord::potential, false, 0);
  add("elastic", &RunRecord::elastic, false, 0);
  add("penetration", &RunRecord::penetration, false, 0);
  type.def_property_readonly("joint_coordinate", [](const py::object& self) {
    return table(self, &RunRecord::joint_coordinate, false, py::cast<const Record&>(self).coordinates);
  });
  type.def_property_readonly("joint_rate", [](const py::object& self) {
    return table(self, &RunRecord::joint_rate, false, py::cast<const Record&>(self).coordinates);
  });
  type.def_property_readonly("events", [](const Record& r) { return r.run.events; })
      .def("audit_json", [](const Record& r) { return audit_json(r.run.audit); })
      .def("violations", [](const Record& r) { return r.run.audit.violations; });
  module.def("record", &record, py::arg("scene"), py::arg("duration"), py::arg("output_interval"),
             py::arg("threads"), py::arg("separate"), py::arg("files"), py::arg("progress"));
}

}  // namespace rigor::python
