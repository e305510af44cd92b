// SPDX-License-Identifier: Apache-2.0
// From the numbers that were rendered to those in a file, by OpenColorIO: what a display shows, another colour space,
// or nothing at all. The configuration is --ocio's file, else $OCIO's, else the one inside the program.
#pragma once
#include "renderer/image.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace proxima {

/// What red, green and blue of a scene mean: linear light with these primaries.
enum class WorkingSpace { rec709, acescg };

enum class ColorTarget {
    scene_linear, ///< the working space itself
    view,         ///< of a display
    space,        ///< a colour space by its name
};

struct ColorSettings {
    std::optional<std::filesystem::path> config{}; ///< --ocio
    std::string display{};                         ///< empty: the configuration's default
    std::string view{};                            ///< empty: the display's default
    std::string look{};                            ///< applied before the view or the space; empty: none
    std::string space{};
    ColorTarget target = ColorTarget::view;
    WorkingSpace working_space = WorkingSpace::rec709;
};

/// What a file's header says about its colours.
struct FileColors {
    std::string encoding{};   ///< in OpenImageIO's words: "sRGB", "Linear", "Gamma2.4"; empty for others
    std::string interop_id{}; ///< of linear light: "lin_rec709_scene", "lin_ap1_scene", "lin_ap0_scene"
    std::optional<std::array<float, 8>> chromaticities{}; ///< the same: x and y of red, green, blue, white
};

/// One way for colours to go, ready to be applied from any thread.
class ColorTransform {
public:
    /// Throws UsageError, with the choices, for a name that the configuration does not have, and FileError when the
    /// configuration cannot be read or used. Without a conversion no configuration is read.
    explicit ColorTransform(const ColorSettings& settings);
    ~ColorTransform();
    ColorTransform(ColorTransform&&) noexcept;

    /// Replaces the rendered numbers, rows in parallel. Values are not clipped.
    void apply(Image& image) const;

    /// Fills `image.levels` with what apply() and quantize() would give for a file of 8 bits; `image` holds finite
    /// numbers, which stay. False, and nothing done, where the conversion is more than a curve for each channel.
    bool to_levels(Image& image) const;

    const FileColors& file() const;

    /// A name for what happens to colours: equal names, equal results. It does not say where the configuration is.
    const std::string& identity() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// What `settings`' configuration offers: displays with their views, looks and colour spaces, a line each.
/// Throws FileError.
std::string list_color_choices(const ColorSettings& settings);

/// Makes every sample finite: NaN becomes 0, an infinity the largest half-float of its sign (one such channel would
/// spoil its neighbours in a colour transform). Returns how many samples were replaced.
uint64_t replace_non_finite(Image& image);

/// Brings samples beyond the largest half-float back to it. Returns how many there were.
uint64_t clamp_to_half(Image& image);

} // namespace proxima
