// rigor.study: thousands of runs for an answer (docs/studies.md).

#include "binding.hpp"

#include <rigor/core/interrupt.hpp>
#include <rigor/study/answer/study_output.hpp>
#include <rigor/study/kinds/statistics.hpp>
#include <rigor/study/study.hpp>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <optional>

namespace rigor::python {

namespace {

/// Waits for the work of another thread; Ctrl-C asks it to end. Called with the lock of the interpreter.
void wait_for(std::future<void>& work, std::atomic<bool>& is_interrupted) {
  bool is_done = false;
  while (!is_done) {
    {
      const py::gil_scoped_release release;
      is_done = work.wait_for(std::chrono::milliseconds(50)) == std::future_status::ready;
    }
    // The error that the signal's handler has raised waits until the call has come back.
    if (!is_done && !is_interrupted && PyErr_CheckSignals() != 0) is_interrupted = true;
  }
  work.get();
}

std::unique_ptr<Study> carry_out(const std::string& file, int threads, const std::string& journal) {
  if (threads < 1) throw InputError("threads is " + std::to_string(threads) + ", must be at least 1");
  auto study = std::make_unique<Study>(read_study(file));
  std::atomic<bool> is_interrupted = false;
  // The runs go on in threads that do not know Python; this one listens to it.
  std::future<void> work = std::async(std::launch::async, [&] {
    study->estimate_cost(journal);
    const std::unique_ptr<WorkerPool> pool =
        make_thread_pool([&] { return study->make_executor(); }, threads);
    study->run(*pool, {journal, [&] { return is_interrupted.load(); }, {}});
  });
  wait_for(work, is_interrupted);
  if (is_interrupted) throw Interrupted();
  return study;
}

/// The names with one array each, a number a run.
template <typename Value>
py::dict columns(const Study& study, const std::vector<std::string>& names, Value value) {
  py::dict result;
  const auto runs = static_cast<py::ssize_t>(study.run_count());
  std::vector<py::array_t<double>> arrays;
  for (const std::string& name : names) {
    arrays.emplace_back(runs);
    result[py::str(name)] = arrays.back();
  }
  for (py::ssize_t run = 0; run < runs; ++run) {
    const std::vector<double> row = value(static_cast<std::uint64_t>(run));
    for (std::size_t k = 0; k < arrays.size(); ++k) arrays[k].mutable_at(run) = row[k];
  }
  return result;
}

py::dict parameters(const Study& study) {
  return columns(study, study.plan().columns(), [&](std::uint64_t run) { return study.parameters_of(run); });
}

py::dict outcomes(const Study& study) {
  return columns(study, row_columns(study.plan()), [&](std::uint64_t run) {
    std::vector<double> row;
    for (std::size_t k = 0; k < study.rows().columns(); ++k) row.push_back(study.rows().value(run, k));
    return row;
  });
}

std::vector<std::string> statuses(const Study& study) {
  std::vector<std::string> names;
  for (std::uint64_t run = 0; run < study.run_count(); ++run)
    names.emplace_back(run_status_name(study.rows().status(run)));
  return names;
}

std::vector<std::string> reasons(const Study& study) {
  std::vector<std::string> texts;
  for (std::uint64_t run = 0; run < study.run_count(); ++run) texts.push_back(study.rows().reason(run));
  return texts;
}

}  // namespace

void bind_study(py::module_& module) {
  module.def("student_quantile", &student_quantile, py::arg("share"), py::arg("degrees_of_freedom"),
             "The number below which one of Student's distribution lies with this probability.");
  py::class_<Study>(module, "StudyRecord", "A study that was carried out.")
      .def(py::init(&carry_out), py::arg("file"), py::arg("threads"), py::arg("journal"))
      .def_property_readonly("name", [](const Study& study) { return study.plan().name; })
      .def_property_readonly("parameters", &parameters)
      .def_property_readonly("outcomes", &outcomes)
      .def_property_readonly("statuses", &statuses)
      .def_property_readonly("reasons", &reasons)
      .def_property_readonly("answer", &study_json)
      .def_property_readonly(
          "unmet", [](const Study& study) { return unmet_expectations(study.plan(), study.answer()); })
      .def("save", [](const Study& study, const std::string& path) {
        const std::string error = check_study_output(path);
        if (!error.empty()) throw InputError(error);
        write_study(study, path);
      });
}

}  // namespace rigor::python
