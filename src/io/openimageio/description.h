#pragma once
// The facts of a picture in the attributes of its file.

#include <OpenImageIO/imageio.h>

#include <string>

#include "raytracing/io/image.h"

namespace raytracing::openimageio {

/// Sets the attributes of a file to be written by the library's format of this name. Throws
/// OutputError for metadata that an attribute of the format itself would replace.
void set_metadata(const ImageMetadata& metadata, const std::string& format, OIIO::ImageSpec& spec);

/// Returns the PNG file with the texts that are not ASCII, which set_metadata() leaves out: the
/// library would write them as Latin-1.
std::string with_other_texts(const ImageMetadata& metadata, std::string png);

/// Returns the texts and numbers that a file states.
ImageMetadata metadata_of(const OIIO::ImageSpec& spec);

}  // namespace raytracing::openimageio
