// SPDX-License-Identifier: Apache-2.0
// Layers of an EXR, read back by OpenImageIO itself.
#include "kernels/half.h"
#include "renderer/atomic_file.h"
#include "renderer/image_file.h"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>

using namespace proxima;

namespace {

constexpr uint32_t width = 37, height = 23;

Image picture_with_layers(bool in_halves) {
    Image image;
    image.fit(width, height, in_halves, true);
    for (size_t i = 0; i < size_t(width) * height * 3; ++i) {
        const float value = float(i) / 3000;
        if (in_halves)
            image.halves[i] = half_bits(value);
        else
            image.rgb[i] = value;
    }
    for (size_t i = 0; i < image.aovs.size(); ++i)
        image.aovs[i] = {.depth = 1000 + float(i) / 7,
                         .normal = {std::sin(float(i)), std::cos(float(i)), -0.25f},
                         .id = 0x01000001u + uint32_t(i), // more than a float can tell apart
                         .steps = uint32_t(i)};
    return image;
}

struct ReadBack {
    OIIO::ImageSpec spec;
    std::unique_ptr<OIIO::ImageInput> input;

    OIIO::TypeDesc type(const char* channel) const { return spec.channelformat(spec.channelindex(channel)); }
    template <class Number> std::vector<Number> samples(const char* channel) const {
        const int index = spec.channelindex(channel);
        std::vector<Number> numbers(size_t(width) * height);
        REQUIRE(input->read_image(0, 0, index, index + 1, OIIO::BaseTypeFromC<Number>::value, numbers.data()));
        return numbers;
    }
};

ReadBack write_and_read(const Image& image, SampleType type, AovLayers layers,
                        Compression compression = Compression::zip) {
    static ImageEncoder encoder;
    write_file("layers.exr",
               encoder.encode(
                   image, {.format = ImageFormat::exr, .type = type, .compression = compression, .layers = layers}));
    ReadBack file;
    file.input = OIIO::ImageInput::open("layers.exr");
    REQUIRE(file.input);
    file.spec = file.input->spec();
    return file;
}

constexpr AovLayers all{true, true, true, true};

} // namespace

TEST_CASE("layers: each has its channels, by name and type, and every number comes back") {
    for (const bool in_halves : {false, true}) {
        const Image image = picture_with_layers(in_halves);
        const ReadBack file = write_and_read(image, SampleType::half, all);
        CHECK(file.spec.nchannels == 9);
        for (const char* color : {"R", "G", "B", "N.X", "N.Y", "N.Z"})
            CHECK(file.type(color) == OIIO::TypeDesc::HALF);
        CHECK(file.type("Z") == OIIO::TypeDesc::FLOAT);
        CHECK(file.type("id") == OIIO::TypeDesc::UINT);
        CHECK(file.type("steps") == OIIO::TypeDesc::FLOAT);
        const auto red = file.samples<float>("R"), depth = file.samples<float>("Z");
        const auto y = file.samples<float>("N.Y"), z = file.samples<float>("N.Z");
        const auto id = file.samples<uint32_t>("id");
        const auto steps = file.samples<float>("steps");
        double worst_red = 0, worst_y = 0;
        for (size_t i = 0; i < image.aovs.size(); ++i) {
            worst_red = std::max(worst_red, std::abs(double(red[i]) - double(3 * i) / 3000));
            worst_y = std::max(worst_y, std::abs(double(y[i]) - double(image.aovs[i].normal.y)));
            REQUIRE(depth[i] == image.aovs[i].depth);
            REQUIRE(z[i] == -0.25f);
            REQUIRE(id[i] == image.aovs[i].id);
            REQUIRE(steps[i] == float(i));
        }
        CHECK(worst_red < 1.0 / 2048);
        CHECK(worst_y < 1.0 / 2048);
    }
}

TEST_CASE("layers: a file has those that are asked for, and the picture as without them") {
    const Image image = picture_with_layers(false);
    const auto channels = [&](AovLayers layers) {
        return write_and_read(image, SampleType::float32, layers).spec.channelnames;
    };
    using Names = std::vector<std::string>;
    CHECK(channels({}) == Names{"R", "G", "B"});
    CHECK(channels({.depth = true}) == Names{"R", "G", "B", "Z"});
    CHECK(channels({.normal = true}) == Names{"R", "G", "B", "N.X", "N.Y", "N.Z"});
    CHECK(channels({.id = true}) == Names{"R", "G", "B", "id"});
    CHECK(channels({.steps = true}) == Names{"R", "G", "B", "steps"});
    for (const SampleType type : {SampleType::half, SampleType::float32}) {
        write_and_read(image, type, {});
        const StoredImage plain = read_image_file("layers.exr");
        write_and_read(image, type, all);
        StoredImage layered = read_image_file("layers.exr");
        CHECK(layered.samples == plain.samples);
        CHECK(layered.type == plain.type);
        std::ranges::sort(layered.ignored_channels);
        CHECK(layered.ignored_channels == Names{"N.X", "N.Y", "N.Z", "Z", "id", "steps"});
    }
}

TEST_CASE("layers: a file that is cut short among them is not whole") {
    write_and_read(picture_with_layers(false), SampleType::half, all);
    const auto size = std::filesystem::file_size("layers.exr");
    for (const auto cut : {size - 1, size - 100, size / 2}) {
        std::filesystem::resize_file("layers.exr", cut);
        CHECK_THROWS(read_image_file("layers.exr"));
    }
    std::filesystem::remove("layers.exr");
}

TEST_CASE("layers: every way to compress keeps every bit of them, dwaa but for N.Y") {
    const Image image = picture_with_layers(false);
    for (const Compression compression :
         {Compression::zip, Compression::zips, Compression::piz, Compression::none, Compression::dwaa}) {
        CAPTURE(int(compression));
        const ReadBack file = write_and_read(image, SampleType::float32, all, compression);
        const auto depth = file.samples<float>("Z"), x = file.samples<float>("N.X"), y = file.samples<float>("N.Y");
        const auto id = file.samples<uint32_t>("id");
        uint32_t wrong = 0, wrong_y = 0;
        for (size_t i = 0; i < image.aovs.size(); ++i) {
            wrong += depth[i] != image.aovs[i].depth || x[i] != image.aovs[i].normal.x || id[i] != image.aovs[i].id;
            wrong_y += y[i] != image.aovs[i].normal.y;
        }
        CHECK(wrong == 0);
        CHECK((wrong_y == 0) == (compression != Compression::dwaa));
    }
}
