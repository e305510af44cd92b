// SPDX-License-Identifier: Apache-2.0
// An animation that is one file. Its pictures come in from any thread and in any order; they go into the file in the
// order of their numbers.
#pragma once
#include "renderer/image_encoder.h"

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace proxima {

class SequenceFile {
public:
    SequenceFile(std::filesystem::path path, std::unique_ptr<SequenceEncoder> encoder);

    /// Picture number `index`, from 0; those that are early wait in memory. Throws std::runtime_error.
    void add(size_t index, std::vector<uint8_t> levels);
    /// Writes the file, after the last picture. Throws FileError and std::runtime_error.
    void finish();

private:
    std::filesystem::path path_;
    std::unique_ptr<SequenceEncoder> encoder_;
    std::mutex mutex_;
    std::map<size_t, std::vector<uint8_t>> early_;
    size_t next_ = 0;
};

} // namespace proxima
