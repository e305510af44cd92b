// SPDX-License-Identifier: Apache-2.0
// What the motion programs of a script say about a time is what the script says itself at that time, bit for bit; but
// for the sign of zeros.
#include "tests/parser/evaluate.h"
#include "tests/parser/random_script.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>

using namespace proxima;
using namespace proxima::testing;

namespace {

EvaluationSettings settings_at(const MotionTime& time, bool record) {
    EvaluationSettings settings;
    settings.time.clock = time.clock;
    settings.time.frame_number = time.frame_number;
    settings.time.clock_delta = time.clock_delta;
    settings.record_motion = record;
    settings.budget.steps = 1'000'000;
    return settings;
}

/// Everything that a picture depends on, as numbers in a fixed order.
class Numbers {
public:
    explicit Numbers(const SceneProgram& scene) : scene_(scene) {
        for (size_t i = 0; i < scene.spheres.size(); ++i) {
            add(scene.spheres[i].center);
            add({scene.spheres[i].radius});
            add_material(scene.sphere_materials[i]);
        }
        for (const Plane<double>& plane : scene.planes) {
            add(plane.normal);
            add({plane.distance});
            add_material(plane.material);
        }
        for (const Light<double>& light : scene.lights) {
            add(light.position);
            add(light.color);
            add(light.point_at);
            add(light.direction);
            add({light.radius, light.falloff, light.tightness, light.fade_distance, light.fade_power});
        }
        for (const Fog<double>& fog : scene.fogs) {
            add(fog.color);
            add({fog.distance, fog.filter, fog.transmit});
        }
        add(scene.camera.location);
        add(scene.camera.direction);
        add(scene.camera.right);
        add(scene.camera.up);
        add(scene.background);
        add_ellipsoids();
    }

    const std::vector<double>& all() const { return all_; }

private:
    void add(std::initializer_list<double> numbers) { all_.insert(all_.end(), numbers); }
    template <class Vector> void add(const Vector& v) { add({double(v.x), double(v.y), double(v.z)}); }
    void add(const Affine<double>& map) {
        for (int i = 0; i < 3; ++i)
            add(map.linear[i]);
        add(map.offset);
    }
    void add(const PigmentColor& color) {
        add(color.rgb);
        add({color.filter, color.transmit});
    }
    void add_material(uint32_t index) {
        const Material& material = scene_.materials[index];
        add({double(material.flags)});
        for (uint32_t i = 0; i < material.layer_count; ++i) {
            const Layer& layer = scene_.layers[material.first_layer + i];
            const Pigment& pigment = scene_.pigments[layer.pigment];
            add(pigment.color);
            add(pigment.second_color);
            add(pigment.transform == Pigment::no_transform ? Affine<double>() : scene_.transforms[pigment.transform]);
            if (has_color_map(pigment.kind)) {
                const Pattern& pattern = scene_.patterns[pigment.pattern];
                add({pattern.frequency, pattern.phase});
                for (uint32_t k = 0; k < pattern.stop_count; ++k)
                    add(scene_.color_stops[pattern.first_stop + k].color);
            }
            const Finish& finish = scene_.finishes[layer.finish];
            add({finish.diffuse, finish.phong});
            add(finish.reflection_max);
        }
    }
    /// A union's spheres that become ellipsoids in time may stand in another order.
    void add_ellipsoids() {
        std::vector<std::vector<double>> each;
        for (const Ellipsoid<double>& ellipsoid : scene_.ellipsoids) {
            std::vector<double> outer = std::exchange(all_, {});
            add(ellipsoid.world_from_object);
            add(ellipsoid.object_from_world);
            add_material(ellipsoid.material);
            each.push_back(std::exchange(all_, std::move(outer)));
        }
        std::ranges::sort(each);
        for (const std::vector<double>& ellipsoid : each)
            all_.insert(all_.end(), ellipsoid.begin(), ellipsoid.end());
    }

    const SceneProgram& scene_;
    std::vector<double> all_;
};

uint64_t first_seed() {
    const char* given = std::getenv("PROXIMA_TEST_SEED");
    return given ? std::strtoull(given, nullptr, 10) : 20'260'101;
}

size_t cases() {
    const char* given = std::getenv("PROXIMA_TEST_CASES");
    return given ? std::strtoull(given, nullptr, 10) : 2000;
}

struct Tally {
    size_t moved = 0;     ///< scenes that programs said
    size_t left = 0;      ///< that were left to the script, which had something to say
    size_t mistaken = 0;  ///< in which the script finds a mistake at the other time
    size_t obstacles = 0; ///< that had to be evaluated for every frame
};

void compare_ways(const std::string& text, uint64_t seed, Tally& tally) {
    CAPTURE(seed);
    const MotionTime now{0.25, 3, 0.125}, then{0.625, 6, 0.125};
    Evaluated recorded = evaluate(text, settings_at(now, true));
    if (recorded.diagnostics.has_errors())
        return;
    INFO(text);
    const Evaluated still = evaluate(text, settings_at(now, false));
    CHECK(Numbers(recorded.scene).all() == Numbers(still.scene).all());
    const Evaluated direct = evaluate(text, settings_at(then, false));
    if (recorded.scene.obstacle) {
        CHECK(recorded.scene.motion.empty());
        ++tally.obstacles;
        return;
    }
    const bool moved = move(recorded.scene, then);
    if (direct.diagnostics.has_errors()) { // in something that reaches the picture, or not: then programs do not see it
        ++tally.mistaken;
    } else if (moved) {
        const std::vector<double> by_programs = Numbers(recorded.scene).all(), by_script = Numbers(direct.scene).all();
        const bool equal = by_programs == by_script;
        CHECK_MESSAGE(equal, text);
        ++tally.moved;
    } else {
        ++tally.left;
    }
}

} // namespace

TEST_CASE("motion: a random expression says the same by its program and by the script") {
    Tally tally;
    const uint64_t first = first_seed();
    MESSAGE("first seed " << first << " (PROXIMA_TEST_SEED)");
    for (uint64_t seed = first; seed < first + 2 * cases(); ++seed) {
        RandomScript script(seed);
        compare_ways("#declare R = seed(3);\nsphere { " + script.vector(3) + ", abs(" + script.number(5) + ")+0.1 }",
                     seed, tally);
    }
    MESSAGE(tally.moved << " moved, " << tally.left << " left to the script, " << tally.mistaken << " mistakes");
    CHECK(tally.obstacles < cases() / 50); // too long for a program
    CHECK(tally.moved > cases());
}

TEST_CASE("motion: a random script says the same by its programs and evaluated again") {
    Tally tally;
    const uint64_t first = first_seed();
    MESSAGE("first seed " << first << " (PROXIMA_TEST_SEED)");
    for (uint64_t seed = first; seed < first + cases(); ++seed)
        compare_ways(RandomScript(seed).scene(seed % 4 == 0), seed, tally);
    MESSAGE(tally.moved << " moved, " << tally.left << " left to the script, " << tally.mistaken << " mistakes, "
                        << tally.obstacles << " looked at the time");
    CHECK(tally.moved > cases() / 5);
    CHECK(tally.obstacles > 0);
}
