#pragma once
// What is checked before the libraries below OpenImageIO see a file: they allocate what a file
// claims before they find out that it is shorter, and do not look at all of its colour facts.

#include <string>

namespace raytracing::openimageio {

/// Throws InputError unless the sizes that the header of this EXR file states are those of what it
/// holds. OpenEXR allocates what an attribute claims before it finds out that the file is shorter,
/// and continues into the next attribute when one claims too little.
void check_exr_sizes(const std::string& bytes);

/// What the chunks of a PNG file say of its colours.
struct PngColours {
  double gamma = 0;          ///< the exponent that decodes it by gAMA; 0 for the curve of sRGB
  bool has_profile = false;  ///< which the library leaves out when it is damaged
};

/// Returns what applies of the chunks cICP, iCCP, sRGB and gAMA, in this order (PNG 3rd edition,
/// 4.3). Throws InputError for a chunk that is cut off or damaged, and for a chunk cICP of a space
/// other than sRGB.
PngColours check_png_chunks(const std::string& bytes);

}  // namespace raytracing::openimageio
