// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/figures.h"

#include <algorithm>
#include <cmath>

namespace proxima::testing {
namespace {

bool is_finite(const Vec3<double>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The way across the ray from pixel to pixel, at the distance of its hit; the smaller one of the two.
double pixel_width(const Camera<double>& camera, const Probes& probes, size_t index, const Vec3<double>& from_eye) {
    const Vec3<double> right = camera.right / double(probes.width), down = -camera.up / double(probes.height);
    if (camera.kind == CameraKind::orthographic)
        return std::min(glm::length(right), glm::length(down));
    const double x = double(index % probes.width) + 0.5, y = double(index / probes.width) + 0.5;
    const Vec3<double> ahead = camera.direction + (x - 0.5 * probes.width) * right + (y - 0.5 * probes.height) * down;
    const Vec3<double> ray = glm::normalize(ahead);
    const auto angle = [&](const Vec3<double>& step) { return glm::length(step - glm::dot(step, ray) * ray); };
    return std::min(angle(right), angle(down)) / glm::length(ahead) * glm::length(from_eye);
}

int level(float v) {
    const double c = std::clamp(double(v), 0.0, 1.0);
    return int(std::lround(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055)));
}

/// Seen outline_tolerance aside, in one of eight directions.
SceneProgram seen_aside(const SceneProgram& scene, const FrameSettings& settings, int direction) {
    const double turn = direction * 0.7853981633974483;
    return seen_beside(scene, settings, outline_tolerance * std::cos(turn), outline_tolerance * std::sin(turn));
}

} // namespace

Reference reference_hits(const SceneProgram& scene, FrameSettings settings) {
    settings.precision = Precision::float64;
    Reference reference{probe(scene, settings), {}};
    for (int i = 0; i < 8; ++i)
        reference.beside[i] = probe(seen_aside(scene, settings, i), settings);
    return reference;
}

HitFigures compare_hits(const Reference& reference, const Probes& hits, const SceneProgram& scene) {
    HitFigures figures;
    double sum = 0;
    uint64_t on_spheres = 0;
    for (size_t i = 0; i < hits.hits.size(); ++i) {
        const ProbedHit &is = hits.hits[i], &should = reference.hits.hits[i];
        ++figures.rays;
        figures.not_finite += !is_finite(is.from_eye) || !is_finite(is.normal);
        if (is.id != should.id) {
            ++figures.other;
            figures.wrong += std::ranges::none_of(reference.beside,
                                                  [&](const Probes& beside) { return beside.hits[i].id == is.id; });
            continue;
        }
        if (is.id == 0)
            continue;
        const Vec3<double> moved = is.from_eye - should.from_eye;
        if (is.id <= scene.spheres.size()) {
            const double radii = glm::length(moved) / scene.spheres[is.id - 1].radius;
            sum += radii * radii;
            ++on_spheres;
        }
        const Camera<double>& camera = scene.camera;
        const Vec3<double> ray = camera.kind == CameraKind::orthographic ? glm::normalize(camera.direction)
                                                                         : glm::normalize(should.from_eye);
        const double across = glm::length(moved - glm::dot(moved, ray) * ray);
        const double out = std::abs(glm::dot(moved, should.normal));
        const double width = pixel_width(camera, hits, i, should.from_eye);
        if (width > 0)
            figures.most_pixels = std::max(figures.most_pixels, std::max(across, out) / width);
    }
    figures.rms_over_radius = on_spheres ? std::sqrt(sum / double(on_spheres)) : 0;
    return figures;
}

LevelFigures compare_levels(const Image& a, const Image& b) {
    LevelFigures figures;
    uint64_t within = 0, equal = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i) {
        figures.not_finite += !std::isfinite(a.rgb[i]) + !std::isfinite(b.rgb[i]);
        const int apart = std::abs(level(a.rgb[i]) - level(b.rgb[i]));
        within += apart <= 1;
        equal += apart == 0;
    }
    if (!a.rgb.empty()) {
        figures.within_one = double(within) / double(a.rgb.size());
        figures.equal = double(equal) / double(a.rgb.size());
    }
    return figures;
}

Image render_scene(const SceneProgram& scene, const FrameSettings& settings) {
    const auto renderer = make_cpu_renderer(0);
    renderer->set_scene(scene, settings.precision);
    Image image;
    renderer->render(settings, image);
    return image;
}

std::vector<Image> pictures_beside(const SceneProgram& scene, FrameSettings settings) {
    settings.precision = Precision::float64;
    std::vector<Image> pictures{render_scene(scene, settings)};
    for (int i = 0; i < 8; ++i)
        pictures.push_back(render_scene(seen_aside(scene, settings, i), settings));
    return pictures;
}

double share_seen_beside(const std::vector<Image>& pictures, const Image& image) {
    uint64_t seen = 0;
    const size_t pixels = image.rgb.size() / 3;
    for (size_t i = 0; i < pixels; ++i)
        seen += std::ranges::any_of(pictures, [&](const Image& picture) {
            const float *a = picture.rgb.data() + 3 * i, *b = image.rgb.data() + 3 * i;
            return std::equal(a, a + 3, b, [](float x, float y) { return std::abs(level(x) - level(y)) <= 1; });
        });
    return pixels ? double(seen) / double(pixels) : 1;
}

} // namespace proxima::testing
