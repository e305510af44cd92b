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

void plan_command(const PlanOptions& options) {
    const Animation& animation = options.scene.animation;
    if (animation.frames.empty())
        throw UsageError("--shard: nothing to plan: there are fewer frames than shards");
    SceneSource scene(options.scene);
    scene.record_stills();
    const FrameScenes scenes = scene.scenes(animation.frames.front());
    std::fputs(scene.messages(false).c_str(), stderr);
    std::vector<PlanSection> sections{motion_plan(scene.program(), scene.obstacle(), animation),
                                      feature_plan(scene.program(), animation),
                                      precision_plan(scene.program(), scene.float_fit())};
    const ChosenDevice device = choose_devices(options.device, options.threads).front();
    try {
        sections.push_back(method_plan(scenes, options.frame, device));
    } catch (const MotionUndefined&) {
        sections.push_back(method_plan(scene.scenes_by_script(animation.frames.front()), options.frame, device));
    }
    std::fputs((options.json ? plan_json(sections) : plan_text(sections)).c_str(), stdout);
}

} // namespace proxima
