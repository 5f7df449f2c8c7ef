#include "apps/command_line.hpp"
#include "apps/commands.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/broken_promise.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/study/formula/time_formula.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace rigor {
namespace {

/// Runs the command of the command line; every error ends here, as lines on stderr and an exit code.
ExitCode run_program(int argc, const char* const* argv) {
  try {
    const ParsedCommandLine parsed = parse_command_line(argc, argv);
    if (!parsed.command) return parsed.exit_code;
    return std::visit([](const auto& options) { return execute(options); }, *parsed.command);
  } catch (const UsageError& error) {
    print_error(error.what());
    return exit_usage;
  } catch (const InputError& error) {
    for (const std::string& message : error.messages()) print_error(message);
    return exit_bad_input;
  } catch (const FileError& error) {
    print_error(error.what());
    return exit_file_error;
  } catch (const BrokenPromise& error) {
    print_error(fmt::format("{}; this is a defect of the program, please report it", error.what()));
    return exit_stopped;
  } catch (const Interrupted&) {
    print_error("interrupted");
    return exit_interrupted;
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
    return exit_file_error;
  } catch (const std::exception& error) {
    print_error(error.what());
    return exit_file_error;
  }
}

}  // namespace
}  // namespace rigor

int main(int argc, char** argv) {
  rigor::use_time_formulas();
  // A file beyond the size limit is an error like a full disk, and must not end the process.
  std::signal(SIGXFSZ, SIG_IGN);
  const int code = rigor::run_program(argc, argv);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    rigor::print_error("cannot write to the standard output");
    return rigor::exit_file_error;
  }
  return code;
}
