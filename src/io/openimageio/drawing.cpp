#include "drawing.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <stdexcept>
#include <string>

#include "raytracing/io/errors.h"

namespace raytracing::openimageio {

std::vector<float> magma(const std::vector<float>& values) {
  if (values.empty()) return {};
  std::vector<float> row = values, colours(3 * values.size());
  const OIIO::ImageSpec spec(static_cast<int>(values.size()), 1, 1, OIIO::TypeFloat);
  const OIIO::ImageBuf source(spec, row.data());
  const OIIO::ImageBuf mapped = OIIO::ImageBufAlgo::color_map(source, 0, "magma");
  if (!mapped.get_pixels(mapped.roi(), OIIO::TypeFloat, colours.data()))
    throw std::runtime_error("OpenImageIO has no colour map magma: " + mapped.geterror());
  return colours;
}

void draw_labels(ImageData& image, const std::vector<TextLabel>& labels) {
  const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeFloat);
  OIIO::ImageBuf canvas(spec, image.values.data());  // which draws on these values
  for (const TextLabel& label : labels)
    if (!OIIO::ImageBufAlgo::render_text(
            canvas, label.x, label.y, label.text, label.height, "DejaVuSans", {1.0f, 1.0f, 1.0f},
            OIIO::ImageBufAlgo::TextAlignX::Center, OIIO::ImageBufAlgo::TextAlignY::Top))
      throw OutputError(
          "the font DejaVu Sans of the labels is not found; on Debian: apt-get install "
          "fonts-dejavu-core (" +
          canvas.geterror() + ")");
}

}  // namespace raytracing::openimageio
