// SPDX-License-Identifier: Apache-2.0
// Files are read back by OpenImageIO itself.
#include "renderer/atomic_file.h"
#include "renderer/image_file.h"

#include <OpenImageIO/imageio.h>
#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>

using namespace proxima;

namespace {

ImageEncoder& encoder() {
    static ImageEncoder instance;
    return instance;
}

struct ReadBack {
    OIIO::ImageSpec spec;
    std::vector<float> rgb;
    std::vector<uint16_t> levels; ///< at 16 bits
};

ReadBack write_and_read(const Image& image, const ImageFileSettings& settings, const std::string& name) {
    write_file(name, encoder().encode(image, settings));
    const auto input = OIIO::ImageInput::open(name);
    REQUIRE(input);
    ReadBack result;
    result.spec = input->spec();
    result.rgb.resize(image.rgb.size());
    result.levels.resize(image.rgb.size());
    REQUIRE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, result.rgb.data()));
    REQUIRE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT16, result.levels.data()));
    std::filesystem::remove(name);
    return result;
}

Image gradient(uint32_t width, uint32_t height) {
    Image image{width, height, std::vector<float>(size_t(width) * height * 3)};
    for (size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = float(i) / float(image.rgb.size() - 1);
    return image;
}

} // namespace

TEST_CASE("image file: what was written is read back, in every format and type") {
    struct Row {
        const char* name;
        ImageFormat format;
        SampleType type;
        double tolerance;
        OIIO::TypeDesc stored;
    };
    const Row rows[] = {
        {"a.png", ImageFormat::png, SampleType::uint8, 0.5 / 255 + 1e-6, OIIO::TypeDesc::UINT8},
        {"a.png", ImageFormat::png, SampleType::uint16, 0.5 / 65535 + 1e-6, OIIO::TypeDesc::UINT16},
        {"a.tif", ImageFormat::tiff, SampleType::uint8, 0.5 / 255 + 1e-6, OIIO::TypeDesc::UINT8},
        {"a.tif", ImageFormat::tiff, SampleType::uint16, 0.5 / 65535 + 1e-6, OIIO::TypeDesc::UINT16},
        {"a.tif", ImageFormat::tiff, SampleType::float32, 0, OIIO::TypeDesc::FLOAT},
        {"a.exr", ImageFormat::exr, SampleType::half, 1.0 / 2048, OIIO::TypeDesc::HALF},
        {"a.exr", ImageFormat::exr, SampleType::float32, 0, OIIO::TypeDesc::FLOAT},
        {"a.jpg", ImageFormat::jpeg, SampleType::uint8, 0.1, OIIO::TypeDesc::UINT8},
    };
    const Image image = gradient(37, 23);
    for (const Row& row : rows) {
        CAPTURE(row.name);
        CAPTURE(int(row.type));
        const ReadBack file = write_and_read(image, {.format = row.format, .type = row.type}, row.name);
        CHECK(file.spec.width == 37);
        CHECK(file.spec.height == 23);
        CHECK(file.spec.nchannels == 3);
        CHECK(file.spec.format == row.stored);
        CHECK(file.spec.get_string_attribute("Software") == "Proxima " PROXIMA_VERSION);
        double worst = 0;
        for (size_t i = 0; i < image.rgb.size(); ++i)
            worst = std::max(worst, double(std::abs(file.rgb[i] - image.rgb[i])));
        CHECK(worst <= row.tolerance);
    }
}

TEST_CASE("image file: a 16-bit PNG of the Raw view holds the linear numbers") {
    const Image image = gradient(64, 64);
    const ReadBack file = write_and_read(
        image, {.format = ImageFormat::png, .type = SampleType::uint16, .color_encoding = "Linear"}, "raw.png");
    for (size_t i = 0; i < image.rgb.size(); ++i)
        REQUIRE(file.levels[i] == uint16_t(std::floor(double(image.rgb[i]) * 65535 + 0.5)));
    CHECK(file.spec.get_float_attribute("oiio:Gamma") == doctest::Approx(1.0f));
}

TEST_CASE("image file: PNG says how its colours are encoded") {
    const Image image = gradient(8, 8);
    const auto space = [&](const char* encoding) {
        const ReadBack file = write_and_read(image, {.color_encoding = encoding}, "space.png");
        return file.spec.get_string_attribute("oiio:ColorSpace");
    };
    CHECK(space("sRGB") == "sRGB");
    CHECK(space("Linear") == "Linear");
    CHECK(space("Gamma2.4") == "Gamma2.4");
}

TEST_CASE("image file: EXR says which colours its numbers mean") {
    const ReadBack file = write_and_read(gradient(8, 8),
                                         {.format = ImageFormat::exr,
                                          .type = SampleType::half,
                                          .color_encoding = "Linear",
                                          .scene = "ball.scn",
                                          .frame = -7},
                                         "meta.exr");
    CHECK(file.spec.get_string_attribute("colorInteropID") == "lin_rec709_scene");
    CHECK(file.spec.get_string_attribute("proxima:scene") == "ball.scn");
    CHECK(file.spec.get_int_attribute("proxima:frame") == -7);
    CHECK(file.spec.get_string_attribute("compression") == "zip");
    const auto* primaries = file.spec.find_attribute("chromaticities");
    REQUIRE(primaries);
    const auto* values = static_cast<const float*>(primaries->data());
    const float expected[8] = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
    for (int i = 0; i < 8; ++i)
        CHECK(values[i] == expected[i]);
}

TEST_CASE("image file: numbers beyond a half's stay finite in a half file") {
    const Image image{2, 1, {1e30f, -1e30f, 65504.0f, 0, 1, 2}};
    const ReadBack file = write_and_read(image, {.format = ImageFormat::exr, .type = SampleType::half}, "large.exr");
    CHECK(file.rgb == std::vector<float>{65504.0f, -65504.0f, 65504.0f, 0, 1, 2});
}

TEST_CASE("image file: the same picture gives the same bytes") {
    const Image image = gradient(97, 61);
    for (const ImageFormat format : {ImageFormat::png, ImageFormat::exr, ImageFormat::tiff, ImageFormat::jpeg}) {
        const ImageFileSettings settings{.format = format,
                                         .type = choose_sample_type(format, {}),
                                         .color_encoding = format == ImageFormat::exr ? "Linear" : "sRGB"};
        CAPTURE(int(format));
        CHECK(encoder().encode(image, settings) == encoder().encode(image, settings));
    }
}
