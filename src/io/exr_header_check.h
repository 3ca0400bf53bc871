#pragma once

#include <string>

namespace raytracing {

/// Throws InputError unless the sizes that the header of this EXR file states are those of what it
/// holds. OpenEXR makes room for what an attribute claims before it finds out that the file is
/// shorter, and takes what it was not told to take from the next attribute.
void check_exr_header_sizes(const std::string& bytes);

}  // namespace raytracing
