// SPDX-License-Identifier: Apache-2.0
#include "renderer/color.h"
#include "kernels/half.h"
#include "parser/source_files.h"
#include "renderer/color_config.h"
#include "renderer/errors.h"
#include "renderer/level_curve.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace proxima {
namespace {

/// OpenColorIO's default, but with exact logarithms and powers: levels must be POV-Ray's.
constexpr auto optimization =
    OCIO::OptimizationFlags(OCIO::OPTIMIZATION_VERY_GOOD & ~uint64_t(OCIO::OPTIMIZATION_FAST_LOG_EXP_POW));

/// Throws UsageError unless `name` is one of `choices`.
std::string choose(const char* option, const std::string& name, const std::vector<std::string>& choices) {
    if (std::find(choices.begin(), choices.end(), name) != choices.end())
        return name;
    if (choices.empty())
        throw UsageError(fmt::format("{} '{}': the colour configuration has none; leave it out", option, name));
    throw UsageError(fmt::format("{} '{}': the colour configuration does not have it; choose one of '{}'", option, name,
                                 fmt::join(choices, "', '")));
}

OCIO::BuiltinTransformRcPtr builtin(const char* style, OCIO::TransformDirection direction) {
    auto transform = OCIO::BuiltinTransform::Create();
    transform->setStyle(style);
    transform->setDirection(direction);
    return transform;
}

/// Appends the steps from the working space to one that the configuration knows, and returns that one's name. A
/// configuration without the working space is entered through ACES2065-1.
std::string enter(const ColorConfig& config, WorkingSpace working_space, OCIO::GroupTransform& steps) {
    if (const std::string name = config.find(working_space); !name.empty())
        return name;
    if (!config.config->hasRole("aces_interchange"))
        throw UsageError(fmt::format("the colour configuration has neither {} nor the role aces_interchange; choose "
                                     "another with --ocio",
                                     working_space == WorkingSpace::acescg ? "ACEScg" : "a linear Rec.709 space"));
    if (working_space == WorkingSpace::rec709)
        steps.appendTransform(builtin("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD", OCIO::TRANSFORM_DIR_INVERSE));
    steps.appendTransform(builtin("ACEScg_to_ACES2065-1", OCIO::TRANSFORM_DIR_FORWARD));
    return "aces_interchange";
}

/// A way through the configuration, and where it ends.
struct ColorPath {
    OCIO::GroupTransformRcPtr steps = OCIO::GroupTransform::Create();
    std::string description; ///< for messages
    FileColors colors;
};

void append_look(const ColorConfig& config, const std::string& look, const std::string& source, ColorPath& path) {
    if (look.empty())
        return;
    auto transform = OCIO::LookTransform::Create();
    transform->setSrc(source.c_str());
    transform->setDst(source.c_str());
    transform->setLooks(choose("--look", look, config.looks()).c_str());
    path.steps->appendTransform(transform);
    path.description = fmt::format("look '{}', ", look);
}

void append_view(const ColorConfig& config, const ColorSettings& settings, const std::string& source, ColorPath& path) {
    const auto asked = [](const std::string& name, const char* otherwise) { return name.empty() ? otherwise : name; };
    const std::string display =
        choose("--display", asked(settings.display, config.config->getDefaultDisplay()), config.displays());
    const std::string view =
        choose("--view", asked(settings.view, config.config->getDefaultView(display.c_str())), config.views(display));
    auto transform = OCIO::DisplayViewTransform::Create();
    transform->setSrc(source.c_str());
    transform->setDisplay(display.c_str());
    transform->setView(view.c_str());
    path.steps->appendTransform(transform);
    path.description += fmt::format("display '{}', view '{}'", display, view);
    std::string name = config.config->getDisplayViewColorSpaceName(display.c_str(), view.c_str());
    if (name.empty() || name == OCIO::OCIO_VIEW_USE_DISPLAY_NAME)
        name = display;
    path.colors = {.encoding = config.file_colors(name).encoding};
}

void append_space(const ColorConfig& config, const std::string& name, const std::string& source, ColorPath& path) {
    if (!config.config->getColorSpace(name.c_str())) // aliases and roles are known, too
        choose("--colorspace", name, config.spaces());
    auto transform = OCIO::ColorSpaceTransform::Create();
    transform->setSrc(source.c_str());
    transform->setDst(name.c_str());
    path.steps->appendTransform(transform);
    path.description += fmt::format("colour space '{}'", name);
    path.colors = config.file_colors(name);
}

ColorPath color_path(const ColorConfig& config, const ColorSettings& settings) {
    ColorPath path;
    const std::string source = enter(config, settings.working_space, *path.steps);
    append_look(config, settings.look, source, path);
    if (settings.target == ColorTarget::space)
        append_space(config, settings.space, source, path);
    else
        append_view(config, settings, source, path);
    return path;
}

/// Whether a conversion is made of steps that keep the order of numbers, or turn it around, channel by channel.
bool is_monotone(const OCIO::ConstProcessorRcPtr& processor) {
    const OCIO::GroupTransformRcPtr steps = processor->createGroupTransform();
    for (int i = 0; i < steps->getNumTransforms(); ++i) {
        const OCIO::TransformType type = steps->getTransform(i)->getTransformType();
        if (type != OCIO::TRANSFORM_TYPE_EXPONENT && type != OCIO::TRANSFORM_TYPE_EXPONENT_WITH_LINEAR &&
            type != OCIO::TRANSFORM_TYPE_MATRIX)
            return false;
    }
    return true;
}

/// Applies `change` to the samples whose magnitude is above `limit` or is no number, in parallel. Returns how many
/// there were. Hardly ever there is one: blocks are first looked through as integers, which keep the order of
/// magnitudes, and which the compiler compares many at once.
template <class Change> uint64_t change_beyond(Image& image, float limit, const Change& change) {
    const auto magnitude = [](float value) { return std::bit_cast<uint32_t>(value) & 0x7fffffffu; };
    std::atomic<uint64_t> changed{0};
    tbb::parallel_for(tbb::blocked_range<size_t>(0, image.rgb.size(), 1 << 16), [&](const auto& samples) {
        uint32_t largest = 0;
        for (size_t i = samples.begin(); i != samples.end(); ++i)
            largest = std::max(largest, magnitude(image.rgb[i]));
        if (largest <= magnitude(limit))
            return;
        uint64_t count = 0;
        for (size_t i = samples.begin(); i != samples.end(); ++i)
            if (float& value = image.rgb[i]; magnitude(value) > magnitude(limit)) {
                value = change(value);
                ++count;
            }
        changed += count;
    });
    return changed;
}

} // namespace

