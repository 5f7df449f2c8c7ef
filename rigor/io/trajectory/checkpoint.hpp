#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace rigor {

/// A run that was put aside: all that is needed to go on bit for bit, and its books so far.
struct Checkpoint {
  std::uint64_t fingerprint = 0;  ///< Of the simulation: rigor/io/trajectory/fingerprint.hpp.
  State state;
  Audit audit;  ///< Without method and bodies, which the scene and the state tell.
};

/// The bytes of a checkpoint's file.
std::string checkpoint_bytes(const Checkpoint& checkpoint);
/// Writes a checkpoint; a file of that name is replaced at one instant, so that there is always a whole one.
/// FileError.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);
/// Reads it back. Throws InputError if the file is none, is damaged, or is of another simulation than the one
/// with this fingerprint.
Checkpoint read_checkpoint(const std::filesystem::path& path, std::uint64_t fingerprint);

/// The books of a run in two parts: sums and largest values of both, the start of the first, the end of the
/// second. (A rise of energy is measured within each part.)
Audit joined_audit(const Audit& first, const Audit& second);

}  // namespace rigor
