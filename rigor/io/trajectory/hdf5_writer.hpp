#pragma once

#include "rigor/io/trajectory/trajectory_writer.hpp"

namespace rigor {

/// Trajectory as an HDF5 file (docs/output.md gives its layout), written so that it can be opened and read at
/// any instant, even after its writer was killed (see Hdf5FileDriver): then it holds everything but the last
/// moment.
class Hdf5Writer : public TrajectoryWriter {
 public:
  Hdf5Writer(const std::filesystem::path& path, const TrajectoryHeader& header);
  /// Closes silently; call close() to learn of errors.
  ~Hdf5Writer() override;
  void write(const TrajectorySample& sample, std::span<const MotionEvent> events) override;
  void close(const Audit& audit) override;
  /// Passes everything written so far to the system.
  void flush();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace rigor
