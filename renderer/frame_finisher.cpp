// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_finisher.h"
#include "renderer/atomic_file.h"
#include "renderer/camera_matrices.h"
#include "renderer/displayed_picture.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace proxima {

FrameFinisher::FrameFinisher(const RenderOptions& options)
    : options_(options), color_(options.color), hash_(options, color_.identity()) {
    if (!options.movie && !options.report)
        return;
    ColorSettings shown = options.color;
    shown.target = ColorTarget::view;
    view_.emplace(shown);
    if (options.movie)
        movie_.emplace(*options.movie, options.rate);
    if (options.report)
        page_.emplace(*options.report);
}

void FrameFinisher::start(Progress& progress, RunWatch watch) {
    progress_ = &progress;
    watch_ = watch;
    encoder_.emplace(options_.output->format());
}

void FrameFinisher::show_kept(const std::vector<AuditedFrame>& frames) {
    if (!page_)
        return;
    tbb::parallel_for(size_t(0), frames.size(), [&](size_t i) {
        const AuditedFrame& frame = frames[i];
        const Image picture = displayed_picture(read_image_file(frame.file), *view_);
        page_->add_picture(frame.frame, RenderPage::thumbnail(picture), *encoder_);
        page_->add_kept(frame.frame, frame.file);
    });
}

void FrameFinisher::operator()(FinishedFrame& frame) {
    FrameRecord& record = frame.record;
    if (options_.multi_gpu.discard)
        return;
    record.hash = hash_.of(record.frame, record.scene, backend_of(record.device));
    if (page_)
        show(frame);
    FrameWatch watch(watch_, Timeline::writer, record.frame);
    take_step(&watch, FrameStep::color, record.color_ms, [&] { prepare(frame); });
    report(record);
    if (holds_animation(options_.output->format())) {
        take_step(&watch, FrameStep::encode, record.encode_ms,
                  [&] { sequence(frame).add(frame.index, quantize_to_bytes(frame.image, options_.dither)); });
        return;
    }
    std::vector<unsigned char> bytes;
    take_step(&watch, FrameStep::encode, record.encode_ms,
              [&] { bytes = encoder_->encode(frame.image, file_settings(record)); });
    take_step(&watch, FrameStep::write, record.write_ms, [&] { write_file(record.file, bytes); });
}

void FrameFinisher::show(const FinishedFrame& frame) {
    Image small = RenderPage::thumbnail(frame.image);
    replace_non_finite(small);
    view_->apply(small);
    page_->add_picture(frame.record.frame, small, *encoder_);
}

void FrameFinisher::prepare(FinishedFrame& frame) {
    if (!frame.image.halves.empty()) { // the device has done it
        frame.record.replaced_samples = frame.record.statistics.replaced_samples;
        frame.record.clamped_samples = frame.record.statistics.clamped_samples;
        return;
    }
    frame.record.replaced_samples = replace_non_finite(frame.image);
    if (options_.type == SampleType::uint8 && !options_.dither && color_.to_levels(frame.image))
        return;
    color_.apply(frame.image);
    if (options_.type == SampleType::half)
        frame.record.clamped_samples = clamp_to_half(frame.image);
}

void FrameFinisher::report(const FrameRecord& record) {
    if (record.replaced_samples > 0)
        progress_->note(fmt::format("frame {}: {} samples were not finite; NaN became 0, infinity 65504", record.frame,
                                    record.replaced_samples));
    if (record.clamped_samples > 0)
        progress_->note(
            fmt::format("frame {}: {} samples were beyond 65504, the largest half; they became that; --bits "
                        "float keeps them",
                        record.frame, record.clamped_samples));
}

ImageFileSettings FrameFinisher::file_settings(const FrameRecord& record) const {
    ImageFileSettings settings{.format = options_.output->format(),
                               .type = options_.type,
                               .compression = options_.compression,
                               .dither = options_.dither,
                               .layers = options_.frame.aovs};
    ImageFacts& facts = settings.facts;
    facts.scene = options_.scene.scene.filename().string();
    facts.hash = record.hash;
    facts.frame = record.frame;
    if (!options_.scene.animation.is_still)
        facts.rate = options_.rate;
    facts.color_encoding = color_.file().encoding;
    facts.chromaticities = color_.file().chromaticities;
    facts.color_interop_id = color_.file().interop_id;
    const CameraMatrices camera = camera_matrices(record.scene.camera);
    facts.world_to_camera = camera.world_to_camera;
    facts.world_to_ndc = camera.world_to_ndc;
    return settings;
}

SequenceFile& FrameFinisher::sequence(const FinishedFrame& frame) {
    const std::lock_guard lock(mutex_);
    if (!sequence_)
        sequence_ = std::make_unique<SequenceFile>(
            frame.record.file,
            encoder_->encode_sequence(frame.image.width, frame.image.height, file_settings(frame.record)));
    return *sequence_;
}

void FrameFinisher::announce(const FrameRecord& record) {
    progress_->frame_written(record.frame, record.file);
    if (page_)
        page_->add_frame(record);
}

void FrameFinisher::finish() {
    if (sequence_)
        sequence_->finish();
    if (!movie_)
        return;
    std::vector<std::filesystem::path> pictures;
    for (const int64_t frame : options_.scene.animation.frames)
        pictures.push_back(options_.output->path(frame));
    movie_->make(pictures, *view_);
    progress_->note(fmt::format("made {} of {} frames", options_.movie->string(), pictures.size()));
}

void FrameFinisher::write_page(const RunRecord& run, const std::string& error) const {
    if (page_)
        page_->finish(run, progress_->notes(), error);
}

} // namespace proxima
