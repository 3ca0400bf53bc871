#pragma once
// What is checked before the libraries below OpenImageIO see a file: they allocate what a file
// claims before they find out that it is shorter, and do not look at all of its colour facts.

#include <array>
#include <optional>
#include <string>

namespace raytracing::openimageio {

/// Throws InputError unless the sizes that the header of this EXR file states are those of what it
/// holds. OpenEXR allocates what an attribute claims before it finds out that the file is shorter,
/// and continues into the next attribute when one claims too little.
void check_exr_sizes(const std::string& bytes);

/// What a file says of its colours where the library does not tell.
struct StatedColours {
  double gamma = 0;  ///< the exponent that decodes integers; 0 for the curve of sRGB
  /// x and y of red, green, blue and white; empty for those of Rec. 709.
  std::optional<std::array<float, 8>> chromaticities = {};
  bool has_profile = false;  ///< which the library leaves out when it is damaged
};

/// Returns what applies of the chunks cICP, iCCP, sRGB, gAMA and cHRM of a PNG file, in this order
/// (PNG 3rd edition, 4.3). Throws InputError for a chunk that is cut off or damaged, and for a
/// chunk cICP of a space other than sRGB.
StatedColours check_png_chunks(const std::string& bytes);

/// Returns the PNG file with one more text, in UTF-8 (a chunk iTXt before the pixels).
std::string with_international_text(std::string png, const std::string& keyword,
                                    const std::string& text);

/// Returns the primaries of an HDR file. Throws InputError for factors and exponents in its header
/// that the library does not apply.
StatedColours check_hdr_header(const std::string& bytes);

/// Throws InputError for a PGM or PPM file whose largest value is not 255, which the library
/// rounds.
void check_pnm_header(const std::string& bytes);

}  // namespace raytracing::openimageio
