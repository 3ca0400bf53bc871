#include <OpenImageIO/imageio.h>

#include "decode.h"
#include "drawing.h"
#include "encode.h"
#include "raytracing/io/image_library.h"

// The one name that the program looks up in the module.
extern "C" const raytracing::ImageLibrary* raytracing_image_library() {
  using namespace raytracing;
  static const ImageLibrary library{openimageio::endings, openimageio::encode, openimageio::decode,
                                    openimageio::magma, openimageio::draw_labels};
  return &library;
}
