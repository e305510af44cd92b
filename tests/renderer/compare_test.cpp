// SPDX-License-Identifier: Apache-2.0
// The figures of a comparison against numbers worked out by hand, and the pictures that have no comparison.
#include "renderer/comparison.h"
#include "renderer/difference_picture.h"
#include "renderer/image_figures.h"
#include "renderer/numbered_name.h"
#include "renderer/povray_run.h"
#include "renderer/ssim.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <nlohmann/json.hpp>

using namespace proxima;

namespace {

constexpr float float_infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

StoredImage stored(uint32_t width, uint32_t height, std::vector<float> samples, SampleType type = SampleType::uint8,
                   std::string encoding = {}) {
    const auto channels = uint32_t(samples.size() / width / height);
    return {width, height, channels, type, std::move(encoding), std::move(samples), {}};
}

StoredImage flat(uint32_t width, uint32_t height, float level) {
    return stored(width, height, std::vector<float>(size_t(width) * height * 3, level));
}

ImageFigures compare(const StoredImage& a, const StoredImage& b, double tolerance = 0) {
    return measure(pair_images(a, b, false), tolerance);
}

std::string refusal(const StoredImage& a, const StoredImage& b, bool linear = false) {
    try {
        pair_images(a, b, linear);
    } catch (const NotComparable& reason) {
        return reason.what();
    }
    return "none";
}

} // namespace

TEST_CASE("compare: equal pictures have no error, and no worst pixel") {
    const ImageFigures figures = compare(flat(12, 11, 7), flat(12, 11, 7));
    CHECK(figures.pixels == 132);
    CHECK(figures.pixels_over == 0);
    CHECK(figures.max_error == 0);
    CHECK(figures.rms_error == 0);
    CHECK_FALSE(figures.psnr);
    CHECK(figures.ssim == 1.0);
    CHECK_FALSE(figures.worst);
}

TEST_CASE("compare: max, RMS, PSNR, share and the worst pixel are those worked out by hand") {
    // 2 x 2 pixels; the differences are 3 and 4 in one pixel, 12 in another: squares 9 + 16 + 144 = 169 over 12
    // samples.
    const StoredImage a = stored(2, 2, {10, 10, 10, 20, 20, 20, 30, 30, 30, 40, 40, 40});
    const StoredImage b = stored(2, 2, {10, 10, 10, 23, 16, 20, 30, 30, 30, 40, 52, 40});
    const ImageFigures figures = compare(a, b, 4.0 / 255);
    CHECK(figures.max_error == doctest::Approx(12.0 / 255).epsilon(1e-14));
    CHECK(figures.rms_error == doctest::Approx(std::sqrt(169.0 / 12) / 255).epsilon(1e-14));
    CHECK(*figures.psnr == doctest::Approx(20 * std::log10(255 / std::sqrt(169.0 / 12))).epsilon(1e-14));
    CHECK(figures.pixels_over == 1); // 4/255 itself is within the tolerance
    CHECK(compare(a, b, 3.999 / 255).pixels_over == 2);
    REQUIRE(figures.worst);
    CHECK(figures.worst->x == 1);
    CHECK(figures.worst->y == 1);
    CHECK(figures.worst->a == std::vector<float>{40, 40, 40});
    CHECK(figures.worst->b == std::vector<float>{40, 52, 40});
    CHECK_FALSE(figures.ssim); // smaller than the window
}

TEST_CASE("compare: every tolerance in levels holds exactly that many levels") {
    for (const SampleType type : {SampleType::uint8, SampleType::uint16})
        for (int level = 1; level < 255; ++level) {
            const double tolerance = double(level) / full_scale(type);
            const StoredImage zero = stored(1, 1, {0, 0, 0}, type);
            REQUIRE(compare(zero, stored(1, 1, {0, float(level), 0}, type), tolerance).pixels_over == 0);
            REQUIRE(compare(zero, stored(1, 1, {0, float(level + 1), 0}, type), tolerance).pixels_over == 1);
        }
}

