// SPDX-License-Identifier: Apache-2.0
#include "renderer/color_config.h"
#include "embedded_config.h"
#include "parser/source_files.h"

#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>
#include <sstream>
#include <string_view>

namespace proxima {
namespace {

constexpr const char* rec709_names[] = {"lin_rec709",
                                        "lin_rec709_scene",
                                        "Linear Rec.709 (sRGB)",
                                        "Linear Rec.709",
                                        "Utility - Linear - sRGB",
                                        "Utility - Linear - Rec.709",
                                        "lin_srgb",
                                        "Linear sRGB"};
constexpr const char* acescg_names[] = {"ACEScg", "lin_ap1_scene", "lin_ap1", "ACES - ACEScg"};
constexpr const char* aces_names[] = {"ACES2065-1", "lin_ap0_scene", "lin_ap0", "ACES - ACES2065-1"};

/// Linear light that headers have a name for.
struct LinearSpace {
    std::span<const char* const> names;
    const char* interop_id;
    std::array<float, 8> chromaticities;
};

const LinearSpace linear_spaces[] = {
    {rec709_names, "lin_rec709_scene", {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f}},
    {acescg_names, "lin_ap1_scene", {0.713f, 0.293f, 0.165f, 0.830f, 0.128f, 0.044f, 0.32168f, 0.33767f}},
    {aces_names, "lin_ap0_scene", {0.7347f, 0.2653f, 0.0f, 1.0f, 0.0001f, -0.077f, 0.32168f, 0.33767f}},
};

const LinearSpace& linear_space(WorkingSpace space) {
    return linear_spaces[space == WorkingSpace::acescg ? 1 : 0];
}

/// The configuration's own name of the first of `names` that it knows.
std::string find_name(const OCIO::Config& config, std::span<const char* const> names) {
    for (const char* name : names)
        if (const auto space = config.getColorSpace(name))
            return space->getName();
    return {};
}

} // namespace

ColorConfig load_color_config(const ColorSettings& settings) {
    std::string path = settings.config ? settings.config->string() : "";
    if (const char* variable = std::getenv("OCIO"); path.empty() && variable)
        path = variable;
    if (path.empty()) {
        std::istringstream text(embedded_ocio_config);
        return {OCIO::Config::CreateFromStream(text), "embedded configuration"};
    }
    try {
        return {OCIO::Config::CreateFromFile(path.c_str()), path};
    } catch (const OCIO::Exception& error) {
        throw FileError(fmt::format("{}: not a usable colour configuration: {}", path, error.what()));
    }
}

std::vector<std::string> ColorConfig::displays() const {
    std::vector<std::string> names;
    for (int i = 0; i < config->getNumDisplays(); ++i)
        names.emplace_back(config->getDisplay(i));
    return names;
}

std::vector<std::string> ColorConfig::views(const std::string& display) const {
    std::vector<std::string> names;
    for (int i = 0; i < config->getNumViews(display.c_str()); ++i)
        names.emplace_back(config->getView(display.c_str(), i));
    return names;
}

std::vector<std::string> ColorConfig::looks() const {
    std::vector<std::string> names;
    for (int i = 0; i < config->getNumLooks(); ++i)
        names.emplace_back(config->getLookNameByIndex(i));
    return names;
}

std::vector<std::string> ColorConfig::spaces() const {
    std::vector<std::string> names;
    for (int i = 0; i < config->getNumColorSpaces(); ++i)
        names.emplace_back(config->getColorSpaceNameByIndex(i));
    return names;
}

std::string ColorConfig::find(WorkingSpace space) const {
    return find_name(*config, linear_space(space).names);
}

FileColors ColorConfig::file_colors(const std::string& name) const {
    const OCIO::ConstColorSpaceRcPtr space = config->getColorSpace(name.c_str());
    if (space)
        for (const LinearSpace& linear : linear_spaces)
            if (find_name(*config, linear.names) == space->getName())
                return {"Linear", linear.interop_id, linear.chromaticities};
    if (space && (space->isData() || std::string_view(space->getEncoding()) == "scene-linear"))
        return {.encoding = "Linear"};
    if (name.find("sRGB") != std::string::npos)
        return {.encoding = "sRGB"};
    if (name.find("1886") != std::string::npos)
        return {.encoding = "Gamma2.4"};
    return {};
}

FileColors file_colors(WorkingSpace space) {
    const LinearSpace& linear = linear_space(space);
    return {"Linear", linear.interop_id, linear.chromaticities};
}

std::string list_color_choices(const ColorSettings& settings) {
    const ColorConfig config = load_color_config(settings);
    std::string text = fmt::format("{}\n\ndisplays and their views (the defaults come first):\n", config.name);
    for (const std::string& display : config.displays())
        text += fmt::format("  {}: {}\n", display, fmt::join(config.views(display), ", "));
    text += "\nlooks:\n";
    for (const std::string& look : config.looks())
        text += fmt::format("  {}\n", look);
    text += "\ncolour spaces:\n";
    for (const std::string& space : config.spaces())
        text += fmt::format("  {}\n", space);
    return text;
}

} // namespace proxima
