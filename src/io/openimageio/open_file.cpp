#include "open_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "raytracing/io/errors.h"

namespace raytracing::openimageio {
namespace {

using std::string_view_literals::operator""sv;

constexpr Format kFormats[] = {{"\x76\x2f\x31\x01"sv, "openexr", "EXR"},
                               {"\x89PNG\r\n\x1a\n"sv, "png", "PNG"},
                               {"II*\0"sv, "tiff", "TIFF"},
                               {"MM\0*"sv, "tiff", "TIFF"},
                               {"II+\0"sv, "tiff", "TIFF"},
                               {"MM\0+"sv, "tiff", "TIFF"},
                               {"\xff\xd8\xff"sv, "jpeg", "JPEG"},
                               {"#?RADIANCE"sv, "hdr", "HDR"},
                               {"#?RGBE"sv, "hdr", "HDR"},
                               {"P1"sv, "pnm", "PNM"},
                               {"P2"sv, "pnm", "PNM"},
                               {"P3"sv, "pnm", "PNM"},
                               {"P4"sv, "pnm", "PNM"},
                               {"P5"sv, "pnm", "PNM"},
                               {"P6"sv, "pnm", "PNM"},
                               {"PF"sv, "pnm", "PFM"},
                               {"Pf"sv, "pnm", "PFM"}};

}  // namespace

const Format& format_of(const std::string& bytes) {
  for (const Format& format : kFormats)
    if (bytes.starts_with(format.magic)) return format;
  throw InputError("not an image of a known format: EXR, PNG, TIFF, JPEG, HDR, PFM or PNM");
}

std::size_t MemoryReader::pread(void* to, std::size_t count, std::int64_t offset) {
  if (offset < 0 || static_cast<std::uint64_t>(offset) >= size()) return 0;
  return IOMemReader::pread(to, std::min(count, size() - static_cast<std::size_t>(offset)), offset);
}

OpenFile::OpenFile(const std::string& bytes)
    : format(format_of(bytes)),
      memory(bytes),
      input(OIIO::ImageInput::create(std::string(format.name))) {
  if (!input) throw InputError(fmt::format("this OpenImageIO reads no {} images", format.title));
  OIIO::ImageSpec hints, spec;
  hints.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::Filesystem::IOProxy* proxy = &memory;
  hints.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  if (!input->open("image." + std::string(format.name), spec, hints)) fail();
  check(true);  // a JPEG file that is cut off opens
}

void OpenFile::fail() const { fail(input->geterror()); }

void OpenFile::fail(std::string why) const {
  if (why.empty()) why = OIIO::geterror();
  why = why.substr(0, why.find('\n'));  // the first of several
  throw InputError(fmt::format("damaged {} image: {}", format.title,
                               why.empty() ? "it cannot be read" : one_line(why)));
}

void OpenFile::check(bool good) const {
  const std::string why = input->geterror();
  if (!good || !why.empty()) fail(why);
}

}  // namespace raytracing::openimageio