TEST_CASE("compare: SSIM of two flat pictures is the luminance term alone") {
    const double a = 100, b = 120, c1 = 0.01 * 255 * 0.01 * 255;
    const ImageFigures figures = compare(flat(20, 15, 100), flat(20, 15, 120));
    CHECK(*figures.ssim == doctest::Approx((2 * a * b + c1) / (a * a + b * b + c1)).epsilon(1e-6));
}

TEST_CASE("compare: SSIM of a picture and its negative is the structure term alone") {
    // One window; a = 0.5 + s, b = 0.5 - s with a weighted mean of s of 0: the covariance is minus the variance.
    std::vector<float> a(121), b(121);
    double variance = 0, weights = 0;
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 11; ++x) {
            const float s = x == 5 ? 0.0f : x < 5 ? -0.25f : 0.25f; // odd about the window's middle
            const double weight = std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / 4.5);
            a[size_t(y * 11 + x)] = 0.5f + s;
            b[size_t(y * 11 + x)] = 0.5f - s;
            variance += weight * double(s) * double(s);
            weights += weight;
        }
    variance /= weights;
    const double c2 = 0.03 * 0.03;
    CHECK(*structural_similarity(a, b, 11, 11, 1) ==
          doctest::Approx((-2 * variance + c2) / (2 * variance + c2)).epsilon(1e-9));
}

TEST_CASE("compare: SSIM is the mean over windows and does not depend on where a block of rows ends") {
    // A step edge against its copy one column on, in a picture that is taller than a task's rows: every row is alike.
    const auto edge = [](uint32_t height, uint32_t column) {
        std::vector<float> picture(size_t(40) * height);
        for (size_t i = 0; i < picture.size(); ++i)
            picture[i] = i % 40 < column ? 0.0f : 1.0f;
        return picture;
    };
    const double small = *structural_similarity(edge(11, 20), edge(11, 21), 40, 11, 1);
    const double tall = *structural_similarity(edge(200, 20), edge(200, 21), 40, 200, 1);
    CHECK(small < 0.99);
    CHECK(tall == doctest::Approx(small).epsilon(1e-12));
}

TEST_CASE("compare: pixels that are not finite are counted first, are always over, and spoil no other figure") {
    const auto with = [](std::vector<float> samples) { return stored(3, 1, std::move(samples), SampleType::float32); };
    const StoredImage a = with({0, not_a_number, 0, 0.5f, 0.5f, 0.5f, float_infinity, float_infinity, -float_infinity});
    const StoredImage b = with({0, 0, 0, 0.5f, 0.75f, 0.5f, float_infinity, 1, 1});
    const ImageFigures figures = compare(a, b, 10);
    CHECK(figures.non_finite_a == 2);
    CHECK(figures.non_finite_b == 1);
    CHECK(figures.pixels_over == 2);
    CHECK(figures.max_error == 0.25);
    CHECK(figures.rms_error == doctest::Approx(0.25 / std::sqrt(3)).epsilon(1e-14));
    REQUIRE(figures.worst);
    CHECK(figures.worst->x == 0);              // the first that is not finite
    CHECK(compare(a, a, 10).pixels_over == 2); // the same NaN on both sides too
    CHECK(compare(with({not_a_number, 0, 0, 0, not_a_number, 0, 0, 0, not_a_number}), b).max_error == 0);
}

TEST_CASE("compare: what differs in size or kind is no pair, and the message says what to do") {
    const StoredImage a = stored(1, 1, {1, 2, 3}, SampleType::uint8, "sRGB");
    CHECK(refusal(a, flat(2, 1, 0)) == "the sizes differ: A is 1 x 1, B is 2 x 1");
    CHECK(refusal(a, stored(1, 1, {1, 2, 3}, SampleType::uint8, "Linear")) ==
          "A's levels are encoded as sRGB, B's as Linear; add --linear to compare both in linear light");
    CHECK(refusal(a, stored(1, 1, {1, 2, 3}, SampleType::half, "Linear")) ==
          "B holds linear numbers and A levels (sRGB); add --linear to compare both in linear light");
    CHECK(refusal(stored(1, 1, {1, 2, 3, 254}), a) ==
          "A is see-through in places and B has no alpha channel; put it on its background first");
    CHECK(refusal(stored(1, 1, {1, 2, 3}, SampleType::uint8, "KodakLog"), a, true) ==
          "the encoding 'KodakLog' has no known way to linear light; save the picture as sRGB or linear");
    CHECK(refusal(a, stored(1, 1, {1, 2, 3})) == "none"); // one header says nothing
    CHECK(refusal(a, stored(1, 1, {1, 2, 3, 255})) == "none");
}

