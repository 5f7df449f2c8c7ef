#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace rigor {

/// A suspended run: everything needed to continue it bit for bit, and its audit so far.
struct Checkpoint {
  std::uint64_t fingerprint = 0;  ///< Fingerprint of the simulation: rigor/io/trajectory/fingerprint.hpp.
  State state;
  Audit audit;  ///< Without method and bodies, which come from the scene and the state.
};

/// The bytes of a checkpoint file.
std::string checkpoint_bytes(const Checkpoint& checkpoint);
/// Writes a checkpoint; a file of that name is replaced atomically, so that there is always a complete one.
/// Throws FileError.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);
/// Reads it back. Throws InputError if the file is not a checkpoint, is damaged, belongs to a simulation with
/// another fingerprint, or holds a number or an index that a run of the Model cannot have: a right checksum
/// does not make the values right.
Checkpoint read_checkpoint(const std::filesystem::path& path, std::uint64_t fingerprint, const Model& model);
/// The same of bytes; name appears in messages.
Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name, std::uint64_t fingerprint,
                            const Model& model);

/// Joins the audits of a run in two parts: sums and largest values of both, the start of the first and the
/// end of the second. (A rise of energy is measured within each part.)
Audit joined_audit(const Audit& first, const Audit& second);

}  // namespace rigor
