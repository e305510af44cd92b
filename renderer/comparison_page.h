// SPDX-License-Identifier: Apache-2.0
// The --report folder: index.html and the pictures that it shows. The page needs nothing else, no network either.
#pragma once
#include "renderer/comparison.h"
#include "renderer/image_file.h"

#include <filesystem>

namespace proxima {

class ComparisonPage {
public:
    /// Makes the folder if it is not there. Throws FileError when it cannot be written.
    explicit ComparisonPage(std::filesystem::path folder);

    /// Writes pair number `index`'s pictures: both sides and the difference. Throws FileError.
    void add_pictures(size_t index, const ImagePair& pair, double tolerance, ImageEncoder& encoder) const;

    /// Writes the page: failures first, the largest first. Throws FileError.
    void finish(const ComparisonRecord& comparison) const;

private:
    std::filesystem::path folder_;
};

} // namespace proxima
