#pragma once

#include <string_view>

namespace raytracing {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 7, kGlyphAdvance = 6;

/// Whether the pixel (x, y) of a line of text is set; y counts down, x from the text's left end.
/// Knows what the legends of error pictures are written with; other characters are blank.
bool text_pixel(std::string_view text, int x, int y);

}  // namespace raytracing
