// SPDX-License-Identifier: Apache-2.0
// What is in the files of a run: the golden levels of every view at every depth, what is done about numbers that a file
// cannot hold, and what is written about the frame.
#include "tests/renderer/workplace.h"

#include <cmath>
#include <fmt/format.h>

using namespace proxima::testing;

namespace {

/// 18 % grey on the right, and a disc of a colour on the left.
constexpr const char* flat_scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -z direction z right 2*x up 2*y }
background { rgb 0.18 }
sphere { <-0.5, 0, 5>, 0.45 pigment { rgb <0.5, 0.25, 0.05> } finish { ambient 0 diffuse 0 emission 1 } }
)";

constexpr int left = 8, right = 28; ///< pixels of the middle row

template <class Number> std::vector<Number> pixel(const Workplace& work, const std::string& file, int x) {
    const auto input = OIIO::ImageInput::open((work.folder / file).string());
    REQUIRE(input);
    const int channels = input->spec().nchannels;
    std::vector<Number> all(size_t(input->spec().width) * size_t(input->spec().height) * size_t(channels));
    REQUIRE(input->read_image(0, 0, 0, channels, OIIO::BaseTypeFromC<Number>::value, all.data()));
    const auto first = all.begin() + (12 * input->spec().width + x) * channels;
    return {first, first + 3};
}

OIIO::ImageSpec spec_of(const Workplace& work, const std::string& file) {
    const auto input = OIIO::ImageInput::open((work.folder / file).string());
    REQUIRE(input);
    return input->spec();
}

} // namespace

TEST_CASE("files: a PNG needs the program alone, other formats its image module") {
    const Workplace work("without_module_test");
    fs::create_directory(work.folder / "bin");
    fs::copy_file(PROXIMA_PROGRAM, work.folder / "bin/proxima");
    const auto render = [&](const char* file) {
        return run_process({"bin/proxima", "render", "still.scn", "-o", file, "--size", "32x24", "--device", "cpu"},
                           work.folder, 120);
    };
    CHECK(render("a.png").exit_code == 0);
    CHECK(spec_of(work, "a.png").width == 32);
    const ProcessResult failed = render("a.exr");
    CHECK(failed.exit_code == 3);
    CHECK(says(failed.standard_error, "the image module cannot be loaded"));
}

TEST_CASE("files: every view has its golden levels at every depth") {
    const Workplace work("file_contents_test");
    work.write("flat.scn", flat_scene);
    struct Row {
        const char *display, *view;
        double grey;
        std::array<double, 3> color;
    };
    // Of ACES's configuration cg-config v1.0.0, by OpenColorIO's own tools.
    const Row rows[] = {
        {"sRGB", "Un-tone-mapped", 0.461356, {0.735357, 0.537099, 0.247801}},
        {"sRGB", "ACES 1.0 - SDR Video", 0.355954, {0.634815, 0.450429, 0.164420}},
        {"sRGB", "Raw", 0.18, {0.5, 0.25, 0.05}},
        {"Rec.1886 Rec.709", "Un-tone-mapped", 0.489437, {0.749154, 0.561231, 0.287015}},
        {"Rec.1886 Rec.709", "ACES 1.0 - SDR Video", 0.389530, {}},
        {"Rec.1886 Rec.709", "Raw", 0.18, {0.5, 0.25, 0.05}},
    };
    struct Depth {
        const char *file, *bits;
        double levels, off; ///< that a level may be off by
    };
    const Depth depths[] = {{"a.png", "8", 255, 0.51},
                            {"a.png", "16", 65535, 0.9},
                            {"a.tif", "8", 255, 0.51},
                            {"a.tif", "16", 65535, 0.9},
                            {"a.jpg", "8", 255, 1.01}};
    for (const Row& row : rows)
        for (const Depth& depth : depths) {
            CAPTURE(row.display);
            CAPTURE(row.view);
            CAPTURE(depth.file);
            CAPTURE(depth.bits);
            REQUIRE(work.render({"flat.scn", "-o", depth.file, "--bits", depth.bits, "--display", row.display, "--view",
                                 row.view})
                        .exit_code == 0);
            const auto check = [&](int x, int channel, double expected) {
                const double level = depth.levels == 255 ? pixel<uint8_t>(work, depth.file, x)[size_t(channel)]
                                                         : pixel<uint16_t>(work, depth.file, x)[size_t(channel)];
                CHECK(std::abs(level - expected * depth.levels) <= depth.off);
            };
            check(right, 0, row.grey);
            const bool is_known = row.color[0] > 0 && depth.file != std::string("a.jpg"); // whose blocks blur the edge
            for (int channel = 0; is_known && channel < 3; ++channel)
                check(left, channel, row.color[size_t(channel)]);
        }
    for (const auto& [file, bits] : {std::pair{"a.exr", "half"}, {"a.exr", "float"}, {"a.tif", "float"}}) {
        CAPTURE(bits);
        REQUIRE(work.render({"flat.scn", "-o", file, "--bits", bits}).exit_code == 0);
        CHECK(pixel<float>(work, file, right)[0] == doctest::Approx(0.18).epsilon(1.0 / 2048));
        CHECK(pixel<float>(work, file, left)[1] == doctest::Approx(0.25).epsilon(1e-6));
    }
}

