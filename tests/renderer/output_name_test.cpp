// SPDX-License-Identifier: Apache-2.0
#include "renderer/errors.h"
#include "renderer/output_name.h"

#include <doctest/doctest.h>

using namespace proxima;

TEST_CASE("output name: hashes and printf's form become the frame number") {
    struct Row {
        const char* pattern;
        int64_t frame;
        const char* path;
    };
    const Row rows[] = {
        {"f.####.png", 7, "f.0007.png"},   {"f.#.png", 7, "f.0007.png"},
        {"f.##.png", 7, "f.07.png"},       {"f.##.png", 1234, "f.1234.png"},
        {"f.%04d.exr", 7, "f.0007.exr"},   {"f.%d.exr", 7, "f.7.exr"},
        {"####.png", -1, "-0001.png"},     {"job#1/100%d/f###.tif", 12, "job#1/100%d/f012.tif"},
        {"still.jpg", 12, "still.jpg"},    {"50%.png", 0, "50%.png"},
        {"/tmp/a.JPEG", 0, "/tmp/a.JPEG"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.pattern);
        CHECK(OutputName(row.pattern).path(row.frame) == row.path);
    }
    CHECK(OutputName("f.####.png").has_frame_number());
    CHECK_FALSE(OutputName("job#1/f.png").has_frame_number());
}

TEST_CASE("output name: a name that cannot be used is refused with what to write") {
    CHECK_THROWS_WITH(
        OutputName("picture"),
        "-o picture: the name has no ending that says what to write; end the name in .png, .exr, .tif, .jpg or .gif");
    CHECK_THROWS_WITH(OutputName("a.bmp"),
                      "-o a.bmp: no picture is written as '.bmp'; end the name in .png, .exr, .tif, .jpg or .gif");
    CHECK_THROWS_AS(OutputName("a##b##.png"), UsageError);
    CHECK_THROWS_AS(OutputName("a##b%04d.png"), UsageError);
    CHECK_THROWS_AS(OutputName("%040d.png"), UsageError);
    CHECK_THROWS_AS(OutputName(std::string(100, '#') + ".png"), UsageError);
}

TEST_CASE("output name: only EXR has a choice of compression") {
    CHECK(choose_compression(ImageFormat::exr, {}) == Compression::zip);
    CHECK(choose_compression(ImageFormat::exr, "dwaa") == Compression::dwaa);
    CHECK(choose_compression(ImageFormat::exr, "none") == Compression::none);
    CHECK(choose_compression(ImageFormat::png, {}) == Compression::zip);
    CHECK_THROWS_WITH(choose_compression(ImageFormat::png, "zip"),
                      "--compression zip: only .exr files have a choice; leave it out");
    CHECK_THROWS_WITH(choose_compression(ImageFormat::exr, "zap"),
                      "--compression zap: not one of dwaa, none, piz, zip, zips; did you mean zip?");
}

TEST_CASE("output name: bits fit the type of file") {
    CHECK(choose_sample_type(ImageFormat::png, {}) == SampleType::uint8);
    CHECK(choose_sample_type(ImageFormat::png, "16") == SampleType::uint16);
    CHECK(choose_sample_type(ImageFormat::exr, {}) == SampleType::half);
    CHECK(choose_sample_type(ImageFormat::exr, "float") == SampleType::float32);
    CHECK(choose_sample_type(ImageFormat::tiff, {}) == SampleType::uint8);
    CHECK(choose_sample_type(ImageFormat::tiff, "float") == SampleType::float32);
    CHECK(choose_sample_type(ImageFormat::gif, {}) == SampleType::uint8);
    CHECK(choose_sample_type(ImageFormat::jpeg, "8") == SampleType::uint8);
    CHECK_THROWS_WITH(choose_sample_type(ImageFormat::png, "half"),
                      "--bits half: this type of file does not hold it; it holds 8, 16");
    CHECK_THROWS_AS(choose_sample_type(ImageFormat::jpeg, "16"), UsageError);
    CHECK_THROWS_AS(choose_sample_type(ImageFormat::exr, "8"), UsageError);
}
