// SPDX-License-Identifier: Apache-2.0
// Pictures as the comparison needs them, and the figures of a difference.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace proxima::testing {

/// Three 16-bit samples a pixel, rows from top to bottom.
struct Picture16 {
    int width = 0;
    int height = 0;
    std::vector<uint16_t> rgb;
};

/// Reads a 16-bit RGB file. Throws std::runtime_error when it is missing, damaged or of another form.
Picture16 read_picture16(const std::filesystem::path& path);

struct Pixel {
    int x = 0;
    int y = 0;
    bool operator==(const Pixel&) const = default;
};

struct Difference {
    int largest = 0;             ///< the largest |a - b| of a sample, in 1/65535, outside the excused pixels
    Pixel worst;                 ///< where that is
    double share_equal8 = 0;     ///< pixels within 1/255 on every channel
    double root_mean_square = 0; ///< over all samples, in 1/65535
    std::vector<Pixel> over;     ///< pixels over the tolerance that nobody excused
    std::vector<Pixel> excused;  ///< excused pixels that are over the tolerance
};

/// Compares two pictures of one size; `tolerance` in 1/65535.
Difference compare(const Picture16& a, const Picture16& b, int tolerance, const std::vector<Pixel>& excused = {});

/// Whether some neighbour of a pixel differs from it by more than 8/255: the outline of something passes there.
bool is_on_outline(const Picture16& picture, Pixel pixel);

} // namespace proxima::testing
