// The fuzzers contain what the program loads as a module, so that it is instrumented with them.

#include "raytracing/io/image_library.h"

extern "C" const raytracing::ImageLibrary* raytracing_image_library();

namespace raytracing {

const ImageLibrary& image_library() { return *raytracing_image_library(); }

}  // namespace raytracing