TEST_CASE("files: numbers that a file cannot hold are replaced, counted and told") {
    const Workplace work("file_contents_test");
    std::string bright = flat_scene;
    bright.replace(bright.find("<0.5, 0.25, 0.05>"), 17, "<1e30, 1e5, 1>");
    bright.replace(bright.find("emission 1 "), 11, "emission 1e20 ");
    work.write("bright.scn", bright);
    const auto notes = [&](const char* file, const char* bits) {
        const ProcessResult run = work.render({"bright.scn", "-o", file, "--bits", bits, "--stats-json", "s.json"});
        CHECK(run.exit_code == 0);
        return run.standard_error;
    };
    const std::string half = notes("a.exr", "half");
    CHECK(says(half, "116 samples were not finite; NaN became 0, infinity 65504"));
    CHECK(says(half, "232 samples were beyond 65504, the largest half; they became that; --bits float keeps them"));
    CHECK(says(work.content("s.json"), "\"replaced_samples\": 116"));
    CHECK(says(work.content("s.json"), "\"clamped_samples\": 232"));
    CHECK(pixel<float>(work, "a.exr", left) == std::vector<float>{65504, 65504, 65504});
    CHECK(pixel<float>(work, "a.exr", right)[0] == doctest::Approx(0.18).epsilon(1e-3));
    const std::string whole = notes("a.exr", "float");
    CHECK(says(whole, "116 samples were not finite"));
    CHECK_FALSE(says(whole, "largest half"));
    CHECK(pixel<float>(work, "a.exr", left)[2] == doctest::Approx(1e20).epsilon(1e-6));
    CHECK(says(notes("a.png", "8"), "116 samples were not finite"));
    CHECK(pixel<uint8_t>(work, "a.png", left) == std::vector<uint8_t>{255, 255, 255});
}

TEST_CASE("files: a frame of an animation says what it is") {
    const Workplace work("file_contents_test");
    REQUIRE(
        work.render({"moving.scn", "-o", "a.#.exr", "--frames", "1-60", "--subset", "51", "--fps", "25"}).exit_code ==
        0);
    const OIIO::ImageSpec spec = spec_of(work, "a.0051.exr");
    CHECK(std::string(spec.get_string_attribute("Software")).starts_with("Proxima "));
    CHECK(spec.get_string_attribute("proxima:scene") == "moving.scn");
    CHECK(spec.get_string_attribute("proxima:hash").size() == 32);
    CHECK(spec.get_int_attribute("proxima:frame") == 51);
    CHECK(spec["smpte:TimeCode"].get() == "00:00:02:01");
    CHECK(spec.find_attribute("FramesPerSecond"));
    CHECK(spec.find_attribute("worldToCamera"));
    CHECK(spec.find_attribute("worldToNDC"));
    CHECK(spec.find_attribute("chromaticities"));
    REQUIRE(work.render({"still.scn", "-o", "a.jpg"}).exit_code == 0);
    CHECK(spec_of(work, "a.jpg").get_string_attribute("jpeg:subsampling") == "4:4:4");
}
