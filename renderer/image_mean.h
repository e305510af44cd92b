// SPDX-License-Identifier: Apache-2.0
// The mean of pictures of one size, added one by one; of a band of rows. Layers are those of the one picture that has
// them.
#pragma once
#include "renderer/frame_renderer.h"
#include "renderer/image.h"

#include <algorithm>

namespace proxima {

class ImageMean {
public:
    /// What the next picture is to be rendered into.
    Image& next() { return picture_; }

    /// Adds the picture's rows.
    void add(const Rows& rows) {
        const float* const first = picture_.row(rows.first);
        const size_t size = size_t(rows.count) * picture_.width * 3;
        if (count_++ == 0)
            sum_.assign(first, first + size);
        else
            std::transform(sum_.begin(), sum_.end(), first, sum_.begin(), [](float a, float b) { return a + b; });
        if (!picture_.aovs.empty())
            aovs_.assign(picture_.row_of_aovs(rows.first), picture_.row_of_aovs(rows.first + rows.count));
    }

    /// Writes the mean into the rows of `image`.
    void store(Image& image, const Rows& rows) const {
        image.fit(picture_.width, picture_.height, false, !aovs_.empty());
        std::copy(aovs_.begin(), aovs_.end(), image.row_of_aovs(rows.first));
        const float count = float(count_);
        std::transform(sum_.begin(), sum_.end(), image.row(rows.first), [=](float sum) { return sum / count; });
    }

private:
    Image picture_;
    std::vector<float> sum_;
    std::vector<AovSample> aovs_;
    uint32_t count_ = 0;
};

} // namespace proxima
