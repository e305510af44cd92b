// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_hash.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <functional>
#include <set>

using namespace proxima;

namespace {

RenderOptions render(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), {"proxima", "render", "ball.scn", "--frames", "1-9"});
    if (std::ranges::find(arguments, std::string_view("-o")) == arguments.end())
        arguments.insert(arguments.end(), {"-o", "a.#.exr"});
    return std::get<RenderOptions>(parse_command_line(int(arguments.size()), arguments.data()));
}

std::string hash_with(const std::vector<const char*>& arguments, bool float_holds = true) {
    const RenderOptions options = render(arguments);
    return FrameHash(options, "color").of(3, {{1, 2}, options.scene.animation.clock(3), {}, float_holds}, "cpu");
}

SceneProgram a_scene() {
    SceneProgram scene;
    scene.spheres = {{{0, 0, 0}, 1}, {{1, 2, 3}, 0.5}};
    scene.sphere_materials = {0, 0};
    scene.materials = {Material{}};
    scene.layers = {Layer{}};
    scene.pigments = {Pigment{}};
    scene.finishes = {Finish{}};
    scene.interiors = {Interior{}};
    scene.lights = {Light<double>{}};
    scene.ellipsoids = {Ellipsoid<double>{}};
    scene.planes = {Plane<double>{}};
    return scene;
}

} // namespace

TEST_CASE("frame hash: each option that changes the file changes the hash") {
    const std::vector<std::vector<const char*>> rows = {
        {},
        {"--size", "32x24"},
        {"--samples", "4"},
        {"--antialias", "grid:3"},
        {"--antialias", "method1:0.3:3"},
        {"--antialias", "method1:0.2:3"},
        {"--precision", "double"},
        {"--tolerances", "povray"},
        {"--bits", "float"},
        {"--compression", "dwaa"},
        {"--fps", "25"},
        {"--clock", "0:2"},
        {"--cyclic"},
        {"-o", "a.#.tif"},
        {"-o", "a.#.png"},
        {"-o", "a.#.png", "--dither"},
        {"--aov", "depth"},
        {"--aov", "normal"},
        {"--aov", "id"},
        {"--aov", "id,depth"},
        {"--aov", "steps"},
        {"--aov", "steps", "--accel", "cloud"}, // whose steps these are
        {"--aov", "steps", "--grid", "20"},
        {"--aov", "steps", "--metric", "octant"},
        {"--aov", "steps", "--brick", "2"},
    };
    std::set<std::string> hashes;
    for (auto arguments : rows) {
        CAPTURE(arguments.empty() ? "none" : arguments.back());
        CHECK(hashes.insert(hash_with(arguments)).second);
    }
    const RenderOptions options = render({});
    const SceneFacts facts{{1, 2}, options.scene.animation.clock(3), {}};
    const FrameHash hash(options, "color");
    CHECK(hashes.insert(hash.of(4, facts, "cpu")).second);
    CHECK(hashes.insert(hash.of(3, facts, "cuda")).second);
    CHECK(hashes.insert(hash.of(3, {{1, 3}, facts.time, {}}, "cpu")).second);
    CHECK(hashes.insert(hash.of(3, {{1, 2}, options.scene.animation.clock(4), {}}, "cpu")).second);
    CHECK(hashes.insert(FrameHash(options, "another").of(3, facts, "cpu")).second);
}

TEST_CASE("frame hash: how the work is done does not matter") {
    const std::vector<std::vector<const char*>> rows = {
        {"--accel", "brute"},   {"--accel", "cloud", "--metric", "octant"},
        {"--grid", "20"},       {"--threads", "1"},
        {"--subset", "3"},      {"--shard", "3/9"},
        {"--progress", "json"}, {"--device", "cpu"},
        {"-o", "b.##.exr"},     {"--skip-existing"},
    };
    for (auto arguments : rows) {
        CAPTURE(arguments.back());
        CHECK(hash_with(arguments) == hash_with({}));
    }
    CHECK(hash_with({"--aov", "depth,id", "--accel", "cloud"}) == hash_with({"--aov", "id,depth,id"}));
    CHECK(backend_of("cpu") == "cpu");
    CHECK(backend_of("cpu#2") == "cpu");
    CHECK(backend_of("cuda:1#2") == "cuda");
    CHECK(backend_of("cuda:0,cuda:1") == "cuda");
    CHECK(backend_of("cpu,cuda:0") == "cpu+cuda");
}

TEST_CASE("frame hash: the precision counts in which a frame is rendered, not the one that was asked for") {
    for (const bool float_holds : {true, false}) {
        const std::string automatic = hash_with({"--precision", "auto"}, float_holds);
        CHECK(automatic == hash_with({}, float_holds));
        CHECK(automatic == hash_with({"--precision", float_holds ? "float" : "double"}, float_holds));
        CHECK(automatic != hash_with({"--precision", float_holds ? "double" : "float"}, float_holds));
    }
}

TEST_CASE("frame hash: every part of a scene counts, and what stands between its parts does not") {
    const std::vector<std::function<void(SceneProgram&)>> changes = {
        [](SceneProgram&) {},
        [](SceneProgram& s) { s.spheres[1].radius = 0.25; },
        [](SceneProgram& s) { s.spheres.pop_back(); },
        [](SceneProgram& s) { s.sphere_materials[1] = 1; },
        [](SceneProgram& s) { s.ellipsoids[0].material = 1; },
        [](SceneProgram& s) { s.planes[0].distance = 1; },
        [](SceneProgram& s) { s.materials[0].flags = 1; },
        [](SceneProgram& s) { s.layers[0].finish = 1; },
        [](SceneProgram& s) { s.pigments[0].second_color.transmit = 1; },
        [](SceneProgram& s) { s.finishes[0].conserve_energy = 1; },
        [](SceneProgram& s) { s.interiors[0].ior = 1.5f; },
        [](SceneProgram& s) { s.lights[0].tightness = 1; },
        [](SceneProgram& s) { s.camera.up.x = 1; },
        [](SceneProgram& s) { s.sky.pigments = {0}; },
        [](SceneProgram& s) { s.fogs = {Fog<double>{}}; },
        [](SceneProgram& s) { s.background.z = 1; },
        [](SceneProgram& s) { s.max_trace_level = 6; },
        [](SceneProgram& s) { s.legacy_transparency = true; },
    };
    std::vector<Hash128> hashes;
    for (size_t i = 0; i < changes.size(); ++i) {
        CAPTURE(i);
        SceneProgram scene = a_scene();
        changes[i](scene);
        const Hash128 hash = hash_scene(scene);
        CHECK(std::ranges::find(hashes, hash) == hashes.end());
        hashes.push_back(hash);
    }
    // The bytes after a plane's material belong to nobody.
    alignas(Plane<double>) unsigned char dirty[sizeof(Plane<double>)];
    std::fill(std::begin(dirty), std::end(dirty), 0xff);
    SceneProgram scene = a_scene();
    scene.planes[0] = *new (dirty) Plane<double>{};
    CHECK(hash_scene(scene) == hash_scene(a_scene()));
    CHECK(hash_text("Proxima").text().size() == 32);
}
