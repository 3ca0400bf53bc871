#pragma once

#include <cstdint>
#include <string>

#include "raytracing/render/provenance.h"

namespace raytracing {

/// Returns whether the compiler optimised this build.
bool is_optimised();

/// Returns the facts about the program and the machine: software, build, machine.
RunFacts program_facts();

/// Returns a hash of the running program's file, in hexadecimal digits; "unknown" where the system
/// does not show it.
std::string program_hash();

/// Returns the largest resident memory of this process so far.
std::uint64_t peak_rss_bytes();

/// Returns the text of --version: version, build, instruction set, libraries and formats, line by
/// line.
std::string version_text();

}  // namespace raytracing
