// SPDX-License-Identifier: Apache-2.0
// From linear Rec.709 to what a display shows, by OpenColorIO. The configuration is --ocio's file, else $OCIO's, else
// the one inside the program.
#pragma once
#include "renderer/image.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace proxima {

struct ColorSettings {
    std::optional<std::filesystem::path> config; ///< --ocio
    std::string display;                         ///< empty: the configuration's default
    std::string view;                            ///< empty: the display's default
};

/// One display and view, ready to be applied from any thread.
class ColorTransform {
public:
    /// Throws UsageError, with the choices, for a display or view that the configuration does not have, and FileError
    /// when the configuration cannot be read or used.
    explicit ColorTransform(const ColorSettings& settings);
    ~ColorTransform();
    ColorTransform(ColorTransform&&) noexcept;

    /// Replaces the linear numbers by the display's, rows in parallel. Values are not clipped.
    void apply(Image& image) const;

    /// How the result is encoded, in OpenImageIO's words: "sRGB", "Linear", "Gamma2.4"; empty when it has no such name.
    const std::string& encoding() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Makes every sample finite: NaN becomes 0, an infinity the largest half-float of its sign (one such channel would
/// spoil its neighbours in a colour transform). Returns how many samples were replaced.
uint64_t replace_non_finite(Image& image);

/// Brings samples beyond the largest half-float back to it. Returns how many there were.
uint64_t clamp_to_half(Image& image);

} // namespace proxima
