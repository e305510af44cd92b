// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/bench_scenes.h"
#include "bench/embedded_scenes.h"
#include "renderer/atomic_file.h"
#include "renderer/scene_source.h"

#include <cstring>
#include <fmt/format.h>

namespace proxima {

BenchScenes::BenchScenes(const std::filesystem::path& folder) : folder_(folder) {
    for (const EmbeddedScene& scene : embedded_bench_scenes)
        write_file(folder_ / scene.name, {reinterpret_cast<const unsigned char*>(scene.text), std::strlen(scene.text)});
}

std::shared_ptr<const SceneProgram> BenchScenes::load(const std::string& name, uint64_t spheres, uint32_t width,
                                                      uint32_t height) {
    const std::string wanted = fmt::format("{} {} {}x{}", name, spheres, width, height);
    if (program_ && loaded_ == wanted)
        return program_;
    program_.reset(); // two large scenes at once may be one too many
    SceneOptions options;
    options.scene = folder_ / (name + ".scn");
    options.width = width;
    options.height = height;
    options.declares = {{"Count", std::to_string(spheres)}, {"Moving", "1"}};
    options.animation = Animation::sequence({1, 2}, {1, 2});
    options.budget.steps = ~0ull;
    SceneSource source(options);
    program_ = source.scenes(1).programs.front();
    loaded_ = wanted;
    return program_;
}

} // namespace proxima
