// SPDX-License-Identifier: Apache-2.0
#include "parser/source_files.h"
#include "renderer/color.h"
#include "renderer/errors.h"
#include "renderer/image_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

using namespace proxima;

namespace {

std::array<float, 3> through(const ColorSettings& settings, std::array<float, 3> color) {
    Image image{1, 1, {color[0], color[1], color[2]}};
    ColorTransform(settings).apply(image);
    return {image.rgb[0], image.rgb[1], image.rgb[2]};
}

/// IEC 61966-2-1, the curve that POV-Ray puts into PNG files.
double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

const ColorSettings untoned{.display = "sRGB", .view = "Un-tone-mapped"};

/// A configuration file, gone with the test.
struct ConfigFile {
    std::filesystem::path path;
    ConfigFile(const std::string& name, const std::string& text) : path(std::filesystem::temp_directory_path() / name) {
        std::ofstream(path) << text;
    }
    ~ConfigFile() { std::filesystem::remove(path); }
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

/// A configuration with one view, which halves the light.
std::string halving_config(const std::string& view) {
    return "ocio_profile_version: 2\nroles: {default: lin_rec709, scene_linear: lin_rec709}\n"
           "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n"
           "displays:\n  screen:\n    - !<View> {name: " +
           view +
           ", colorspace: half}\n"
           "colorspaces:\n  - !<ColorSpace> {name: lin_rec709}\n"
           "  - !<ColorSpace>\n    name: half\n    from_scene_reference: !<MatrixTransform> "
           "{matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}\n";
}

} // namespace

TEST_CASE("color: the embedded configuration gives the golden values") {
    struct Row {
        ColorSettings settings;
        std::array<float, 3> linear, display;
    };
    const ColorSettings aces{{}, "sRGB", "ACES 1.0 - SDR Video"};
    const ColorSettings television{{}, "Rec.1886 Rec.709", "Un-tone-mapped"};
    const ColorSettings television_aces{{}, "Rec.1886 Rec.709", "ACES 1.0 - SDR Video"};
    const ColorSettings cg{.space = "ACEScg", .target = ColorTarget::space};
    const ColorSettings from_cg{
        .space = "lin_rec709", .target = ColorTarget::space, .working_space = WorkingSpace::acescg};
    const ColorSettings still_cg{.target = ColorTarget::scene_linear, .working_space = WorkingSpace::acescg};
    const Row rows[] = {
        // Rec.1886 is a power of 2.4; a tone map is the same on every display, in light.
        {television, {0.18f, 0.5f, 0.05f}, {0.489437f, 0.749154f, 0.287015f}},
        {television_aces, {0.18f, 0.18f, 0.18f}, {0.389530f, 0.389530f, 0.389530f}},
        {{{}, "Rec.1886 Rec.709", "Raw"}, {0.5f, 0.25f, 4.0f}, {0.5f, 0.25f, 4.0f}},
        {cg, {0.5f, 0.25f, 0.05f}, {0.393798f, 0.264858f, 0.081191f}},
        {from_cg, {0.393798f, 0.264858f, 0.081191f}, {0.5f, 0.25f, 0.05f}},
        {still_cg, {0.5f, 0.25f, 0.05f}, {0.5f, 0.25f, 0.05f}},
        {{.working_space = WorkingSpace::acescg}, {0.393798f, 0.264858f, 0.081191f}, {0.735357f, 0.537099f, 0.247801f}},
        {{}, {0.18f, 0.18f, 0.18f}, {0.461356f, 0.461356f, 0.461356f}},
        {untoned, {0.5f, 0.25f, 0.05f}, {0.735357f, 0.537099f, 0.247801f}},
        {aces, {0.18f, 0.18f, 0.18f}, {0.355954f, 0.355954f, 0.355954f}},
        {aces, {0.5f, 0.25f, 0.05f}, {0.634815f, 0.450429f, 0.164420f}},
        {aces, {4.0f, 1.0f, 0.2f}, {0.985147f, 0.836895f, 0.558990f}},
        {{{}, "sRGB", "Raw"}, {0.5f, 0.25f, 4.0f}, {0.5f, 0.25f, 4.0f}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.settings.view);
        const auto display = through(row.settings, row.linear);
        for (int i = 0; i < 3; ++i)
            CHECK(display[i] == doctest::Approx(row.display[i]).epsilon(3e-6));
    }
    CHECK(through(untoned, {4.0f, 1.0f, 0.2f})[0] == doctest::Approx(1.8248f).epsilon(1e-4));
}

TEST_CASE("color: a linear picture gives POV-Ray's levels") {
    constexpr uint32_t side = 1024;
    Image image{side, side, std::vector<float>(size_t(side) * side * 3)};
    for (size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = float(i) / float(image.rgb.size() - 1);
    const Image linear = image;
    ColorTransform(untoned).apply(image);
    size_t off_by_one_8 = 0, off_by_one_16 = 0;
    int worst_8 = 0, worst_16 = 0;
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        const double expected = srgb(double(linear.rgb[i]));
        const int error_8 = std::abs(int(quantize<uint8_t>(image.rgb[i], 255)) - int(std::floor(expected * 255 + 0.5)));
        const int error_16 =
            std::abs(int(quantize<uint16_t>(image.rgb[i], 65535)) - int(std::floor(expected * 65535 + 0.5)));
        worst_8 = std::max(worst_8, error_8);
        worst_16 = std::max(worst_16, error_16);
        off_by_one_8 += error_8 != 0;
        off_by_one_16 += error_16 != 0;
    }
    MESSAGE("8 bits: ", off_by_one_8, " of ", image.rgb.size(), " samples differ, 16 bits: ", off_by_one_16);
    CHECK(worst_8 <= 1);
    CHECK(worst_16 <= 1);
    CHECK(double(off_by_one_8) <= 1e-4 * double(image.rgb.size()));
}

namespace {

/// Numbers of all sizes, with those at which a level ends: the floats on both sides of each change that halving finds.
std::vector<float> numbers_around_levels(const ColorTransform& color) {
    std::vector<float> numbers{0.0f,
                               -0.0f,
                               -1.0f,
                               65504.0f,
                               std::numeric_limits<float>::max(),
                               -std::numeric_limits<float>::max(),
                               std::numeric_limits<float>::denorm_min()};
    for (uint32_t bits = 0; bits < 0x7f800000; bits += 99'991)
        numbers.push_back(std::bit_cast<float>(bits));
    const auto level = [&](uint32_t bits) {
        Image image{1, 1, std::vector<float>(3, std::bit_cast<float>(bits))};
        color.apply(image);
        return quantize<uint8_t>(image.rgb[1], 255);
    };
    for (int wanted = 1; wanted < 256; wanted += 6) {
        uint32_t low = 0, high = 0x7f7fffff;
        while (low < high) {
            const uint32_t middle = low + (high - low) / 2;
            (level(middle) >= wanted ? high : low) = level(middle) >= wanted ? middle : middle + 1;
        }
        for (uint32_t near = low - std::min(low, 40u); near < low + 40; ++near)
            numbers.push_back(std::bit_cast<float>(near));
    }
    numbers.resize(numbers.size() / 3 * 3);
    return numbers;
}

} // namespace

TEST_CASE("color: levels that are made at once are those of the conversion") {
    const ConfigFile halving("proxima-half-levels.ocio", halving_config("half"));
    const ConfigFile turning("proxima-turned-levels.ocio", replaced(halving_config("half"), "[0.5,", "[-0.5,"));
    for (const ColorSettings& settings :
         {untoned, ColorSettings{.display = "Rec.1886 Rec.709", .view = "Un-tone-mapped"},
          ColorSettings{.config = halving.path}, ColorSettings{.space = "Raw", .target = ColorTarget::space}}) {
        CAPTURE(settings.display);
        const ColorTransform color(settings);
        Image image{1, 1, numbers_around_levels(color)};
        image.width = uint32_t(image.rgb.size() / 3);
        REQUIRE(color.to_levels(image));
        Image expected = image;
        expected.levels.clear();
        color.apply(expected);
        CHECK(image.levels == quantize_to_bytes(expected));
        CHECK(quantize_to_bytes(image) == image.levels);
    }
    // Where channels mix, or numbers change their order, there is no such way.
    for (const ColorSettings& settings :
         {ColorSettings{.view = "ACES 1.0 - SDR Video"}, ColorSettings{.working_space = WorkingSpace::acescg},
          ColorSettings{.config = turning.path}}) {
        Image image{1, 1, {0.25f, 0.5f, 0.75f}};
        CHECK_FALSE(ColorTransform(settings).to_levels(image));
        CHECK(image.levels.empty());
    }
}

TEST_CASE("color: levels are rounded as POV-Ray rounds them") {
    CHECK(quantize<uint8_t>(-1.0f, 255) == 0);
    CHECK(quantize<uint8_t>(2.0f, 255) == 255);
    CHECK(quantize<uint8_t>(0.5f, 255) == 128);
    CHECK(quantize<uint8_t>(0.49999997f, 255) == 127);
    CHECK(quantize<uint16_t>(0.461356f, 65535) == 30235);
    CHECK(quantize<uint16_t>(1.0f, 65535) == 65535);
}

TEST_CASE("color: the encoding of a view is known to the file") {
    CHECK(ColorTransform(ColorSettings{}).file().encoding == "sRGB");
    CHECK(ColorTransform({{}, "sRGB", "ACES 1.0 - SDR Video"}).file().encoding == "sRGB");
    CHECK(ColorTransform({{}, "", "Raw"}).file().encoding == "Linear");
    CHECK(ColorTransform({{}, "Rec.1886 Rec.709", ""}).file().encoding == "Gamma2.4");
}

TEST_CASE("color: linear light has a name and chromaticities in a header, what a display shows has none") {
    struct Row {
        ColorSettings settings;
        const char* interop_id;
        float red_x;
    };
    const auto space = [](const char* name) { return ColorSettings{.space = name, .target = ColorTarget::space}; };
    const Row rows[] = {
        {{.target = ColorTarget::scene_linear}, "lin_rec709_scene", 0.64f},
        {{.target = ColorTarget::scene_linear, .working_space = WorkingSpace::acescg}, "lin_ap1_scene", 0.713f},
        {space("ACEScg"), "lin_ap1_scene", 0.713f},
        {space("lin_ap1_scene"), "lin_ap1_scene", 0.713f},
        {space("ACES2065-1"), "lin_ap0_scene", 0.7347f},
        {space("scene_linear"), "lin_rec709_scene", 0.64f},
    };
    for (const Row& row : rows) {
        CAPTURE(row.settings.space);
        const FileColors colors = ColorTransform(row.settings).file();
        CHECK(colors.encoding == "Linear");
        CHECK(colors.interop_id == row.interop_id);
        REQUIRE(colors.chromaticities);
        CHECK((*colors.chromaticities)[0] == row.red_x);
    }
    for (const ColorSettings& settings : {ColorSettings{}, space("ACEScct"), space("sRGB - Texture")})
        CHECK_FALSE(ColorTransform(settings).file().chromaticities);
    CHECK(ColorTransform(space("sRGB - Texture")).file().encoding == "sRGB");
}

TEST_CASE("color: a look comes before the view") {
    const char* look = "ACES 1.3 Reference Gamut Compression";
    const std::array<float, 3> vivid{0.0f, 0.9f, -0.2f};
    CHECK(through({.look = look}, vivid) != through({}, vivid));
    // Colours well inside the gamut stay as they are.
    CHECK(through({.look = look}, {0.4f, 0.4f, 0.4f})[0] == doctest::Approx(through({}, {0.4f, 0.4f, 0.4f})[0]));
    CHECK_THROWS_WITH_AS(ColorTransform({.look = "Sepia"}),
                         "--look 'Sepia': the colour configuration does not have it; choose one of 'ACES 1.3 Reference "
                         "Gamut Compression'",
                         UsageError);
    CHECK_THROWS_AS(ColorTransform({.space = "Sepia", .target = ColorTarget::space}), UsageError);
}

TEST_CASE("color: an identity is the same in every run, and another one for other colours") {
    const ColorSettings settings[] = {{},
                                      {.view = "ACES 1.0 - SDR Video"},
                                      {.view = "Raw"},
                                      {.look = "ACES 1.3 Reference Gamut Compression"},
                                      {.target = ColorTarget::scene_linear},
                                      {.target = ColorTarget::scene_linear, .working_space = WorkingSpace::acescg},
                                      {.space = "ACEScg", .target = ColorTarget::space}};
    std::set<std::string> identities;
    for (const ColorSettings& each : settings) {
        CHECK(identities.insert(ColorTransform(each).identity()).second);
        CHECK(ColorTransform(each).identity() == ColorTransform(each).identity());
    }
}

TEST_CASE("color: the choices of a configuration are listed") {
    const std::string text = list_color_choices({});
    for (const char* part : {"sRGB: Un-tone-mapped, ACES 1.0 - SDR Video, Raw", "ACES 1.3 Reference Gamut Compression",
                             "ACEScg", "lin_rec709"})
        CHECK(text.find(part) != std::string::npos);
}

TEST_CASE("color: an unknown display or view is refused with the choices") {
    CHECK_THROWS_WITH_AS(ColorTransform({{}, "srgb", ""}),
                         "--display 'srgb': the colour configuration does not have it; choose one of 'sRGB', "
                         "'Rec.1886 Rec.709'",
                         UsageError);
    CHECK_THROWS_WITH_AS(ColorTransform({{}, "", "Filmic"}),
                         "--view 'Filmic': the colour configuration does not have it; choose one of 'Un-tone-mapped', "
                         "'ACES 1.0 - SDR Video', 'Raw'",
                         UsageError);
}

TEST_CASE("color: --ocio is above $OCIO, which is above the embedded configuration") {
    const ConfigFile environment("proxima_environment.ocio", halving_config("of_environment"));
    const ConfigFile option("proxima_option.ocio", halving_config("of_option"));
    setenv("OCIO", environment.path.c_str(), 1);
    CHECK(through({{}, "screen", "of_environment"}, {1, 1, 1})[0] == 0.5f);
    CHECK(through({option.path, "screen", "of_option"}, {1, 1, 1})[0] == 0.5f);
    setenv("OCIO", "no such file.ocio", 1);
    CHECK_THROWS_AS(ColorTransform(ColorSettings{}), FileError);
    setenv("OCIO", "", 1);
    CHECK(through({}, {1, 1, 1})[0] == doctest::Approx(1.0f));
    unsetenv("OCIO");
    const ConfigFile broken("proxima_broken.ocio", "this: is: no: configuration");
    CHECK_THROWS_AS(ColorTransform({broken.path, "", ""}), FileError);
}

TEST_CASE("color: a configuration without linear Rec.709 is entered through ACES2065-1") {
    const ConfigFile aces("proxima_aces.ocio",
                          "ocio_profile_version: 2\nroles: {default: AP0, scene_linear: AP1, aces_interchange: AP0}\n"
                          "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n"
                          "displays:\n  screen:\n    - !<View> {name: cg, colorspace: AP1}\n"
                          "colorspaces:\n  - !<ColorSpace> {name: AP0}\n  - !<ColorSpace>\n    name: AP1\n"
                          "    to_scene_reference: !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}\n");
    const auto color = through({aces.path, "", ""}, {0.5f, 0.25f, 0.05f});
    CHECK(color[0] == doctest::Approx(0.393798f).epsilon(1e-5));
    CHECK(color[1] == doctest::Approx(0.264858f).epsilon(1e-5));
    CHECK(color[2] == doctest::Approx(0.081191f).epsilon(1e-5));
}

TEST_CASE("color: samples that are not finite are replaced and counted") {
    const float infinity = std::numeric_limits<float>::infinity();
    Image image{2, 1, {0.5f, std::nanf(""), infinity, -infinity, 1e30f, -1.0f}};
    CHECK(replace_non_finite(image) == 3);
    CHECK(image.rgb == std::vector<float>{0.5f, 0.0f, 65504.0f, -65504.0f, 1e30f, -1.0f});
    CHECK(replace_non_finite(image) == 0);
}

TEST_CASE("color: samples beyond the largest half are brought back to it and counted") {
    Image image{2, 1, {1e30f, -1e30f, 65504.0f, 0, 65505.0f, -65504.0f}};
    CHECK(clamp_to_half(image) == 3);
    CHECK(image.rgb == std::vector<float>{65504.0f, -65504.0f, 65504.0f, 0, 65504.0f, -65504.0f});
    CHECK(clamp_to_half(image) == 0);
}
