// SPDX-License-Identifier: Apache-2.0
// The bars that float keeps against double over all examples.
#include "renderer/float_fit.h"
#include "tests/extremes/figures.h"
#include "tests/extremes/scene_text.h"

#include <doctest/doctest.h>

using namespace proxima;
using namespace proxima::testing;

TEST_CASE("examples: float hits what double hits, and 8-bit samples are within a level") {
    uint64_t examples = 0;
    for (const auto& entry : std::filesystem::directory_iterator(PROXIMA_EXAMPLES)) {
        if (entry.path().extension() != ".scn")
            continue;
        ++examples;
        CAPTURE(entry.path());
        FrameSettings settings;
        settings.width = 160;
        settings.height = 120;
        const SceneProgram scene = read_scene(entry.path(), settings.width, settings.height);
        CHECK(float_fit(scene, 1920).holds());
        const Reference reference = reference_hits(scene, settings);
        const HitFigures figures = compare_hits(reference, probe(scene, settings), scene);
        CHECK(figures.wrong == 0);
        CHECK(figures.not_finite == 0);
        CHECK(figures.other <= figures.rays / 1000);

        const Image in_float = render_scene(scene, settings);
        settings.precision = Precision::float64;
        const LevelFigures levels = compare_levels(render_scene(scene, settings), in_float);
        CHECK(levels.not_finite == 0);
        CHECK(levels.within_one >= 0.999);
    }
    CHECK(examples >= 19);
}
