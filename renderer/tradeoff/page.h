// SPDX-License-Identifier: Apache-2.0
// The folder of `proxima tradeoff`: tables, the chart, and index.html with the pictures to look at side by side. The
// page needs nothing but this folder, no network either.
#pragma once
#include "renderer/image_file.h"
#include "renderer/tradeoff/record.h"

#include <filesystem>

namespace proxima {

class TradeoffPage {
public:
    /// Makes the folder if it is not there. Throws FileError when it cannot be written.
    explicit TradeoffPage(std::filesystem::path folder);

    /// Writes the pictures of a point: what a display shows, and how far it is from the reference; and the reference
    /// itself. Throws FileError.
    void add_point(size_t index, const Image& picture, const Image& reference);
    void add_reference(const Image& reference);
    /// Writes the picture in each way that trades size or time for accuracy, and measures that.
    void add_files(TradeoffRecord& record, const Image& picture);

    /// Writes the tables, the chart and the page.
    void finish(const TradeoffRecord& record) const;

private:
    std::filesystem::path folder_;
    ImageEncoder encoder_;
};

} // namespace proxima
