// SPDX-License-Identifier: Apache-2.0
#include "renderer/program_pairs.h"
#include "renderer/choose_devices.h"
#include "renderer/errors.h"
#include "renderer/image_file.h"
#include "renderer/povray_run.h"
#include "renderer/scene_source.h"

#include <cstdio>
#include <fmt/format.h>
#include <limits>
#include <memory>

namespace proxima {
namespace {

/// Proxima's side: the scene and the device, as render_command has them.
class SceneRenderer {
public:
    explicit SceneRenderer(const CompareOptions& options)
        : options_(options), scene_(options.scene), renderer_(choose_renderer(options.device, options.threads)) {
        load(options.scene.animation.frames.front());
        std::fputs(scene_.messages(false).c_str(), stderr);
    }

    StoredImage render(int64_t frame) {
        load(frame);
        FrameSettings settings = options_.frame;
        settings.precision = precision_;
        renderer_->render(settings, image_);
        StoredImage picture{.width = image_.width,
                            .height = image_.height,
                            .type = SampleType::uint16,
                            .encoding = "Linear",
                            .samples = image_.rgb};
        for (float& sample : picture.samples) // what is not finite stays so, and is counted
            if (sample == sample && sample <= std::numeric_limits<float>::max())
                sample = quantize<uint16_t>(sample, std::numeric_limits<uint16_t>::max());
        return picture;
    }

private:
    void load(int64_t frame) {
        if (!scene_.load(frame))
            return;
        precision_ = chosen_precision(options_.frame.precision, scene_.float_fit().holds());
        renderer_->set_scene(scene_.program(), precision_);
        scene_.release_program();
    }

    const CompareOptions& options_;
    SceneSource scene_;
    std::unique_ptr<FrameRenderer> renderer_;
    Precision precision_ = Precision::float64;
    Image image_;
};

} // namespace

std::vector<PicturePair> pair_programs(const CompareOptions& options) {
    const auto renderer = std::make_shared<SceneRenderer>(options);
    const Animation& animation = options.scene.animation;
    const std::string scene = options.scene.scene.string();
    std::vector<PicturePair> pairs;
    for (const int64_t frame : animation.frames)
        pairs.push_back({.name = animation.is_still ? scene : fmt::format("frame {}", frame),
                         .a = "POV-Ray",
                         .b = "Proxima",
                         .load_a =
                             [&options, frame] {
                                 return render_with_povray(options.scene, options.frame.antialiasing, frame,
                                                           options.time_limit);
                             },
                         .load_b = [renderer, frame] { return renderer->render(frame); }});
    return pairs;
}

} // namespace proxima
