#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/io/trajectory/hdf5_handle.hpp"
#include "rigor/study/answer/study_output.hpp"
#include "rigor/study/run/run_executor.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace rigor {

namespace {

/// Runs that are in memory at a time while a file is written.
constexpr std::uint64_t slab_rows = 4096;

/// How a data set of one row a run is stored, and how its numbers are in memory.
struct RowType {
  hid_t stored, memory;
  hsize_t columns;  ///< 0: a number a run, not a row.
};

/// Writes rows slab by slab; `fill` appends the numbers of a run.
template <typename Number>
bool write_rows(hid_t file, const char* name, const RowType& type, std::uint64_t runs,
                const std::function<void(std::uint64_t, std::vector<Number>&)>& fill) {
  const int dimensions = type.columns > 0 ? 2 : 1;
  const hsize_t sizes[2] = {runs, type.columns};
  const Hdf5Handle space(H5Screate_simple(dimensions, sizes, nullptr), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(file, name, type.stored, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
  if (!data.is_open()) return false;
  std::vector<Number> slab;
  for (std::uint64_t first = 0; first < runs; first += slab_rows) {
    const hsize_t start[2] = {first, 0}, count[2] = {std::min(slab_rows, runs - first), type.columns};
    slab.clear();
    for (std::uint64_t run = first; run < first + count[0]; ++run) fill(run, slab);
    if (slab.empty()) continue;
    const Hdf5Handle part(H5Screate_simple(dimensions, count, nullptr), H5Sclose);
    if (H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
        H5Dwrite(data, type.memory, part, space, H5P_DEFAULT, slab.data()) < 0)
      return false;
  }
  return true;
}

bool write_statuses(hid_t file, const Study& study) {
  const Hdf5Handle type(H5Tenum_create(H5T_NATIVE_INT), H5Tclose);
  for (const RunStatus status : all_run_statuses) {
    const int value = static_cast<int>(status);
    H5Tenum_insert(type, run_status_name(status), &value);
  }
  return write_rows<int>(file, "status", {type, type, 0}, study.run_count(),
                         [&](std::uint64_t run, std::vector<int>& slab) {
                           slab.push_back(static_cast<int>(study.rows().status(run)));
                         });
}

/// The study's seed and, where it varies, that of each run.
bool write_seeds(hid_t file, const Study& study) {
  const StudyPlan& plan = study.plan();
  const RowType type{H5T_STD_U64LE, H5T_NATIVE_UINT64, 0};
  const auto of_study = [&](std::uint64_t, std::vector<std::uint64_t>& slab) { slab.push_back(plan.seed); };
  const auto of_run = [&](std::uint64_t run, std::vector<std::uint64_t>& slab) {
    slab.push_back(run_seed(plan, run));
  };
  return write_rows<std::uint64_t>(file, "seed", type, 1, of_study) &&
         (!plan.varies_seed || write_rows<std::uint64_t>(file, "run_seed", type, study.run_count(), of_run));
}

/// The runs that have a reason, and it.
bool write_reasons(hid_t file, const Study& study) {
  std::vector<std::uint64_t> runs;
  std::vector<std::string> reasons;
  for (std::uint64_t run = 0; run < study.run_count(); ++run) {
    if (study.rows().status(run) == RunStatus::done) continue;
    runs.push_back(run);
    reasons.push_back(study.rows().reason(run));
  }
  return write_rows<std::uint64_t>(
             file, "reason_run", {H5T_STD_U64LE, H5T_NATIVE_UINT64, 0}, runs.size(),
             [&](std::uint64_t i, std::vector<std::uint64_t>& slab) { slab.push_back(runs[i]); }) &&
         write_hdf5_texts(file, "reason", reasons);
}

bool write_numbers(hid_t file, const Study& study) {
  const RowTable& rows = study.rows();
  const RowType parameters{H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, study.plan().columns().size()},
      outcomes{H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, rows.columns()};
  return write_rows<double>(file, "parameters", parameters, study.run_count(),
                            [&](std::uint64_t run, std::vector<double>& slab) {
                              const std::vector<double> values = study.parameters_of(run);
                              slab.insert(slab.end(), values.begin(), values.end());
                            }) &&
         write_rows<double>(file, "outcomes", outcomes, study.run_count(),
                            [&](std::uint64_t run, std::vector<double>& slab) {
                              for (std::size_t k = 0; k < rows.columns(); ++k)
                                slab.push_back(rows.value(run, k));
                            });
}

}  // namespace

void write_study_hdf5(const Study& study, const std::filesystem::path& path) {
  const Hdf5Quiet quiet;
  // Without times of creation in it, equal studies have equal files.
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  check_can_write(path);
  Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT), H5Fclose);
  const StudyPlan& plan = study.plan();
  const bool is_written =
      file.is_open() && write_hdf5_texts(file, "parameter_names", plan.columns()) &&
      write_hdf5_texts(file, "outcome_names", row_columns(plan)) && write_numbers(file, study) &&
      write_statuses(file, study) && write_seeds(file, study) && write_reasons(file, study) &&
      write_hdf5_texts(file, "study", {plan.text}) && write_hdf5_texts(file, "rigor", {std::string(version)});
  if (!file.reset() || !is_written) throw FileError("cannot write '" + path.string() + "'");
}

}  // namespace rigor
