// SPDX-License-Identifier: Apache-2.0
#include "renderer/choose_devices.h"
#include "renderer/commands.h"
#include "renderer/errors.h"
#include "renderer/feature_plan.h"
#include "renderer/method_plan.h"
#include "renderer/motion_plan.h"
#include "renderer/precision_plan.h"
#include "renderer/scene_source.h"

#include <cstdio>

namespace proxima {
namespace {

/// Of the first frame.
FramePlan frame_plan(FrameRenderer& renderer, const PlanOptions& options, SceneSource& source, FrameScenes scenes) {
    for (bool by_script = false;; by_script = true)
        try {
            renderer.set_scene(*scenes.programs.front(), options.frame.precision);
            return renderer.plan(options.frame, scenes.moments, false);
        } catch (const MotionUndefined&) {
            if (by_script)
                throw;
            scenes = source.scenes_by_script(options.scene.animation.frames.front());
        }
}

} // namespace

void plan_command(const PlanOptions& options) {
    const Animation& animation = options.scene.animation;
    if (animation.frames.empty())
        throw UsageError("--shard: nothing to plan: there are fewer frames than shards");
    SceneSource scene(options.scene);
    scene.record_stills();
    const FrameScenes scenes = scene.scenes(animation.frames.front());
    std::fputs(scene.messages(false).c_str(), stderr);
    const auto renderer = choose_renderer(options.device, options.threads);
    const FramePlan plan = frame_plan(*renderer, options, scene, scenes);
    const std::vector<PlanSection> sections{motion_plan(scene.program(), scene.obstacle(), animation),
                                            feature_plan(scene.program(), animation),
                                            precision_plan(scene.program(), scene.float_fit()),
                                            method_plan(plan, renderer->name())};
    std::fputs((options.json ? plan_json(sections) : plan_text(sections)).c_str(), stdout);
}

} // namespace proxima