struct ColorTransform::Implementation {
    OCIO::ConstCPUProcessorRcPtr processor; ///< null: nothing to do
    std::optional<LevelCurve> curve;        ///< the same for files of 8 bits
    FileColors file;
    std::string identity;
};

ColorTransform::ColorTransform(const ColorSettings& settings) : implementation_(std::make_unique<Implementation>()) {
    if (settings.target == ColorTarget::scene_linear) {
        implementation_->file = file_colors(settings.working_space);
        implementation_->identity = implementation_->file.interop_id;
        return;
    }
    const ColorConfig config = load_color_config(settings);
    const ColorPath path = color_path(config, settings);
    try {
        const auto steps = config.config->getProcessor(path.steps)->getOptimizedProcessor(optimization);
        const auto processor = steps->getOptimizedCPUProcessor(OCIO::BIT_DEPTH_F32, OCIO::BIT_DEPTH_F32, optimization);
        implementation_->processor = processor;
        if (is_monotone(steps) && !processor->hasChannelCrosstalk())
            implementation_->curve = LevelCurve::of([&](std::span<float> rgb) {
                OCIO::PackedImageDesc pixels(rgb.data(), long(rgb.size() / 3), 1, 3);
                processor->apply(pixels);
            });
    } catch (const OCIO::Exception& error) {
        throw FileError(fmt::format("{}: {}: {}", config.name, path.description, error.what()));
    }
    implementation_->file = path.colors;
    implementation_->identity = fmt::format("{} {}", implementation_->processor->getCacheID(), path.colors.encoding);
}

ColorTransform::~ColorTransform() = default;
ColorTransform::ColorTransform(ColorTransform&&) noexcept = default;

const FileColors& ColorTransform::file() const {
    return implementation_->file;
}

const std::string& ColorTransform::identity() const {
    return implementation_->identity;
}

void ColorTransform::apply(Image& image) const {
    if (!implementation_->processor)
        return;
    tbb::parallel_for(tbb::blocked_range<uint32_t>(0, image.height, 8), [&](const tbb::blocked_range<uint32_t>& rows) {
        OCIO::PackedImageDesc slice(image.rgb.data() + size_t(rows.begin()) * image.width * 3, long(image.width),
                                    long(rows.size()), 3);
        implementation_->processor->apply(slice);
    });
}

bool ColorTransform::to_levels(Image& image) const {
    if (!implementation_->curve)
        return false;
    image.levels.resize(image.rgb.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, image.rgb.size() / 3, 1 << 14), [&](const auto& pixels) {
        const size_t first = pixels.begin() * 3, count = pixels.size() * 3;
        implementation_->curve->apply({image.rgb.data() + first, count}, {image.levels.data() + first, count});
    });
    return true;
}

uint64_t replace_non_finite(Image& image) {
    return change_beyond(image, std::numeric_limits<float>::max(),
                         [](float value) { return std::isnan(value) ? 0.0f : std::copysign(largest_half, value); });
}

uint64_t clamp_to_half(Image& image) {
    return change_beyond(image, largest_half, [](float value) { return std::copysign(largest_half, value); });
}

} // namespace proxima
