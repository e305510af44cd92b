// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_finisher.h"
#include "renderer/atomic_file.h"

#include <fmt/format.h>

namespace proxima {

FrameFinisher::FrameFinisher(const RenderOptions& options) : options_(options) {
    if (!is_scene_linear(options.type))
        color_.emplace(options.color);
}

void FrameFinisher::start(Progress& progress) {
    progress_ = &progress;
    encoder_.emplace();
}

void FrameFinisher::operator()(FinishedFrame& frame) {
    FrameRecord& record = frame.record;
    timed(record.color_ms, [&] {
        record.replaced_samples = replace_non_finite(frame.image);
        if (color_)
            color_->apply(frame.image);
    });
    if (record.replaced_samples > 0)
        progress_->note(fmt::format("frame {}: {} samples were not finite; NaN became 0, infinity 65504", record.frame,
                                    record.replaced_samples));
    const ImageFileSettings settings{.format = options_.output->format(),
                                     .type = options_.type,
                                     .color_encoding = color_ ? color_->encoding() : "Linear",
                                     .scene = options_.scene.scene.filename().string(),
                                     .frame = record.frame};
    const auto bytes = timed(record.encode_ms, [&] { return encoder_->encode(frame.image, settings); });
    timed(record.write_ms, [&] { write_file(record.file, bytes); });
}

void FrameFinisher::announce(const FrameRecord& record) {
    progress_->frame_written(record.frame, record.file);
}

} // namespace proxima
