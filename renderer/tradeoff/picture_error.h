// SPDX-License-Identifier: Apache-2.0
// How far a rendered picture is from another one that is taken for right.
#pragma once
#include "renderer/image.h"

#include <optional>

namespace proxima {

/// White is 1; samples that are not finite count as replace_non_finite has them.
struct PictureError {
    double rms = 0;               ///< of linear light, nothing clipped
    double max = 0;               ///< the same, of the worst sample
    double levels = 0;            ///< RMS of what a display shows: sRGB, clipped, 255 for white
    std::optional<double> ssim{}; ///< of the displayed luma; nothing for pictures under 11 pixels a side
    double visible = 0;           ///< the share of pixels whose displayed colours a viewer can tell apart, see below

    /// The larger of each figure (of SSIM the smaller).
    void widen(const PictureError& other);
};

/// A pixel is visibly different when its colours in CIELAB (1976, white D65) are further apart than 2.3, the just
/// noticeable difference that Mahy, Van Eycken and Oosterlinck found ("Evaluation of Uniform Color Spaces Developed
/// after the Adoption of CIELAB and CIELUV", Color Research and Application, 1994). Both pictures are of one size,
/// linear Rec.709, and hold floats.
PictureError measure_error(const Image& picture, const Image& reference);

/// Which figure a limit is of, and how large it may be.
struct ErrorLimit {
    bool is_levels = false; ///< PictureError::levels; else PictureError::rms
    double most = 0;

    double figure(const PictureError& error) const { return is_levels ? error.levels : error.rms; }
    bool holds(const PictureError& error) const { return figure(error) <= most; }
};

} // namespace proxima
