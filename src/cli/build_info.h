#pragma once

#include <string>

namespace raytracing {

/// Whether the compiler optimised this build.
bool is_optimised();

/// "0.1.0"
std::string program_version();

/// Build type, compiler and instruction set on one line, as it stands in picture headers.
std::string build_description();

/// A hash of the running program's file, in hexadecimal digits; "unknown" where the system does not
/// show it.
std::string program_hash();

/// Processor and number of its threads, as far as the system tells.
std::string machine_description();

/// What --version prints: version, build, instruction set, libraries and formats, line by line.
std::string version_text();

}  // namespace raytracing
