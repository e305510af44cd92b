// SPDX-License-Identifier: Apache-2.0
// The quick ones of the extremes: double draws them, float with its automatic help draws the same.
#include "renderer/float_fit.h"
#include "tests/extremes/cases.h"
#include "tests/extremes/figures.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace proxima;
using namespace proxima::testing;

namespace {

FrameSettings settings_of(const ExtremeCase& extreme, Precision precision) {
    FrameSettings settings;
    settings.width = extreme.width;
    settings.height = extreme.height;
    settings.precision = precision;
    return settings;
}

uint64_t count_hits(const Probes& probes) {
    uint64_t count = 0;
    for (const ProbedHit& hit : probes.hits)
        count += hit.id != 0;
    return count;
}

} // namespace

TEST_CASE("extremes: float with its automatic help sees what double sees") {
    for (const ExtremeCase& extreme : extreme_cases()) {
        if (!extreme.is_quick)
            continue;
        CAPTURE(extreme.name);
        const SceneProgram scene = read_case(extreme);
        const Precision helped = chosen_precision(Precision::automatic, float_fit(scene, extreme.width).holds());
        const FrameSettings in_double = settings_of(extreme, Precision::float64);
        const FrameSettings as_helped = settings_of(extreme, helped);
        const Reference reference = reference_hits(scene, in_double);
        const HitFigures figures = compare_hits(reference, probe(scene, as_helped), scene);
        CHECK(figures.wrong == 0);
        CHECK(figures.not_finite == 0);
        CHECK(figures.most_pixels <= outline_tolerance);

        const Image exact = render_scene(scene, in_double);
        const Image picture = helped == Precision::float64 ? exact : render_scene(scene, as_helped);
        CHECK(compare_levels(exact, picture).not_finite == 0);
        if (extreme.by_a_hair)
            CHECK(share_seen_beside(pictures_beside(scene, in_double), picture) == 1);
        else
            CHECK(compare_levels(exact, picture).within_one >= 0.999);
    }
}

TEST_CASE("extremes: no picture in float has a NaN or an infinity, whatever it is of") {
    for (const ExtremeCase& extreme : extreme_cases()) {
        if (!extreme.is_quick)
            continue;
        CAPTURE(extreme.name);
        const Image image = render_scene(read_case(extreme), settings_of(extreme, Precision::float32));
        CHECK(compare_levels(image, image).not_finite == 0);
    }
}

TEST_CASE("extremes: a grid, a cloud and neither make the same picture, and its layers are numbers") {
    for (const ExtremeCase& extreme : extreme_cases()) {
        if (!extreme.is_quick)
            continue;
        CAPTURE(extreme.name);
        const SceneProgram scene = read_case(extreme);
        for (const Precision precision : {Precision::float32, Precision::float64}) {
            FrameSettings settings = settings_of(extreme, precision);
            settings.aovs = {.depth = true, .normal = true, .id = true, .steps = false};
            settings.accelerator = Accelerator::brute;
            const Image brute = render_scene(scene, settings);
            CHECK(std::ranges::all_of(brute.aovs, [](const AovSample& sample) {
                return std::isfinite(sample.depth) && std::isfinite(glm::dot(sample.normal, sample.normal));
            }));
            for (const Accelerator accelerator : {Accelerator::grid, Accelerator::cloud}) {
                settings.accelerator = accelerator;
                CHECK(render_scene(scene, settings).rgb == brute.rgb);
            }
        }
    }
}

TEST_CASE("extremes: in double an outline is where it is, to the last bit of a radius") {
    const auto hits = [](const char* off) {
        ExtremeCase extreme{"", "grazing.scn", {{"Off", off}}, 16, 16};
        return count_hits(probe(read_case(extreme), settings_of(extreme, Precision::float64)));
    };
    CHECK(hits("-1") == 0);
    CHECK(hits("0") == 0); // a ray that touches a ball misses it
    CHECK(hits("1") == 64);
}

TEST_CASE("extremes: what a scene has twice throws no shadow on itself, and of glass it is as if once") {
    const Declares kinds[] = {{{"Kind", "0"}}, {{"Kind", "1"}}, {{"Kind", "2"}}, {{"Kind", "2"}, {"Inside", "1"}}};
    for (const Declares& kind : kinds)
        for (const auto& [precision, height] : {std::pair(Precision::float32, "1"),
                                                {Precision::float64, "1"},
                                                {Precision::float32, "0.7"},
                                                {Precision::float64, "0.7"}}) {
            CAPTURE(kind.size());
            CAPTURE(height);
            ExtremeCase extreme{"", "twice.scn", kind};
            extreme.declares.emplace_back("Height", height);
            extreme.declares.emplace_back("Times", "1");
            FrameSettings settings = settings_of(extreme, precision);
            settings.accelerator = Accelerator::brute;
            const Image once = render_scene(read_case(extreme), settings);
            extreme.declares.back().second = "3";
            for (const Accelerator accelerator : {Accelerator::brute, Accelerator::grid, Accelerator::cloud}) {
                settings.accelerator = accelerator;
                CHECK(render_scene(read_case(extreme), settings).rgb == once.rgb);
            }
        }
}

TEST_CASE("extremes: a sphere on a globe of radius 123456.7 stands on it in float, and its shadow begins there") {
    const ExtremeCase extreme{"", "ground.scn", {{"Radius", "123456.7"}}, 96, 72};
    const SceneProgram scene = read_case(extreme);
    REQUIRE(float_fit(scene, extreme.width).holds());
    const Image in_double = render_scene(scene, settings_of(extreme, Precision::float64));
    const Image in_float = render_scene(scene, settings_of(extreme, Precision::float32));
    CHECK(compare_levels(in_double, in_float).within_one >= 0.999);
    FrameSettings brute = settings_of(extreme, Precision::float32);
    brute.accelerator = Accelerator::brute;
    CHECK(render_scene(scene, brute).rgb == in_float.rgb);
}
