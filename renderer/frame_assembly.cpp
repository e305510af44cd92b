// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_assembly.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace proxima {

Image& FrameAssembly::image(FrameWriter& writer, const FrameSettings& settings, FrameRenderer& renderer) {
    const std::lock_guard lock(mutex_);
    if (!image_) {
        image_ = writer.take_image();
        const bool is_used_again = image_->bytes() > 0;
        image_->fit(settings.width, settings.height, settings.in_halves, settings.aovs.any());
        if (is_used_again)
            renderer.lock_pages(*image_);
    }
    return *image_;
}

bool FrameAssembly::add(const std::string& device, const FrameStatistics& band) {
    const std::lock_guard lock(mutex_);
    devices_.insert(device);
    statistics_.add(band);
    return --bands_left_ == 0;
}

FinishedFrame FrameAssembly::release(FrameRecord record, size_t index) {
    const std::lock_guard lock(mutex_);
    record.device = fmt::format("{}", fmt::join(devices_, ","));
    record.statistics = std::move(statistics_);
    return {std::move(*image_), std::move(record), index};
}

std::vector<Rows> cut_into_bands(uint32_t height, size_t devices) {
    constexpr size_t bands_of_a_device = 8;
    const size_t rows = (height + devices * bands_of_a_device - 1) / (devices * bands_of_a_device);
    return cut_into_bands(Rows{0, height}, uint32_t((rows + Rows::unit - 1) / Rows::unit * Rows::unit));
}

std::vector<Rows> cut_into_bands(Rows whole, uint32_t rows) {
    std::vector<Rows> bands;
    for (uint32_t first = 0; first < whole.count; first += rows)
        bands.push_back({whole.first + first, std::min(rows, whole.count - first)});
    return bands;
}

} // namespace proxima
