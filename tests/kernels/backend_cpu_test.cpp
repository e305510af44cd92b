// SPDX-License-Identifier: Apache-2.0
#include "renderer/backend_cpu.h"
#define BACKENDS CpuBackend
#include "tests/kernels/backend_tests.h"
#include "tests/kernels/motion_backend_tests.h"

#include "tests/kernels/aov_backend_tests.h"
#include "tests/kernels/baseline_backend_tests.h"

template <> std::unique_ptr<FrameRenderer> proxima::test::make_renderer<CpuBackend>() {
    return make_cpu_renderer(0);
}

TEST_CASE("cpu: the number of threads does not change a bit") {
    const SceneProgram scene = random_scene(4, {.spheres = 3000, .radius = 0.1, .mirrors = true, .glass = true});
    FrameSettings settings;
    settings.width = 64;
    settings.height = 48;
    const auto with_threads = [&](unsigned threads) { return render(*make_cpu_renderer(threads), scene, settings); };
    CHECK(same_bits(with_threads(1), with_threads(3)));
}

TEST_CASE("cpu: a scene set in one precision is not rendered in another") {
    const auto renderer = make_cpu_renderer(1);
    renderer->set_scene(empty_scene(), Precision::float32);
    Image image;
    CHECK_THROWS_AS(renderer->render(single_ray(Precision::float64), image), std::logic_error);
}