TEST_CASE("compare: alpha counts where both have it") {
    const ImageFigures figures = compare(stored(1, 1, {1, 2, 3, 100}), stored(1, 1, {1, 2, 3, 151}));
    CHECK(figures.max_error == doctest::Approx(0.2).epsilon(1e-14));
    const ImagePair opaque = pair_images(stored(2, 1, {1, 2, 3, 255, 4, 5, 6, 255}), flat(2, 1, 0), false);
    CHECK(opaque.channels == 3);
    CHECK(opaque.a == std::vector<float>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("compare: 8 bits beside 16 are 257 times the level") {
    const ImagePair pair =
        pair_images(stored(1, 1, {0, 1, 255}), stored(1, 1, {0, 257, 65535}, SampleType::uint16), false);
    CHECK(pair.white == 65535);
    CHECK(pair.a == pair.b);
    CHECK(pair.rule == "levels of 16 bits; A's 8-bit levels times 257");
}

TEST_CASE("compare: in linear light sRGB, gamma and linear pictures of one scene agree") {
    // 118 is sRGB's level for 0.18, 46 is 0.18 itself, and 0.18^(1/2.2) is 117.
    const StoredImage srgb = stored(1, 1, {118, 0, 255}, SampleType::uint8, "sRGB");
    const StoredImage linear = stored(1, 1, {46, 0, 255}, SampleType::uint8, "Linear");
    const StoredImage gamma = stored(1, 1, {117, 0, 255}, SampleType::uint8, "Gamma2.2");
    const StoredImage number = stored(1, 1, {0.18f, 0, 1}, SampleType::half, "Linear");
    for (const StoredImage* picture : {&srgb, &linear, &gamma}) {
        const ImagePair pair = pair_images(*picture, number, true);
        CHECK(pair.is_linear);
        CHECK(measure(pair, 0.002).pixels_over == 0);
    }
}

TEST_CASE("compare: the difference map is black, grey, coloured or cyan") {
    const StoredImage a = stored(4, 1, {0, 0, 0, 0, 0, 0, 0, 0, 0, not_a_number, 0, 0}, SampleType::float32);
    const StoredImage b = stored(4, 1, {0, 0, 0, 0, 0.01f, 0, 0, 1, 0, 0, 0, 0}, SampleType::float32);
    const Image map = difference_map(pair_images(a, b, false), 0.02);
    const auto pixel = [&](size_t x) { return std::vector<float>(&map.rgb[x * 3], &map.rgb[x * 3] + 3); };
    CHECK(pixel(0) == std::vector<float>{0, 0, 0});
    CHECK(pixel(1)[0] == doctest::Approx(0.25));
    CHECK(pixel(1)[0] == pixel(1)[2]);
    CHECK(pixel(2)[0] == doctest::Approx(0.987)); // the far end of the colours
    CHECK(pixel(2)[1] == doctest::Approx(0.991));
    CHECK(pixel(3) == std::vector<float>{0, 1, 1});
}

TEST_CASE("compare: three pictures side by side keep their pixels") {
    const Image a{1, 2, {1, 1, 1, 1, 1, 1}}, b{1, 2, {0, 0, 0, 0, 0, 0}};
    const Image row = side_by_side({a, b, a});
    CHECK(row.width == 11);
    CHECK(row.height == 2);
    const std::vector<float> levels{1, 0.5f, 0.5f, 0.5f, 0.5f, 0, 0.5f, 0.5f, 0.5f, 0.5f, 1};
    for (size_t i = 0; i < 22; ++i)
        CHECK(row.rgb[i * 3] == levels[i % 11]);
}

TEST_CASE("compare: a file's name gives its frame only in the pattern's own form") {
    const NumberedName four("A", "out/a.####.exr");
    CHECK(four.number_of("a.0012.exr") == 12);
    CHECK(four.number_of("a.-0012.exr") == -12);
    CHECK(four.number_of("a.12345.exr") == 12345);
    for (const char* name : {"a.12.exr", "a.00012.exr", "a.exr", "b.0012.exr", "a.0012.png", "a.00x2.exr", "a..exr",
                             "a.+012.exr", "a.-9223372036854775808999.exr"})
        CHECK_MESSAGE(!four.number_of(name), name);
    CHECK(NumberedName("A", "%d.png").number_of("-9223372036854775808.png") == std::numeric_limits<int64_t>::min());
}

TEST_CASE("compare: JSON has every figure, and words for what is not finite") {
    PairRecord pair{.name = "<\xff>", .a = "a.exr", .b = "b.exr", .verdict = Verdict::different};
    pair.figures = compare(stored(1, 1, {not_a_number, float_infinity, -float_infinity}, SampleType::float32),
                           stored(1, 1, {0, 0, 0}, SampleType::float32));
    const ComparisonRecord record{
        .a = "a", .b = "b", .pairs = {pair, {.name = "n", .a = "", .b = "", .verdict = Verdict::missing}}};
    const auto json = nlohmann::json::parse(to_json(record));
    CHECK(json["failures"] == 2);
    const auto& first = json["pairs"][0];
    for (const char* name :
         {"name", "a", "b", "verdict", "width", "height", "channels", "compared", "white", "non_finite_a",
          "non_finite_b", "max_error", "rms_error", "psnr_db", "ssim", "pixels", "pixels_over", "share_over", "worst"})
        CHECK_MESSAGE(first.contains(name), name);
    CHECK(first["worst"]["a"] == nlohmann::json{"nan", "inf", "-inf"});
    CHECK(first["psnr_db"].is_null());
    CHECK(json["pairs"][1]["verdict"] == "missing");
    CHECK_FALSE(json["pairs"][1].contains("max_error"));
}

TEST_CASE("compare: POV-Ray gets the same size, clock, frames, names and folders") {
    SceneOptions scene;
    Antialiasing antialiasing;
    scene.scene = "my scenes/a.scn";
    scene.width = 80;
    scene.height = 60;
    const auto has = [&](const std::string& option) {
        const auto command = povray_command(scene, antialiasing, 3, "/tmp/x");
        return std::find(command.begin(), command.end(), option) != command.end();
    };
    for (const char* option : {"povray", "+I\"my scenes/a.scn\"", "+O\"/tmp/x/picture.png\"", "+W80", "+H60", "+FN16",
                               "File_Gamma=1.0", "-A", "-D", "+L\"my scenes\""})
        CHECK_MESSAGE(has(option), option);
    CHECK_FALSE(has("+K0"));
    antialiasing = {Antialiasing::Method::squares, 0.1f, 4};
    for (const char* option :
         {"Antialias=on", "Sampling_Method=2", "Antialias_Threshold=0.1", "Antialias_Depth=4", "Jitter=off"})
        CHECK_MESSAGE(has(option), option);
    CHECK_FALSE(has("-A"));
    scene.animation = Animation::still(0.25f);
    CHECK(has("+K0.25"));
    scene.animation = Animation::sequence({1, 2, 3}, {3});
    scene.animation.cyclic = true;
    scene.declares = {{"Count", "3"}};
    scene.include_paths = {"lib"};
    scene.scene = "a.scn";
    for (const char* option :
         {"Initial_Frame=1", "Final_Frame=3", "Subset_Start_Frame=3", "Subset_End_Frame=3", "Initial_Clock=0",
          "Final_Clock=1", "Cyclic_Animation=on", "Declare=Count=3", "+L\"lib\"", "+L\".\""})
        CHECK_MESSAGE(has(option), option);
}
