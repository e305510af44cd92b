// SPDX-License-Identifier: Apache-2.0
// A frame that comes together from bands of rows, whoever renders them: one device or several.
#pragma once
#include "renderer/frame_renderer.h"
#include "renderer/frame_writer.h"

#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace proxima {

/// Any member may be called by any thread.
class FrameAssembly {
public:
    explicit FrameAssembly(size_t bands) : bands_left_(bands) {}

    /// The picture that the bands are rendered into; the first caller takes it from the writer, and `renderer` prepares
    /// it if it has been used before.
    Image& image(FrameWriter& writer, const FrameSettings& settings, FrameRenderer& renderer);
    /// `device` finished a band. True for the last one: the frame is complete, and release() gives it out.
    bool add(const std::string& device, const FrameStatistics& band);
    /// The picture, and what it took: times are summed up over the bands, and the devices are listed.
    FinishedFrame release(FrameRecord record, size_t index);

private:
    std::mutex mutex_;
    std::optional<Image> image_;
    size_t bands_left_;
    std::set<std::string> devices_;
    FrameStatistics statistics_;
};

/// The bands of a picture that is shared out among `devices`: several for each, so that one that is faster gets more.
std::vector<Rows> cut_into_bands(uint32_t height, size_t devices);

/// The same, by size: `rows` each, a multiple of Rows::unit; of a band that is to be cut further.
std::vector<Rows> cut_into_bands(Rows whole, uint32_t rows);

} // namespace proxima
