// SPDX-License-Identifier: Apache-2.0
// Reading pictures: the numbers as stored, and files that must not be taken for pictures.
#include "parser/source_files.h"
#include "renderer/image_file.h"

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>

using namespace proxima;
namespace fs = std::filesystem;

namespace {

/// A file that is gone with the test.
struct TemporaryPicture {
    fs::path path;
    explicit TemporaryPicture(fs::path path) : path(std::move(path)) {}
    ~TemporaryPicture() { fs::remove(path); }

    template <class Sample> void write(OIIO::ImageSpec spec, const std::vector<Sample>& samples) const {
        const auto output = OIIO::ImageOutput::create(path.string());
        REQUIRE(output);
        REQUIRE(output->open(path.string(), spec));
        REQUIRE(output->write_image(OIIO::BaseTypeFromC<Sample>::value, samples.data()));
        REQUIRE(output->close());
    }
    void cut() const { fs::resize_file(path, fs::file_size(path) * 6 / 10); }
};

std::string refusal(const fs::path& path) {
    try {
        read_image_file(path);
    } catch (const FileError& error) {
        return error.what();
    }
    return "none";
}

std::vector<uint16_t> noise(size_t count) {
    std::vector<uint16_t> values(count);
    uint32_t state = 1;
    for (uint16_t& value : values)
        value = uint16_t((state = state * 1664525u + 1013904223u) >> 16);
    return values;
}

} // namespace

TEST_CASE("image reader: levels of 8 and 16 bits come as they are stored, every one of them") {
    for (const char* name : {"levels.png", "levels.tif"}) {
        std::vector<uint16_t> all(65536 * 3);
        for (size_t i = 0; i < all.size(); ++i)
            all[i] = uint16_t(i / 3);
        const TemporaryPicture file(name);
        file.write(OIIO::ImageSpec(256, 256, 3, OIIO::TypeDesc::UINT16), all);
        const StoredImage wide = read_image_file(name);
        CHECK(wide.type == SampleType::uint16);
        CHECK(wide.width == 256);
        CHECK(wide.channels == 3);
        CHECK(std::equal(all.begin(), all.end(), wide.samples.begin(), wide.samples.end()));

        std::vector<uint8_t> bytes(256 * 3);
        for (size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = uint8_t(i / 3);
        file.write(OIIO::ImageSpec(256, 1, 3, OIIO::TypeDesc::UINT8), bytes);
        const StoredImage narrow = read_image_file(name);
        CHECK(narrow.type == SampleType::uint8);
        CHECK(std::equal(bytes.begin(), bytes.end(), narrow.samples.begin(), narrow.samples.end()));
    }
}

TEST_CASE("image reader: numbers of float files come as they are, infinities too") {
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> samples{-2, 0.1f, 1e30f, infinity, -infinity, 0};
    const TemporaryPicture file("numbers.exr");
    file.write(OIIO::ImageSpec(2, 1, 3, OIIO::TypeDesc::FLOAT), samples);
    const StoredImage image = read_image_file(file.path);
    CHECK(image.type == SampleType::float32);
    CHECK(image.encoding == "Linear");
    CHECK(image.samples == samples);
}

TEST_CASE("image reader: grey becomes three channels, and alpha the fourth, not multiplied") {
    const TemporaryPicture file("grey.png");
    file.write(OIIO::ImageSpec(1, 1, 1, OIIO::TypeDesc::UINT8), std::vector<uint8_t>{7});
    CHECK(read_image_file(file.path).samples == std::vector<float>{7, 7, 7});
    OIIO::ImageSpec spec(1, 1, 2, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    file.write(spec, std::vector<uint8_t>{7, 100});
    CHECK(read_image_file(file.path).samples == std::vector<float>{7, 7, 7, 100});
    spec = OIIO::ImageSpec(1, 1, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    file.write(spec, std::vector<uint8_t>{200, 7, 9, 100});
    const StoredImage image = read_image_file(file.path);
    CHECK(image.channels == 4);
    CHECK(image.samples == std::vector<float>{200, 7, 9, 100});
}

TEST_CASE("image reader: channels beside the colour are named, and their order does not matter") {
    const TemporaryPicture file("layers.exr");
    OIIO::ImageSpec spec(1, 1, 5, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"Z", "B", "depth.R", "G", "R"};
    file.write(spec, std::vector<float>{9, 3, 8, 2, 1});
    const StoredImage image = read_image_file(file.path);
    CHECK(image.samples == std::vector<float>{1, 2, 3});
    CHECK(image.ignored_channels.size() == 2);
}

TEST_CASE("image reader: a file that was cut short is no picture") {
    const std::vector<uint16_t> samples = noise(64 * 64 * 3);
    for (const char* name : {"cut.png", "cut.jpg", "cut.tif", "cut.exr"}) {
        CAPTURE(name);
        const TemporaryPicture file(name);
        const bool is_exr = file.path.extension() == ".exr";
        file.write(OIIO::ImageSpec(64, 64, 3, is_exr ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8), samples);
        CHECK(refusal(name) == "none");
        file.cut();
        CHECK(refusal(name).starts_with(std::string(name) + ": not a readable picture: "));
    }
}

TEST_CASE("image reader: what is not one flat picture is refused with the reason") {
    CHECK(refusal("nowhere.png") == "nowhere.png: cannot be read: No such file or directory");
    CHECK(refusal("/") == "/: cannot be read: it is not a file");
    const TemporaryPicture text("text.png");
    std::ofstream(text.path) << "not a picture";
    CHECK(refusal(text.path).starts_with("text.png: not a readable picture: "));

    const TemporaryPicture crop("crop.exr");
    OIIO::ImageSpec spec(2, 2, 3, OIIO::TypeDesc::FLOAT);
    spec.full_width = 4;
    crop.write(spec, std::vector<float>(12));
    CHECK(refusal(crop.path) == "crop.exr: not a readable picture: its pixels cover another area than its frame; write "
                                "it with the whole frame and no more");
    spec = OIIO::ImageSpec(2, 2, 3, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"X", "Y", "Z"};
    crop.write(spec, std::vector<float>(12));
    CHECK(refusal(crop.path) == "crop.exr: not a readable picture: it has no channels R, G and B");
    const TemporaryPicture integers("integers.tif");
    integers.write(OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::UINT32), std::vector<uint32_t>(3));
    CHECK(refusal(integers.path) == "integers.tif: not a readable picture: its samples are of type uint; only 8 and 16 "
                                    "bits, half and float are compared");
}
