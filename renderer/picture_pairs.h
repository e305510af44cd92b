// SPDX-License-Identifier: Apache-2.0
// What `proxima compare` was given in, pairs of pictures out: two files, two sequences, or two folders.
#pragma once
#include "renderer/stored_image.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace proxima {

struct PicturePair {
    std::string name; ///< of the pair: a frame, a file's name
    std::string a, b; ///< what the pictures are: files, programs; empty where there is none
    std::function<StoredImage()> load_a{}, load_b{}; ///< throw FileError
};

/// Pairs by frame number when the names have a place for one (`####`, `%04d`), by file name in two folders, else the
/// two files. A picture that only one side has makes a pair without the other; so do `frames` that one side lacks, or
/// both. Throws UsageError for two things that do not go together, FileError when there is nothing to compare.
std::vector<PicturePair> pair_files(const std::filesystem::path& a, const std::filesystem::path& b,
                                    const std::vector<int64_t>& frames);

} // namespace proxima
