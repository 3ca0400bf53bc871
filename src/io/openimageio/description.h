#pragma once
// The facts of a picture in the attributes of its file.

#include <OpenImageIO/imageio.h>

#include "raytracing/io/image.h"

namespace raytracing::openimageio {

/// Sets the attributes of a file to be written by the library's format of this name. Throws
/// OutputError for metadata that an attribute of the format itself would replace.
void set_metadata(const ImageMetadata& metadata, const std::string& format, OIIO::ImageSpec& spec);

/// Returns the texts and numbers that a file states.
ImageMetadata metadata_of(const OIIO::ImageSpec& spec);

}  // namespace raytracing::openimageio
