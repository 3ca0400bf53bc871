#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "raytracing/io/image.h"
#include "refusal.h"
#include "support/oiio.h"
#include "support/temp_dir.h"

// Which channels, parts and windows of a file are read.

namespace raytracing {
namespace {

using Names = std::vector<std::string>;

/// One pixel a part; the channels of part p have the values 10 p, 10 p + 1, ...
std::string write_parts(const TempDir& folder,
                        const std::vector<std::pair<std::string, Names>>& parts) {
  std::vector<OIIO::ImageSpec> specs;
  for (const auto& [name, channels] : parts) {
    OIIO::ImageSpec spec(1, 1, static_cast<int>(channels.size()), OIIO::TypeFloat);
    spec.channelnames = channels;
    if (!name.empty()) spec.attribute("oiio:subimagename", name);
    specs.push_back(spec);
  }
  const std::string path = folder / "x.exr";
  const auto output = OIIO::ImageOutput::create(path);
  if (!output->open(path, static_cast<int>(specs.size()), specs.data()))
    throw std::runtime_error(output->geterror());
  for (std::size_t p = 0; p < specs.size(); ++p) {
    if (p > 0) output->open(path, specs[p], OIIO::ImageOutput::AppendSubimage);
    std::vector<float> values;
    for (int c = 0; c < specs[p].nchannels; ++c)
      values.push_back(static_cast<float>(10 * p) + static_cast<float>(c));
    if (!output->write_image(OIIO::TypeFloat, values.data()))
      throw std::runtime_error(output->geterror());
  }
  output->close();
  return path;
}

using Values = std::vector<float>;

TEST(Layers, ThePictureItselfNeedsNoNote) {
  const TempDir folder;
  const ImageData image =
      read_image(write_parts(folder, {{"", {"R", "G", "B", "albedo.R", "albedo.G", "albedo.B"}}}));
  EXPECT_EQ(image.values, (Values{0, 1, 2}));
  EXPECT_EQ(image.channels, (Names{"R", "G", "B"}));
  EXPECT_EQ(image.notes, Names());
}

TEST(Layers, StatisticsOfOursAreReadAlong) {
  const TempDir folder;
  const ImageData image = read_image(write_parts(
      folder, {{"", {"R", "G", "B", "depth.Z", "variance.R", "variance.G", "variance.B"}}}));
  EXPECT_EQ(image.channels, (Names{"R", "G", "B", "variance.R", "variance.G", "variance.B"}));
  EXPECT_EQ(image.values, (Values{0, 1, 2, 4, 5, 6}));
}

TEST(Layers, TheNamedOneIsRead) {
  const TempDir folder;
  const std::string path = write_parts(
      folder, {{"", {"R", "G", "B", "direct.R", "direct.G", "direct.B", "variance.R"}}});
  const ImageData image = read_image(path, "direct");
  EXPECT_EQ(image.values, (Values{3, 4, 5}));
  EXPECT_EQ(image.channels, (Names{"R", "G", "B"}));
  EXPECT_EQ(image.notes, (Names{"its layer 'direct' was read"}));
  EXPECT_EQ(refusal(path, "indirect"), "has no layer 'indirect'; its layers are '', 'direct'");
}

TEST(Layers, BlendersCombinedIsThePicture) {
  const TempDir folder;
  const Names channels{"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B",
                       "ViewLayer.DiffDir.R",  "ViewLayer.DiffDir.G",  "ViewLayer.DiffDir.B",
                       "ViewLayer.Depth.Z"};
  const std::string path = write_parts(folder, {{"", channels}});
  const ImageData image = read_image(path);
  EXPECT_EQ(image.values, (Values{0, 1, 2}));
  EXPECT_EQ(image.notes, (Names{"its layer 'ViewLayer.Combined' was read"}));
  EXPECT_EQ(read_image(path, "DiffDir").values, (Values{3, 4, 5}));
  EXPECT_EQ(read_image(path, "ViewLayer.DiffDir").values, (Values{3, 4, 5}));
}

TEST(Layers, SeveralWithoutABeautyAreListed) {
  const TempDir folder;
  const std::string path =
      write_parts(folder, {{"", {"a.R", "a.G", "a.B", "b.R", "b.G", "b.B", "c.Z"}}});
  EXPECT_EQ(refusal(path),
            "has several layers, none of which is called beauty or Combined; its layers are 'a', "
            "'b'");
  EXPECT_EQ(read_image(path, "b").values, (Values{3, 4, 5}));
}

TEST(Layers, OfSeveralPartsTheBeautyOrTheFirstIsRead) {
  const TempDir folder;
  const Names rgb{"R", "G", "B"};
  std::string path = write_parts(folder, {{"depth", {"Z"}}, {"diffuse", rgb}, {"beauty", rgb}});
  EXPECT_EQ(read_image(path).values, (Values{20, 21, 22}));
  EXPECT_EQ(read_image(path).notes, (Names{"its layer 'beauty' was read"}));
  EXPECT_EQ(read_image(path, "diffuse").values, (Values{10, 11, 12}));
  path = write_parts(folder, {{"left", rgb}, {"right", rgb}});
  EXPECT_EQ(read_image(path).values, (Values{0, 1, 2}));
  EXPECT_EQ(read_image(path).notes, (Names{"its layer 'left' was read"}));
}

TEST(Layers, LuminanceAloneIsGrey) {
  const TempDir folder;
  const ImageData image = read_image(write_parts(folder, {{"", {"Y"}}}));
  EXPECT_EQ(image.values, (Values{0, 0, 0}));
  EXPECT_EQ(image.notes, (Names{"it has one channel, which was read as red, green and blue"}));
}

TEST(Layers, AVectorIsReadWhereItIsNamed) {
  const TempDir folder;
  const std::string path =
      write_parts(folder, {{"", {"R", "G", "B", "normal.X", "normal.Y", "normal.Z", "depth.Z"}}});
  EXPECT_EQ(read_image(path).values, (Values{0, 1, 2}));
  EXPECT_EQ(read_image(path, "normal").values, (Values{3, 4, 5}));
  EXPECT_EQ(refusal(write_parts(folder, {{"", {"X", "Y", "Z"}}})),
            "has no channels R, G and B; its channels are 'X', 'Y', 'Z'");
}

TEST(Layers, TransparencyOfAnExrIsTold) {
  const TempDir folder;
  const ImageData image = read_image(write_parts(folder, {{"", {"R", "G", "B", "A"}}}));
  EXPECT_EQ(image.values, (Values{0, 1, 2}));
  EXPECT_EQ(image.notes,
            (Names{"it has transparent pixels, which were read as they are over black"}));
}

TEST(Layers, WithoutAPictureTheChannelsAreListed) {
  const TempDir folder;
  EXPECT_EQ(refusal(write_parts(folder, {{"", {"r", "g", "b"}}})),
            "has no channels R, G and B; its channels are 'r', 'g', 'b'");
  EXPECT_EQ(refusal(write_parts(folder, {{"", {"BY", "RY", "Y"}}})),
            "has no channels R, G and B; its channels are 'Y', 'BY', 'RY'");
}

TEST(Layers, DeepImagesAreRefused) {
  const TempDir folder;
  OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeFloat);
  spec.channelnames = {"R", "G", "B"};
  spec.deep = true;
  const std::string path = folder / "x.exr";
  const auto output = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(output->open(path, spec)) << output->geterror();
  OIIO::DeepData data(spec);
  data.set_samples(0, 1);
  ASSERT_TRUE(output->write_deep_image(data)) << output->geterror();
  output->close();
  EXPECT_EQ(refusal(path), "deep images cannot be read");
}

TEST(Windows, OfACropAreKept) {
  const TempDir folder;
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeFloat);
  spec.x = 3;
  spec.y = 2;
  spec.full_width = 18;
  spec.full_height = 14;
  const Values values{1, 2, 3, 4, 5, 6};
  const std::string path = write_oiio(folder, "x.exr", spec, values);
  const ImageData image = read_image(path);
  EXPECT_EQ(image.values, values);
  EXPECT_EQ(image.whole, (PixelWindow{-3, -2, 18, 14}));
  const ImageData again = read_image(folder.write("y.exr", encode_image(image, "exr")));
  EXPECT_EQ(again.whole, image.whole);
  EXPECT_EQ(again.values, values);
}

TEST(Layers, TheLargestMipLevelIsThePicture) {
  const TempDir folder;
  const OIIO::ImageBuf large =
      OIIO::ImageBufAlgo::fill({5.0f, 6.0f, 7.0f}, OIIO::ROI(0, 64, 0, 64, 0, 1, 0, 3));
  const std::string path = folder / "x.exr";
  OIIO::ImageSpec settings;
  settings.attribute("maketx:fileformatname", "openexr");
  ASSERT_TRUE(
      OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, large, path, settings));
  const ImageData image = read_image(path);
  EXPECT_EQ(image.width, 64);
  EXPECT_EQ(image.values[0], 5);
  EXPECT_EQ(image.notes, (Names{"its largest mip level was read"}));
}

}  // namespace
}  // namespace raytracing
