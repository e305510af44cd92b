// SPDX-License-Identifier: Apache-2.0
// Files are read back by OpenImageIO itself.
#include "kernels/half.h"
#include "renderer/atomic_file.h"
#include "renderer/image_file.h"
#include "renderer/sequence_file.h"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <random>

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

TEST_CASE("image file: a picture in halves makes the file of the same picture in floats") {
    const Image floats = gradient(37, 23);
    Image halves;
    halves.fit(37, 23, true);
    std::transform(floats.rgb.begin(), floats.rgb.end(), halves.halves.begin(), half_bits);
    ImageEncoder encoder;
    const ImageFileSettings settings{.format = ImageFormat::exr, .type = SampleType::half};
    CHECK(encoder.encode(halves, settings) == encoder.encode(floats, settings));
}

TEST_CASE("image file: a 16-bit PNG of the Raw view holds the linear numbers") {
    const Image image = gradient(64, 64);
    const ReadBack file = write_and_read(
        image, {.format = ImageFormat::png, .type = SampleType::uint16, .facts = {.color_encoding = "Linear"}},
        "raw.png");
    for (size_t i = 0; i < image.rgb.size(); ++i)
        REQUIRE(file.levels[i] == uint16_t(std::floor(double(image.rgb[i]) * 65535 + 0.5)));
    CHECK(file.spec.get_float_attribute("oiio:Gamma") == doctest::Approx(1.0f));
}

TEST_CASE("image file: PNG says how its colours are encoded") {
    const Image image = gradient(8, 8);
    const auto space = [&](const char* encoding) {
        const ReadBack file = write_and_read(image, {.facts = {.color_encoding = encoding}}, "space.png");
        return file.spec.get_string_attribute("oiio:ColorSpace");
    };
    CHECK(space("sRGB") == "sRGB");
    CHECK(space("Linear") == "Linear");
    CHECK(space("Gamma2.4") == "Gamma2.4");
}

TEST_CASE("image file: PNG keeps every level of pictures of any size, smooth or noisy") {
    std::minstd_rand random(5);
    for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 300u}, {300u, 1u}, {7u, 5u}, {613u, 401u}})
        for (const bool is_noisy : {false, true})
            for (const SampleType type : {SampleType::uint8, SampleType::uint16}) {
                CAPTURE(width);
                CAPTURE(height);
                CAPTURE(is_noisy);
                Image image = gradient(width, height);
                for (float& value : image.rgb)
                    value = is_noisy ? float(random() % 65536) / 65535.0f : value;
                const ReadBack file = write_and_read(image, {.type = type}, "any.png");
                const double most = type == SampleType::uint8 ? 255 : 65535;
                size_t off = 0;
                for (size_t i = 0; i < image.rgb.size(); ++i)
                    off += file.levels[i] != std::floor(double(image.rgb[i]) * most + 0.5) * 65535 / most;
                CHECK(off == 0);
            }
}

TEST_CASE("image file: levels that an image has already are those of its file") {
    Image image = gradient(3, 2);
    image.levels.assign(18, 200);
    const ReadBack file = write_and_read(image, {}, "levels.png");
    CHECK(file.levels == std::vector<uint16_t>(18, 200 * 257));
}

TEST_CASE("image file: every format can be read whatever its colours are called") {
    for (const auto& [format, name] : {std::pair{ImageFormat::png, "named.png"},
                                       {ImageFormat::tiff, "named.tif"},
                                       {ImageFormat::jpeg, "named.jpg"},
                                       {ImageFormat::exr, "named.exr"}})
        for (const char* encoding : {"sRGB", "Linear", "Gamma2.4", ""}) {
            CAPTURE(name);
            CAPTURE(encoding);
            const ReadBack file = write_and_read(
                gradient(8, 8),
                {.format = format, .type = choose_sample_type(format, {}), .facts = {.color_encoding = encoding}},
                name);
            CHECK(file.spec.width == 8);
        }
}

