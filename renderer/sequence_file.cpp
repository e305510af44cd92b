// SPDX-License-Identifier: Apache-2.0
#include "renderer/sequence_file.h"
#include "renderer/atomic_file.h"

#include <utility>

namespace proxima {

SequenceFile::SequenceFile(std::filesystem::path path, std::unique_ptr<SequenceEncoder> encoder)
    : path_(std::move(path)), encoder_(std::move(encoder)) {}

void SequenceFile::add(size_t index, std::vector<uint8_t> levels) {
    const std::lock_guard lock(mutex_);
    early_.emplace(index, std::move(levels));
    for (; !early_.empty() && early_.begin()->first == next_; ++next_) {
        encoder_->append(early_.begin()->second.data());
        early_.erase(early_.begin());
    }
}

void SequenceFile::finish() {
    write_file(path_, encoder_->finish());
}

} // namespace proxima
