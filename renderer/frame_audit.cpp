// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_audit.h"
#include "parser/source_files.h"
#include "renderer/image_decoder.h"
#include "renderer/image_file.h"
#include "renderer/image_module.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace proxima {
namespace {

struct FileFound {
    AuditedFrame frame;
    std::string hash; ///< that the file claims
};

/// What can be said without the scene; `complete` until then.
FileFound look_at(AuditedFrame frame, const RenderOptions& options) {
    const auto not_complete = [&](FrameState state, std::string reason) {
        frame.state = state;
        frame.reason = std::move(reason);
        return FileFound{frame, {}};
    };
    std::error_code error;
    if (!std::filesystem::exists(frame.file, error))
        return not_complete(FrameState::missing, "there is no such file");
    StoredImage image;
    try {
        image = read_image_file(frame.file);
    } catch (const FileError& reason) { // begins with the file's name
        return not_complete(FrameState::corrupt, std::string(reason.what()).substr(frame.file.string().size() + 2));
    }
    if (image.width != options.frame.width || image.height != options.frame.height)
        return not_complete(FrameState::foreign, fmt::format("it is {} x {} pixels, not {} x {}", image.width,
                                                             image.height, options.frame.width, options.frame.height));
    if (image.hash.empty())
        return not_complete(FrameState::foreign, "it has no hash of a scene in it");
    if (!std::ranges::all_of(image.samples, [](float sample) { return std::isfinite(sample); }))
        return not_complete(FrameState::corrupt, "it holds numbers that are not finite");
    frame.state = FrameState::complete;
    return {frame, image.hash};
}

} // namespace

std::vector<AuditedFrame> audit_frames(const RenderOptions& options, SceneSource& scene, const FrameHash& hash,
                                       const std::vector<std::string>& backends) {
    image_module_function<DecodeImage>(decoder_function); // a module that is missing is no fault of the files
    const std::vector<int64_t>& frames = options.scene.animation.frames;
    std::vector<FileFound> found(frames.size());
    tbb::parallel_for(size_t(0), frames.size(), [&](size_t i) {
        found[i] = look_at({frames[i], options.output->path(frames[i])}, options);
    });

    std::vector<AuditedFrame> audited;
    for (FileFound& file : found) {
        AuditedFrame& frame = file.frame;
        if (frame.state == FrameState::complete) { // a scene is evaluated only for files that may be of it
            scene.scenes(frame.frame);
            const SceneFacts facts = scene.facts(frame.frame);
            if (std::ranges::none_of(backends, [&](const std::string& backend) {
                    return hash.of(frame.frame, facts, backend) == file.hash;
                })) {
                frame.state = FrameState::foreign;
                frame.reason = "it is of another scene, or was made with other options";
            }
        }
        audited.push_back(std::move(frame));
    }
    return audited;
}

} // namespace proxima