TEST_CASE("image file: EXR has its facts under the names that others know") {
    const std::array<float, 8> rec709{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
    std::array<float, 16> matrix{};
    for (size_t i = 0; i < 16; ++i)
        matrix[i] = float(i) / 4;
    ImageFileSettings settings{.format = ImageFormat::exr, .type = SampleType::half};
    settings.facts = {.scene = "ball.scn",
                      .hash = "00112233445566778899aabbccddeeff",
                      .color_encoding = "Linear",
                      .chromaticities = rec709,
                      .color_interop_id = "lin_rec709_scene",
                      .frame = 86400 + 25,
                      .rate = FrameRate{24, 1},
                      .world_to_camera = matrix,
                      .world_to_ndc = matrix};
    const ReadBack file = write_and_read(gradient(8, 8), settings, "meta.exr");
    CHECK(file.spec.get_string_attribute("colorInteropID") == "lin_rec709_scene");
    CHECK(file.spec.get_string_attribute("proxima:scene") == "ball.scn");
    CHECK(file.spec.get_int_attribute("proxima:frame") == 86425);
    CHECK(file.spec.get_string_attribute("proxima:hash") == settings.facts.hash);
    const auto numbers = [&](const char* name, size_t count) {
        const auto* found = file.spec.find_attribute(name);
        REQUIRE(found);
        REQUIRE(size_t(found->type().basevalues()) == count);
        const auto* values = static_cast<const float*>(found->data());
        return std::vector<float>(values, values + count);
    };
    CHECK(numbers("chromaticities", 8) == std::vector<float>(rec709.begin(), rec709.end()));
    CHECK(numbers("worldToCamera", 16) == std::vector<float>(matrix.begin(), matrix.end()));
    CHECK(numbers("worldToNDC", 16) == std::vector<float>(matrix.begin(), matrix.end()));
    const auto* rate = file.spec.find_attribute("FramesPerSecond");
    REQUIRE(rate);
    CHECK(static_cast<const int*>(rate->data())[0] == 24);
    CHECK(file.spec["smpte:TimeCode"].get() == "01:00:01:01");
    CHECK_FALSE(file.spec.find_attribute("DateTime"));
    CHECK_FALSE(file.spec.find_attribute("capDate"));
}

TEST_CASE("image file: formats that know texts alone have the facts as a sentence") {
    for (const auto& [format, name] :
         {std::pair{ImageFormat::png, "text.png"}, {ImageFormat::tiff, "text.tif"}, {ImageFormat::jpeg, "text.jpg"}}) {
        CAPTURE(name);
        ImageFileSettings settings{.format = format};
        settings.facts = {.scene = "ball.scn", .hash = "00112233445566778899aabbccddeeff", .frame = -7};
        const ReadBack file = write_and_read(gradient(8, 8), settings, name);
        CHECK(file.spec.get_string_attribute("ImageDescription") ==
              "frame -7 of ball.scn, hash 00112233445566778899aabbccddeeff");
    }
}

TEST_CASE("image file: EXR is compressed as asked, and all but dwaa keep every bit") {
    const Image image = gradient(64, 40);
    struct Row {
        Compression compression;
        const char* name;
    };
    for (const Row& row : {Row{Compression::zip, "zip"}, Row{Compression::zips, "zips"}, Row{Compression::piz, "piz"},
                           Row{Compression::none, "none"}, Row{Compression::dwaa, "dwaa"}}) {
        CAPTURE(row.name);
        const ReadBack file = write_and_read(
            image, {.format = ImageFormat::exr, .type = SampleType::float32, .compression = row.compression},
            "packed.exr");
        CHECK(file.spec.get_string_attribute("compression").find(row.name) == 0);
        if (row.compression != Compression::dwaa)
            CHECK(file.rgb == image.rgb);
        for (size_t i = 0; i < image.rgb.size(); ++i)
            REQUIRE(std::abs(file.rgb[i] - image.rgb[i]) < 0.01f);
    }
}

TEST_CASE("image file: a GIF holds its pictures in order, each for its time") {
    ImageFileSettings settings{.format = ImageFormat::gif};
    settings.facts.rate = FrameRate{25, 1};
    SequenceFile file("moving.gif", encoder().encode_sequence(16, 8, settings));
    const auto grey = [](uint8_t level) { return std::vector<uint8_t>(16 * 8 * 3, level); };
    file.add(2, grey(200));
    file.add(0, grey(0));
    file.add(1, grey(100));
    file.finish();
    const auto input = OIIO::ImageInput::open("moving.gif");
    REQUIRE(input);
    for (int i = 0; i < 3; ++i) {
        REQUIRE(input->seek_subimage(i, 0));
        std::vector<uint8_t> levels(16 * 8 * size_t(input->spec().nchannels));
        REQUIRE(input->read_image(i, 0, 0, -1, OIIO::TypeDesc::UINT8, levels.data()));
        CHECK(std::abs(int(levels[0]) - i * 100) <= 8); // a palette has fewer bits
        const auto* rate = input->spec().find_attribute("FramesPerSecond");
        REQUIRE(rate);
        CHECK(static_cast<const int*>(rate->data())[0] / static_cast<const int*>(rate->data())[1] == 25);
    }
    CHECK_FALSE(input->seek_subimage(3, 0));
    std::filesystem::remove("moving.gif");
}

TEST_CASE("image file: the same picture gives the same bytes") {
    const Image image = gradient(97, 61);
    for (const ImageFormat format : {ImageFormat::png, ImageFormat::exr, ImageFormat::tiff, ImageFormat::jpeg}) {
        const ImageFileSettings settings{.format = format,
                                         .type = choose_sample_type(format, {}),
                                         .facts = {.color_encoding = format == ImageFormat::exr ? "Linear" : "sRGB"}};
        CAPTURE(int(format));
        CHECK(encoder().encode(image, settings) == encoder().encode(image, settings));
    }
}

TEST_CASE("image file: dither rounds by chance, the same each time, and keeps the mean") {
    const Image image{256, 256, std::vector<float>(256 * 256 * 3, 100.25f / 255)};
    const std::vector<uint8_t> levels = quantize_to_bytes(image, true);
    CHECK(levels == quantize_to_bytes(image, true));
    double sum = 0;
    for (const uint8_t level : levels) {
        REQUIRE((level == 100 || level == 101));
        sum += level;
    }
    CHECK(sum / double(levels.size()) == doctest::Approx(100.25).epsilon(1e-4));
    const Image ends{2, 1, {0, 1, 0, 1, -5, 7}};
    CHECK(quantize_to_bytes(ends, true) == std::vector<uint8_t>{0, 255, 0, 255, 0, 255});
}
