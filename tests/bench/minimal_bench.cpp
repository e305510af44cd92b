// SPDX-License-Identifier: Apache-2.0
// minimal_bench SCENE cpu|cuda [WIDTH HEIGHT [REPEATS]]: the renderer's kernels for plain opaque scenes beside a
// minimal one, in turn. Medians of milliseconds, and how many pixels differ by more than 1/255.
#include "tests/bench/minimal_bench.h"
#include "parser/scene_script.h"
#include "renderer/frame_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>

using namespace proxima;

namespace {

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

SceneProgram read(const char* path, uint32_t width, uint32_t height) {
    Diagnostics diagnostics;
    SceneScript script(path, {}, diagnostics);
    EvaluationSettings settings;
    settings.image_width = width;
    settings.image_height = height;
    SceneProgram scene = script.evaluate(settings, diagnostics);
    if (diagnostics.has_errors())
        throw std::runtime_error(diagnostics.format(script.files()));
    return scene;
}

void run(const char* path, bool on_cuda, uint32_t width, uint32_t height, uint32_t repeats) {
    const SceneProgram scene = read(path, width, height);
    const bench::MinimalGrid grid = bench::make_minimal_grid(scene);
    const auto renderer = on_cuda ? make_cuda_renderer(0) : make_cpu_renderer(0);
    renderer->set_scene(scene, Precision::float32);
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.accelerator = Accelerator::grid;
    Image image;
    FrameStatistics statistics = renderer->render(settings, image);
    std::vector<double> minimal, ours;
    bench::MinimalRun last;
    for (uint32_t round = 0; round < 5; ++round) {
        last = on_cuda ? bench::run_minimal_on_cuda(grid, width, height, repeats)
                       : bench::run_minimal_on_cpu(grid, width, height, repeats);
        minimal.insert(minimal.end(), last.ms.begin(), last.ms.end());
        for (uint32_t repeat = 0; repeat < repeats; ++repeat) {
            statistics = renderer->render(settings, image);
            ours.push_back(statistics.trace_ms);
        }
    }
    size_t different = 0;
    for (size_t i = 0; i < last.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (std::abs(last.pixels[i][c] - image.rgb[3 * i + size_t(c)]) > 1.0f / 255) {
                ++different;
                break;
            }
    fmt::print("{} spheres, {}x{}, grid {}x{}x{} (minimal {}x{}x{})\n", scene.spheres.size(), width, height,
               statistics.grid[0], statistics.grid[1], statistics.grid[2], grid.scene.size.x, grid.scene.size.y,
               grid.scene.size.z);
    fmt::print(
        "minimal {:.3f} ms, renderer {:.3f} ms: {:.3f} times; {:.3f} % of the pixels differ by more than 1/255\n",
        median(minimal), median(ours), median(ours) / median(minimal),
        100 * double(different) / double(last.pixels.size()));
}

} // namespace

int main(int argc, char** argv) {
    const auto number = [&](int index, uint32_t otherwise) {
        return argc > index ? uint32_t(std::atoi(argv[index])) : otherwise;
    };
    if (argc < 3) {
        fmt::print(stderr, "usage: minimal_bench SCENE cpu|cuda [WIDTH HEIGHT [REPEATS]]\n");
        return 2;
    }
    try {
        run(argv[1], std::string_view(argv[2]) == "cuda", number(3, 1920), number(4, 1080), number(5, 5));
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "minimal_bench: {}\n", error.what());
        return 1;
    }
}
