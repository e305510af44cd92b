// SPDX-License-Identifier: Apache-2.0
// With exact tolerances nothing in a picture depends on how large a scene is, where it lies and how it is turned, but
// by rounding.
#include "tests/extremes/cases.h"
#include "tests/extremes/figures.h"
#include "tests/extremes/rounding.h"
#include "tests/extremes/scene_maps.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace proxima;
using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

FrameSettings settings_for(Precision precision, uint32_t width = 48, uint32_t height = 36) {
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.precision = precision;
    return settings;
}

std::vector<fs::path> scenes() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(PROXIMA_EXAMPLES))
        if (entry.path().extension() == ".scn")
            files.push_back(entry.path());
    for (const char* name : {"spheres.scn", "coincident.scn", "eye.scn", "ground.scn", "nested.scn", "flat.scn"})
        files.push_back(fs::path(PROXIMA_EXTREMES) / name);
    std::ranges::sort(files);
    return files;
}

/// How far places that stayed on their primitive are from the same places of another scene, across the ray or out of
/// the surface: the most of it, as a share of what is allowed. `map` leads from one scene to the other.
template <class Map, class Allowed>
double displacement(const Probes& a, const Probes& b, const Map& map, const Allowed& allowed) {
    double most = 0;
    for (size_t i = 0; i < a.hits.size(); ++i) {
        if (a.hits[i].id != b.hits[i].id || a.hits[i].id == 0)
            continue;
        const Vec3<double> moved = b.hits[i].from_eye - map(a.hits[i].from_eye);
        const Vec3<double> ray = glm::normalize(b.hits[i].from_eye);
        const double across = glm::length(moved - glm::dot(moved, ray) * ray);
        const double out = std::abs(glm::dot(moved, b.hits[i].normal));
        most = std::max(most, std::max(across, out) / allowed(a.hits[i]));
    }
    return most;
}

} // namespace

TEST_CASE("invariance: a scene scaled by a power of two is the same picture, bit by bit") {
    for (const fs::path& file : scenes()) {
        CAPTURE(file);
        const SceneProgram scene = read_scene(file, 48, 36);
        for (const Precision precision : {Precision::float32, Precision::float64}) {
            const FrameSettings settings = settings_for(precision);
            const Image image = render_scene(scene, settings);
            for (const double factor : {0x1p-13, 0x1p20})
                CHECK(render_scene(scaled(scene, factor), settings).rgb == image.rgb);
        }
        const FrameSettings settings = settings_for(Precision::float64, 24, 18);
        for (const double factor : {0x1p-100, 0x1p100})
            CHECK(render_scene(scaled(scene, factor), settings).rgb == render_scene(scene, settings).rgb);
    }
}

TEST_CASE("invariance: a shifted scene moves in double by what its coordinates' rounding explains") {
    const auto shifted = [](const char* shift, const char* mirror) {
        return read_case({"", "spheres.scn", {{"Shift", shift}, {"Mirror", mirror}}, 48, 36});
    };
    for (const char* mirror : {"0", "1"}) {
        const FrameSettings settings = settings_for(Precision::float64);
        const SceneProgram here = shifted("0", mirror);
        const Reference reference = reference_hits(here, settings);
        const Image image = render_scene(here, settings);
        for (const auto& [text, shift] : {std::pair{"1024", 0x1p10}, {"1048576", 0x1p20}, {"1073741824", 0x1p30}}) {
            CAPTURE(shift);
            const SceneProgram there = shifted(text, mirror);
            const Probes hits = probe(there, settings);
            CHECK(compare_hits(reference, hits, here).wrong == 0);
            // A place is a sum and a product or two of rounded coordinates: 8 units in the last place are enough.
            const auto same = [](const Vec3<double>& v) { return v; };
            const auto allowed = [&](const ProbedHit&) { return 8 * 0x1p-53 * shift; };
            CHECK(displacement(reference.hits, hits, same, allowed) <= 1);
            CHECK(compare_levels(image, render_scene(there, settings)).equal >= 0.999);
        }
    }
}

TEST_CASE("invariance: a scene that is turned with its camera and lights is the same picture, but for rounding") {
    const double angle = 0.6435011087932844; // its sine and cosine are 0.6 and 0.8
    const double c = std::cos(angle), s = std::sin(angle);
    const Mat3<double> quarter(0.0, 0, 1, 1, 0, 0, 0, 1, 0); // the axes change places
    const Mat3<double> any = Mat3<double>(c, 0, -s, 0, 1, 0, s, 0, c) * Mat3<double>(1, 0, 0, 0, c, s, 0, -s, c);
    for (const fs::path& file : scenes()) {
        CAPTURE(file);
        const SceneProgram scene = read_scene(file, 48, 36);
        const FrameSettings settings = settings_for(Precision::float64);
        const Reference reference = reference_hits(scene, settings);
        const Image image = render_scene(scene, settings);
        for (const Mat3<double>& turn : {quarter, any}) {
            const SceneProgram other = turned(scene, turn);
            const Probes hits = probe(other, settings);
            uint64_t wrong = 0;
            for (size_t i = 0; i < hits.hits.size(); ++i)
                wrong += hits.hits[i].id != reference.hits.hits[i].id &&
                         std::ranges::none_of(reference.beside, [&](const Probes& beside) {
                             return beside.hits[i].id == hits.hits[i].id;
                         });
            CHECK(wrong == 0);
            const auto map = [&](const Vec3<double>& v) { return turn * v; };
            const auto allowed = [&](const ProbedHit& hit) { return turning_bound(scene, hit); };
            // The bound is a sum of the worst that each step can do; of that, 0.041 was the most that was ever seen.
            CHECK(displacement(reference.hits, hits, map, allowed) <= 0.1);
            CHECK(compare_levels(image, render_scene(other, settings)).within_one >= 0.999);
        }
    }
}
