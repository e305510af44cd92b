// SPDX-License-Identifier: Apache-2.0
#include "tests/povray/picture.h"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace proxima::testing {

Picture16 read_picture16(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input)
        throw std::runtime_error(path.string() + ": " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.nchannels != 3 || spec.format != OIIO::TypeDesc::UINT16)
        throw std::runtime_error(path.string() + ": not a 16-bit RGB picture");
    Picture16 picture{spec.width, spec.height, {}};
    picture.rgb.resize(size_t(spec.width) * size_t(spec.height) * 3);
    // A truncated file reads as black pixels and a pending error.
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT16, picture.rgb.data()) || input->has_error())
        throw std::runtime_error(path.string() + ": " + input->geterror());
    return picture;
}

Difference compare(const Picture16& a, const Picture16& b, int tolerance, const std::vector<Pixel>& excused) {
    if (a.width != b.width || a.height != b.height)
        throw std::runtime_error("the pictures differ in size");
    Difference result;
    size_t equal8 = 0;
    double squares = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const size_t first = (size_t(y) * size_t(a.width) + size_t(x)) * 3;
            int pixel_largest = 0;
            for (size_t sample = first; sample < first + 3; ++sample) {
                const int difference = std::abs(int(a.rgb[sample]) - int(b.rgb[sample]));
                pixel_largest = std::max(pixel_largest, difference);
                squares += double(difference) * double(difference);
            }
            equal8 += pixel_largest <= 257;
            const Pixel pixel{x, y};
            const bool is_excused = std::find(excused.begin(), excused.end(), pixel) != excused.end();
            if (pixel_largest > tolerance)
                (is_excused ? result.excused : result.over).push_back(pixel);
            if (!is_excused && pixel_largest > result.largest) {
                result.largest = pixel_largest;
                result.worst = pixel;
            }
        }
    const double pixels = double(a.width) * double(a.height);
    result.share_equal8 = double(equal8) / pixels;
    result.root_mean_square = std::sqrt(squares / (3 * pixels));
    return result;
}

bool is_on_outline(const Picture16& picture, Pixel pixel) {
    const auto sample = [&](int x, int y, int channel) {
        return int(picture.rgb[(size_t(y) * size_t(picture.width) + size_t(x)) * 3 + size_t(channel)]);
    };
    for (int y = std::max(pixel.y - 1, 0); y <= std::min(pixel.y + 1, picture.height - 1); ++y)
        for (int x = std::max(pixel.x - 1, 0); x <= std::min(pixel.x + 1, picture.width - 1); ++x)
            for (int channel = 0; channel < 3; ++channel)
                if (std::abs(sample(x, y, channel) - sample(pixel.x, pixel.y, channel)) > 8 * 257)
                    return true;
    return false;
}

} // namespace proxima::testing
