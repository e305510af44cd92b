// SPDX-License-Identifier: Apache-2.0
// What trades accuracy for time: what can be chosen for a scene, how errors are measured, and what is concluded.
#include "renderer/scene_hash.h"
#include "renderer/tradeoff/chart.h"
#include "renderer/tradeoff/choose_quality.h"
#include "renderer/tradeoff/quality_space.h"
#include "renderer/tradeoff/text.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace proxima;

namespace {

SceneProgram plain_scene() {
    SceneProgram scene;
    scene.materials = {Material{}};
    scene.layers = {Layer{}};
    scene.pigments = {Pigment{}};
    scene.finishes = {Finish{}};
    scene.lights = {Light<double>{}};
    return scene;
}

SceneProgram rich_scene() {
    SceneProgram scene = plain_scene();
    scene.materials[0].flags = material_reflective;
    AreaLight<double> area;
    area.columns = 5;
    area.rows = 3;
    area.adaptive = 1;
    scene.area_lights = {area};
    scene.lights[0].area = 0;
    scene.depends_on_time = true;
    return scene;
}

size_t options_of(const SceneProgram& scene, const QualitySetting& asked, QualityAspect aspect) {
    return quality_space(scene, asked)[size_t(aspect)].settings.size();
}

Image grey_image(uint32_t side, float value) {
    return {side, side, std::vector<float>(size_t(side) * side * 3, value)};
}

TradeoffPoint point(double ms, double levels) {
    TradeoffPoint result{.options = std::to_string(ms), .repeats = {ms, ms * 1.1}, .pilot_ms = ms, .ms = ms};
    result.error.levels = levels;
    return result;
}

size_t count(const std::string& text, std::string_view part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

} // namespace

TEST_CASE("quality: only what a scene can react to is varied") {
    const QualitySetting still;
    QualitySetting blurred;
    blurred.shutter_samples = 16;
    for (const auto aspect : {QualityAspect::trace_level, QualityAspect::bailout, QualityAspect::area_places,
                              QualityAspect::shutter_samples}) {
        CAPTURE(name_of(aspect));
        CHECK(options_of(plain_scene(), blurred, aspect) == 1);
        CHECK(options_of(rich_scene(), blurred, aspect) > 1);
    }
    CHECK(options_of(rich_scene(), still, QualityAspect::shutter_samples) == 1);
    SceneProgram flat = rich_scene();
    flat.max_trace_level = 1;
    CHECK(options_of(flat, still, QualityAspect::trace_level) == 1);
    CHECK(options_of(plain_scene(), still, QualityAspect::sampling) > 10);
}

TEST_CASE("quality: the options of an aspect go down from what was asked for, and change nothing else") {
    QualitySetting asked;
    asked.shutter_samples = 16;
    const auto space = quality_space(rich_scene(), asked);
    const auto& levels = space[size_t(QualityAspect::trace_level)].settings;
    CHECK(levels[0] == asked);
    CHECK(levels[1].overrides.max_trace_level == 3); // of 5
    CHECK(levels.back().overrides.max_trace_level == 1);
    const auto& places = space[size_t(QualityAspect::area_places)].settings;
    CHECK(places[1].overrides.area_places == 3); // of 5
    CHECK(places.back().overrides.area_places == 1);
    QualitySetting mixed = asked;
    take(QualityAspect::area_places, places[1], mixed);
    take(QualityAspect::trace_level, levels[1], mixed);
    CHECK(mixed.overrides.max_trace_level == 3);
    CHECK(mixed.overrides.area_places == 3);
    CHECK(mixed.shutter_samples == 16);
    CHECK(option_text(mixed, asked) == "--precision float --samples 1 --max-trace-level 3 --area-places 3");
}

TEST_CASE("quality: the most rays that a pixel may take are counted") {
    const QualitySetting one;
    CHECK(most_rays(plain_scene(), one, 1) == 2);     // of the camera, and to the light
    CHECK(most_rays(rich_scene(), one, 1) == 5 * 16); // 5 levels, 15 places
    QualitySetting less = one;
    less.overrides = {.max_trace_level = 2, .adc_bailout = {}, .area_places = 2};
    less.precision = Precision::float64;
    less.shutter_samples = 3;
    CHECK(most_rays(rich_scene(), less, 4) == 4.0 * 3 * 2 * 5 * 2);
}

TEST_CASE("quality: what a command line sets in the scene's place is part of its hash") {
    const SceneProgram scene = rich_scene();
    const auto hash_with = [&](const SceneOverrides& overrides) {
        SceneProgram changed = scene;
        apply(overrides, changed);
        return hash_scene(changed);
    };
    const Hash128 as_it_is = hash_scene(scene);
    CHECK(hash_with({}) == as_it_is);
    CHECK(hash_with({.max_trace_level = 5}) == as_it_is);
    CHECK_FALSE(hash_with({.max_trace_level = 4}) == as_it_is);
    CHECK_FALSE(hash_with({.adc_bailout = 0.1f}) == as_it_is);
    CHECK_FALSE(hash_with({.area_places = 2}) == as_it_is);
    CHECK(hash_with({.area_places = 5}) == as_it_is);
}

TEST_CASE("quality: fewer places of an area light have weights of their own, which sum up to 1") {
    SceneProgram scene = rich_scene();
    scene.area_lights[0].adaptive = AreaLight<double>::every_place;
    apply({.area_places = 2}, scene);
    CHECK(scene.area_lights[0].columns == 2);
    CHECK(scene.area_lights[0].rows == 2);
    REQUIRE(scene.area_samples.size() == 4);
    float sum = 0;
    for (const AreaSample& sample : scene.area_samples)
        sum += sample.weight;
    CHECK(sum == doctest::Approx(1));
}

TEST_CASE("picture error: a picture is equal to itself") {
    Image image = grey_image(16, 0.5f);
    image.rgb[3] = 40;
    const PictureError error = measure_error(image, image);
    CHECK(error.rms == 0);
    CHECK(error.levels == 0);
    CHECK(error.max == 0);
    CHECK(error.visible == 0);
    CHECK(error.ssim.value() == doctest::Approx(1));
}

TEST_CASE("picture error: figures of pictures whose difference is known") {
    const Image black = grey_image(16, 0);
    // 0.0031308 * 12.92 is 0.04045: 10.31 levels. L* is 903.3 times Y there: 2.83, over the just noticeable 2.3.
    const PictureError dark = measure_error(grey_image(16, 0.0031308f), black);
    CHECK(dark.rms == doctest::Approx(0.0031308));
    CHECK(dark.levels == doctest::Approx(10.315).epsilon(1e-3));
    CHECK(dark.visible == 1);
    const PictureError darker = measure_error(grey_image(16, 0.0025f), black); // L* = 2.26
    CHECK(darker.visible == 0);
    // Above white there is nothing to see.
    const PictureError bright = measure_error(grey_image(16, 3), grey_image(16, 2));
    CHECK(bright.rms == doctest::Approx(1));
    CHECK(bright.levels == 0);
    CHECK(bright.visible == 0);
    Image spot = black;
    spot.rgb[0] = spot.rgb[1] = spot.rgb[2] = 1;
    const PictureError one = measure_error(spot, black);
    CHECK(one.max == 1);
    CHECK(one.visible == doctest::Approx(1.0 / 256));
    CHECK(one.levels == doctest::Approx(255.0 / 16));
}

TEST_CASE("quality: independent errors add up by their squares") {
    const PictureError sum = combine({.rms = 3, .max = 1, .levels = 6, .ssim = {}, .visible = 0.5},
                                     {{.rms = 4, .max = 2, .levels = 8, .ssim = {}, .visible = 0.7}});
    CHECK(sum.rms == doctest::Approx(5));
    CHECK(sum.levels == doctest::Approx(10));
    CHECK(sum.max == 3);
    CHECK(sum.visible == 1);
}

TEST_CASE("tradeoff: the front is what nothing else beats, and recommendations keep their level") {
    TradeoffRecord record;
    record.points = {point(9, 0.4), point(1, 12), point(3, 3), point(2, 5), point(4, 3.5), point(5, 3), point(7, 1)};
    conclude(record);
    for (const TradeoffPoint& a : record.points) {
        const bool is_beaten = std::ranges::any_of(record.points, [&](const TradeoffPoint& b) {
            return b.ms <= a.ms && b.error.levels <= a.error.levels && (b.ms < a.ms || b.error.levels < a.error.levels);
        });
        CHECK(a.on_front == !is_beaten);
    }
    const std::vector<double> times = {2, 3, 7, 7, 9}; // 8, 4, 2, 1, 0.5 levels
    REQUIRE(record.recommendations.size() == times.size());
    for (size_t i = 0; i < times.size(); ++i)
        CHECK(record.points[record.recommendations[i].point.value()].ms == times[i]);
    record.points.pop_back(); // the most accurate one
    conclude(record);
    CHECK_FALSE(record.recommendations.back().point);
    record.reference_error.levels = 3; // then nothing is known of 2 and less
    conclude(record);
    CHECK(record.recommendations[1].point);
    CHECK_FALSE(record.recommendations[2].point);
}

TEST_CASE("tradeoff: a time is shown with the least and the most of its repeats, grown as it is") {
    TradeoffPoint several;
    several.repeats = {4, 2, 3};
    several.pilot_ms = 3;
    several.ms = 30;
    CHECK(several.range() == std::pair(20.0, 40.0));
    CHECK(several.spread() == doctest::Approx(2.0 / 3));
}

TEST_CASE("tradeoff: the chart has every point, and no name in it is markup") {
    TradeoffRecord record{.scene = "<b>&.scn", .device = "cpu"};
    record.points = {point(1, 12), point(3, 0), point(2000, 5)};
    conclude(record);
    const std::string svg = tradeoff_svg(record);
    CHECK(count(svg, "<circle") == 3 + 3); // and the legend
    CHECK(count(svg, "<b>") == 0);
    CHECK(count(svg, "&lt;b&gt;&amp;.scn") == 1);
    CHECK(count(svg, "nan") + count(svg, "inf") == 0);
}

TEST_CASE("tradeoff: the tables have a line a setting") {
    TradeoffRecord record;
    record.points = {point(1, 12), point(3, 2)};
    conclude(record);
    const std::string csv = tradeoff_csv(record);
    CHECK(csv.starts_with(
        "options,ms,pilot_ms,spread,camera_rays_a_pixel,levels_rms,rms,max,ssim,visible_share,on_front\n"));
    CHECK(count(csv, "\n") == 3);
    CHECK(count(tradeoff_text(record), "\n*") == 2); // both are on the front
}
