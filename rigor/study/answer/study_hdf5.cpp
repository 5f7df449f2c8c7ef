#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/io/trajectory/hdf5_handle.hpp"
#include "rigor/study/answer/study_output.hpp"

#include <algorithm>
#include <string_view>

namespace rigor {

namespace {

/// A list of texts as strings of equal length, padded with NUL.
bool write_names(hid_t file, const char* name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string bytes;
  for (const std::string& text : texts) bytes.append(text).append(longest - text.size(), '\0');
  const Hdf5Handle type = hdf5_text_type(longest);
  const hsize_t count = texts.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  return data.is_open() &&
         (count == 0 || H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0);
}

bool write_matrix(hid_t file, const char* name, const std::vector<double>& values, hsize_t columns) {
  const hsize_t sizes[2] = {columns > 0 ? values.size() / columns : 0, columns};
  const Hdf5Handle space(H5Screate_simple(2, sizes, nullptr), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
  return data.is_open() && (values.empty() || H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                                       values.data()) >= 0);
}

bool write_statuses(hid_t file, const std::vector<int>& statuses) {
  const hsize_t count = statuses.size();
  Hdf5Handle type(H5Tenum_create(H5T_NATIVE_INT), H5Tclose);
  for (const RunStatus status : {RunStatus::done, RunStatus::violated, RunStatus::stopped, RunStatus::refused,
                                 RunStatus::out_of_time}) {
    const int value = static_cast<int>(status);
    H5Tenum_insert(type, run_status_name(status), &value);
  }
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(file, "status", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
  return data.is_open() &&
         (count == 0 || H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, statuses.data()) >= 0);
}

}  // namespace

void write_study_hdf5(const Study& study, const std::filesystem::path& path) {
  const Hdf5Quiet quiet;
  // Without times of creation in it, equal studies have equal files.
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  check_can_write(path);
  Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT), H5Fclose);
  std::vector<double> parameters, outcomes;
  std::vector<int> statuses;
  const RowTable& rows = study.rows();
  for (std::uint64_t run = 0; run < study.run_count(); ++run) {
    const std::vector<double> values = study.parameters_of(run);
    parameters.insert(parameters.end(), values.begin(), values.end());
    for (std::size_t k = 0; k < rows.columns(); ++k) outcomes.push_back(rows.value(run, k));
    statuses.push_back(static_cast<int>(rows.status(run)));
  }
  const std::vector<std::string> names = study.plan().columns();
  const bool is_written = file.is_open() && write_names(file, "parameter_names", names) &&
                          write_matrix(file, "parameters", parameters, names.size()) &&
                          write_names(file, "outcome_names", row_columns(study.plan())) &&
                          write_matrix(file, "outcomes", outcomes, rows.columns()) &&
                          write_statuses(file, statuses) && write_names(file, "study", {study.plan().text}) &&
                          write_names(file, "rigor", {std::string(version)});
  if (!file.reset() || !is_written) throw FileError("cannot write '" + path.string() + "'");
}

}  // namespace rigor
