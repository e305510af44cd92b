// SPDX-License-Identifier: Apache-2.0
#include "renderer/displayed_picture.h"

#include <algorithm>
#include <utility>

namespace proxima {

Image displayed_picture(StoredImage picture, const ColorTransform& view) {
    Image image{picture.width, picture.height, std::move(picture.samples)};
    if (is_scene_linear(picture.type)) {
        view.apply(image);
        return image;
    }
    const double scale = full_scale(picture.type);
    std::ranges::transform(image.rgb, image.rgb.begin(), [=](float level) { return float(double(level) / scale); });
    return image;
}

} // namespace proxima
