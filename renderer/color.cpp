// SPDX-License-Identifier: Apache-2.0
#include "renderer/color.h"
#include "embedded_config.h"
#include "parser/source_files.h"
#include "renderer/errors.h"

#include <OpenColorIO/OpenColorIO.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace OCIO = OCIO_NAMESPACE;

namespace proxima {
namespace {

constexpr float largest_half = 65504.0f;

/// OpenColorIO's default, but with exact logarithms and powers: levels must be POV-Ray's.
constexpr auto optimization =
    OCIO::OptimizationFlags(OCIO::OPTIMIZATION_VERY_GOOD & ~uint64_t(OCIO::OPTIMIZATION_FAST_LOG_EXP_POW));

OCIO::ConstConfigRcPtr load_config(const std::optional<std::filesystem::path>& path) {
    if (!path) {
        std::istringstream text(embedded_ocio_config);
        return OCIO::Config::CreateFromStream(text);
    }
    try {
        return OCIO::Config::CreateFromFile(path->c_str());
    } catch (const OCIO::Exception& error) {
        throw FileError(fmt::format("{}: not a usable colour configuration: {}", path->string(), error.what()));
    }
}

std::optional<std::filesystem::path> choose_config(const std::optional<std::filesystem::path>& asked) {
    if (asked)
        return asked;
    if (const char* variable = std::getenv("OCIO"); variable && *variable)
        return variable;
    return std::nullopt;
}

/// `asked`, or the default when it is empty. Throws UsageError unless it is one of `choices`.
std::string choose(const char* option, const std::string& asked, const char* default_name,
                   const std::vector<std::string>& choices) {
    const std::string name = asked.empty() ? default_name : asked;
    if (std::find(choices.begin(), choices.end(), name) != choices.end())
        return name;
    throw UsageError(fmt::format("{} '{}': the colour configuration does not have it; choose one of '{}'", option, name,
                                 fmt::join(choices, "', '")));
}

/// The names that configurations give linear light with Rec.709's primaries.
constexpr const char* rec709_names[] = {"lin_rec709",
                                        "lin_rec709_scene",
                                        "Linear Rec.709 (sRGB)",
                                        "Linear Rec.709",
                                        "Utility - Linear - sRGB",
                                        "Utility - Linear - Rec.709",
                                        "lin_srgb",
                                        "Linear sRGB"};

/// The steps from linear Rec.709 to the view. A configuration without that space is entered through ACES2065-1.
OCIO::GroupTransformRcPtr view_steps(const OCIO::Config& config, const std::string& display, const std::string& view) {
    auto steps = OCIO::GroupTransform::Create();
    auto to_view = OCIO::DisplayViewTransform::Create();
    to_view->setDisplay(display.c_str());
    to_view->setView(view.c_str());
    for (const char* name : rec709_names)
        if (config.getColorSpace(name)) {
            to_view->setSrc(name);
            steps->appendTransform(to_view);
            return steps;
        }
    if (!config.hasRole("aces_interchange"))
        throw UsageError("the colour configuration has neither a linear Rec.709 space nor the role aces_interchange; "
                         "choose another with --ocio");
    auto to_ap1 = OCIO::BuiltinTransform::Create();
    to_ap1->setStyle("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD");
    to_ap1->setDirection(OCIO::TRANSFORM_DIR_INVERSE);
    auto to_aces = OCIO::BuiltinTransform::Create();
    to_aces->setStyle("ACEScg_to_ACES2065-1");
    to_view->setSrc("aces_interchange");
    steps->appendTransform(to_ap1);
    steps->appendTransform(to_aces);
    steps->appendTransform(to_view);
    return steps;
}

/// Names the result's curve for the file's header.
std::string encoding_of(const OCIO::Config& config, const std::string& display, const std::string& view) {
    std::string name = config.getDisplayViewColorSpaceName(display.c_str(), view.c_str());
    if (name.empty() || name == OCIO::OCIO_VIEW_USE_DISPLAY_NAME)
        name = display;
    const OCIO::ConstColorSpaceRcPtr space = config.getColorSpace(name.c_str());
    if (space && (space->isData() || std::string_view(space->getEncoding()) == "scene-linear"))
        return "Linear";
    if (name.find("sRGB") != std::string::npos)
        return "sRGB";
    if (name.find("1886") != std::string::npos)
        return "Gamma2.4";
    return {};
}

/// Applies `change` to every sample, in parallel, and counts those for which it is true.
template <class Change> uint64_t count_changed(Image& image, const Change& change) {
    std::atomic<uint64_t> changed{0};
    tbb::parallel_for(tbb::blocked_range<size_t>(0, image.rgb.size(), 1 << 16), [&](const auto& samples) {
        uint64_t count = 0;
        for (size_t i = samples.begin(); i != samples.end(); ++i)
            count += change(image.rgb[i]);
        changed += count;
    });
    return changed;
}

} // namespace

struct ColorTransform::Implementation {
    OCIO::ConstCPUProcessorRcPtr processor;
    std::string encoding;
};

ColorTransform::ColorTransform(const ColorSettings& settings) : implementation_(std::make_unique<Implementation>()) {
    const auto path = choose_config(settings.config);
    const OCIO::ConstConfigRcPtr config = load_config(path);

    std::vector<std::string> displays, views;
    for (int i = 0; i < config->getNumDisplays(); ++i)
        displays.emplace_back(config->getDisplay(i));
    const std::string display = choose("--display", settings.display, config->getDefaultDisplay(), displays);
    for (int i = 0; i < config->getNumViews(display.c_str()); ++i)
        views.emplace_back(config->getView(display.c_str(), i));
    const std::string view = choose("--view", settings.view, config->getDefaultView(display.c_str()), views);

    try {
        implementation_->processor =
            config->getProcessor(view_steps(*config, display, view))
                ->getOptimizedCPUProcessor(OCIO::BIT_DEPTH_F32, OCIO::BIT_DEPTH_F32, optimization);
    } catch (const OCIO::Exception& error) {
        throw FileError(fmt::format("{}: display '{}', view '{}': {}", path ? path->string() : "embedded configuration",
                                    display, view, error.what()));
    }
    implementation_->encoding = encoding_of(*config, display, view);
}

ColorTransform::~ColorTransform() = default;
ColorTransform::ColorTransform(ColorTransform&&) noexcept = default;

const std::string& ColorTransform::encoding() const {
    return implementation_->encoding;
}

void ColorTransform::apply(Image& image) const {
    tbb::parallel_for(tbb::blocked_range<uint32_t>(0, image.height, 8), [&](const tbb::blocked_range<uint32_t>& rows) {
        OCIO::PackedImageDesc slice(image.rgb.data() + size_t(rows.begin()) * image.width * 3, long(image.width),
                                    long(rows.size()), 3);
        implementation_->processor->apply(slice);
    });
}

uint64_t replace_non_finite(Image& image) {
    return count_changed(image, [](float& value) {
        if (std::isfinite(value))
            return false;
        value = std::isnan(value) ? 0.0f : std::copysign(largest_half, value);
        return true;
    });
}

uint64_t clamp_to_half(Image& image) {
    return count_changed(image, [](float& value) {
        const bool is_beyond = std::abs(value) > largest_half;
        if (is_beyond)
            value = std::copysign(largest_half, value);
        return is_beyond;
    });
}

} // namespace proxima
