#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/trajectory/hdf5_handle.hpp"
#include "rigor/study/answer/study_plot.hpp"

#include <array>
#include <cstddef>

namespace rigor {

namespace {

/// Reads the data sets of a file with the runs of a study.
class StudyFile {
 public:
  explicit StudyFile(const std::filesystem::path& path)
      : name_(quoted_text(path.string())),
        file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {}

  bool is_study() const {
    return file_.is_open() && H5Lexists(file_, "outcome_names", H5P_DEFAULT) > 0 &&
           H5Lexists(file_, "parameters", H5P_DEFAULT) > 0;
  }

  std::vector<std::string> texts(const char* name) const {
    const Hdf5Handle data = open(name);
    const Hdf5Handle type(H5Dget_type(data), H5Tclose);
    const hsize_t count = sizes(data, name, 1)[0];
    const std::size_t length = H5Tget_size(type);
    check(H5Tget_class(type) == H5T_STRING && !H5Tis_variable_str(type) && count * length <= most_bytes,
          name);
    std::string bytes(count * length, '\0');
    check(count == 0 || H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0, name);
    std::vector<std::string> all;
    for (hsize_t i = 0; i < count; ++i) all.emplace_back(bytes.substr(i * length, length).c_str());
    return all;
  }

  std::vector<int> statuses() const {
    const Hdf5Handle data = open("status");
    const Hdf5Handle type(H5Dget_type(data), H5Tclose);
    const hsize_t count = sizes(data, "status", 1)[0];
    check(H5Tget_class(type) == H5T_ENUM && H5Tget_size(type) == sizeof(int) &&
              count * sizeof(int) <= most_bytes,
          "status");
    std::vector<int> all(count);
    check(count == 0 || H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) >= 0, "status");
    return all;
  }

  /// The numbers, a row after the other.
  std::vector<double> matrix(const char* name, std::size_t rows, std::size_t columns) const {
    const Hdf5Handle data = open(name);
    const std::array<hsize_t, 2> found = sizes(data, name, 2);
    check(found[0] == rows && found[1] == columns, name);
    std::vector<double> all(rows * columns);
    check(all.empty() || H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) >= 0,
          name);
    return all;
  }

 private:
  /// More than any memory: what is beyond is a damaged number.
  static constexpr hsize_t most_bytes = hsize_t{1} << 40;

  void check(bool is_right, const char* name) const {
    if (!is_right) throw InputError(name_ + ": the runs of the study are damaged: " + name);
  }
  Hdf5Handle open(const char* name) const {
    Hdf5Handle data(H5Dopen2(file_, name, H5P_DEFAULT), H5Dclose);
    check(data.is_open(), name);
    return data;
  }
  std::array<hsize_t, 2> sizes(const Hdf5Handle& data, const char* name, int dimensions) const {
    const Hdf5Handle space(H5Dget_space(data), H5Sclose);
    std::array<hsize_t, 2> found{};
    check(H5Sget_simple_extent_ndims(space) == dimensions &&
              H5Sget_simple_extent_dims(space, found.data(), nullptr) >= 0,
          name);
    return found;
  }

  std::string name_;
  Hdf5Handle file_;
};

}  // namespace

bool is_study_file(const std::filesystem::path& path) {
  const Hdf5Quiet quiet;
  return StudyFile(path).is_study();
}

StudyColumns read_study_columns(const std::filesystem::path& path) {
  const Hdf5Quiet quiet;
  const StudyFile file(path);
  if (!file.is_study()) throw InputError(quoted_text(path.string()) + " has no runs of a study");
  StudyColumns table;
  table.names = file.texts("parameter_names");
  table.are_parameters.assign(table.names.size(), true);
  const std::size_t parameters = table.names.size();
  for (const std::string& name : file.texts("outcome_names")) {
    table.names.push_back(name);
    table.are_parameters.push_back(false);
  }
  const std::size_t outcomes = table.names.size() - parameters;
  const std::vector<int> statuses = file.statuses();
  const std::vector<double> given = file.matrix("parameters", statuses.size(), parameters),
                            found = file.matrix("outcomes", statuses.size(), outcomes);
  table.values.resize(table.names.size());
  for (std::size_t run = 0; run < statuses.size(); ++run) {
    if (!is_complete(static_cast<RunStatus>(statuses[run]))) continue;
    table.runs.push_back(run);
    for (std::size_t k = 0; k < parameters; ++k) table.values[k].push_back(given[run * parameters + k]);
    for (std::size_t k = 0; k < outcomes; ++k)
      table.values[parameters + k].push_back(found[run * outcomes + k]);
  }
  return table;
}

}  // namespace rigor
