// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/contact_sheet.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace proxima::testing {
namespace {

constexpr int name_width = 310, text_height = 14, margin = 6;

float encoded(float v) {
    const float c = std::clamp(v == v ? v : 0.0f, 0.0f, 1.0f);
    return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}

/// Without filtering: it is pixels that are to be seen.
void draw(OIIO::ImageBuf& sheet, const Image& image, int left, int top, int width, int height) {
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const size_t from_x = size_t(x) * image.width / width, from_y = size_t(y) * image.height / height;
            const float* from = image.rgb.data() + 3 * (from_y * image.width + from_x);
            const float rgb[3] = {encoded(from[0]), encoded(from[1]), encoded(from[2])};
            sheet.setpixel(left + x, top + y, rgb);
        }
}

void write(OIIO::ImageBuf& sheet, int x, int y, const std::string& text, int size) {
    const float black[3] = {0, 0, 0};
    if (!OIIO::ImageBufAlgo::render_text(sheet, x, y, text, size, "DejaVuSans", black))
        throw std::runtime_error("no text on the contact sheet (Debian's fonts-dejavu-core has DejaVuSans): " +
                                 sheet.geterror());
}

} // namespace

void write_contact_sheet(const std::filesystem::path& file, const std::vector<std::string>& heading,
                         const std::vector<SheetRow>& rows, int cell) {
    const int height = cell * 3 / 4, row_height = height + text_height + margin;
    const int columns = int(heading.size());
    const OIIO::ImageSpec spec(name_width + columns * (cell + margin) + margin, 28 + int(rows.size()) * row_height, 3,
                               OIIO::TypeDesc::UINT8);
    OIIO::ImageBuf sheet(spec);
    const float paper[3] = {1, 1, 1};
    OIIO::ImageBufAlgo::fill(sheet, paper);
    for (int c = 0; c < columns; ++c)
        write(sheet, name_width + c * (cell + margin), 20, heading[c], 14);
    for (size_t r = 0; r < rows.size(); ++r) {
        const int top = 28 + int(r) * row_height;
        write(sheet, margin, top + height / 2, rows[r].name, 14);
        for (size_t c = 0; c < rows[r].pictures.size(); ++c) {
            const SheetPicture& picture = rows[r].pictures[c];
            const int left = name_width + int(c) * (cell + margin);
            if (picture.image)
                draw(sheet, *picture.image, left, top, cell, height);
            write(sheet, left, top + height + 11, picture.text, 11);
        }
    }
    if (!sheet.write(file.string()))
        throw std::runtime_error(sheet.geterror());
}

} // namespace proxima::testing
