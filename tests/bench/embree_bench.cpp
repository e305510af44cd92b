// SPDX-License-Identifier: Apache-2.0
// Proxima on the CPU beside Embree 3: the same spheres, rays and light; both build anew for every frame and trace
// primary and shadow rays, in turn, frame by frame. Usage: embree_bench [SPHERES [FRAMES [WxH]]]
#include "kernels/film.h"
#include "renderer/frame_renderer.h"
#include "renderer/option_values.h"
#include "renderer/scene_source.h"
#include "renderer/timing.h"
#include "tests/bench/scene_files.h"

#include <algorithm>
#include <cmath>
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <functional>
#include <tbb/parallel_for.h>

using namespace proxima;

namespace {

/// Embree's sphere points in a dynamic scene, traced in packets of 4x4 pixels.
class EmbreeSpheres {
public:
    EmbreeSpheres(const SceneProgram& program, RTCBuildQuality quality)
        : program_(program), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)),
          geometry_(rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
        rtcSetSceneBuildQuality(scene_, quality);
        rtcSetGeometryBuildQuality(geometry_, quality);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), program.spheres.size()));
        for (const Sphere<double>& sphere : program.spheres) {
            for (int i = 0; i < 3; ++i)
                *vertices++ = float(sphere.center[i]);
            *vertices++ = float(sphere.radius);
        }
        rtcCommitGeometry(geometry_);
        rtcAttachGeometry(scene_, geometry_);
        rtcCommitScene(scene_);
    }
    ~EmbreeSpheres() {
        rtcReleaseGeometry(geometry_);
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeSpheres(const EmbreeSpheres&) = delete;
    EmbreeSpheres& operator=(const EmbreeSpheres&) = delete;

    bool has_packets_of_16() const {
        return rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
    }

    /// As if every sphere had moved.
    void build() {
        rtcUpdateGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0);
        rtcCommitGeometry(geometry_);
        rtcCommitScene(scene_);
    }

    void trace(Image& image) const {
        const FilmView film{{}, image.width, image.height, 1};
        const uint32_t across = image.width / 4, down = image.height / 4;
        tbb::parallel_for(0u, across * down,
                          [&](uint32_t tile) { trace_packet(film, 4 * (tile % across), 4 * (tile / across), image); });
    }

private:
    static constexpr int size = 16;

    void trace_packet(const FilmView& film, uint32_t x, uint32_t y, Image& image) const {
        const Camera<float> camera = camera_in<float>(program_.camera);
        alignas(64) int valid[size];
        RTCRayHit16 packet;
        for (int i = 0; i < size; ++i) {
            const Ray<float> ray = pixel_ray(camera, film, {x + uint32_t(i % 4), y + uint32_t(i / 4)}, 0);
            valid[i] = -1;
            set(packet.ray, i, ray.origin, ray.direction, std::numeric_limits<float>::infinity());
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        rtcIntersect16(valid, scene_, &context, &packet);

        const Light<double>& light = program_.lights.front();
        RTCRay16 shadow;
        float cosine[size];
        for (int i = 0; i < size; ++i) {
            cosine[i] = 0;
            valid[i] = 0;
            if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID)
                continue;
            const Sphere<double>& sphere = program_.spheres[packet.hit.primID[i]];
            const glm::vec3 point =
                glm::vec3(packet.ray.org_x[i], packet.ray.org_y[i], packet.ray.org_z[i]) +
                packet.ray.tfar[i] * glm::vec3(packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]);
            const glm::vec3 normal = glm::normalize(point - glm::vec3(sphere.center));
            const glm::vec3 way = glm::vec3(light.position) - point;
            const float distance = glm::length(way);
            cosine[i] = glm::dot(normal, way) / distance;
            valid[i] = cosine[i] > 0 ? -1 : 0;
            set(shadow, i, point + normal * (1e-3f * float(sphere.radius)), way / distance, distance);
        }
        rtcOccluded16(valid, scene_, &context, &shadow);
        for (int i = 0; i < size; ++i) {
            const bool hit = packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
            const bool lit = valid[i] && shadow.tfar[i] >= 0;
            const glm::vec3 color(0.9f, 0.6f, 0.3f); // of write_scene
            const glm::vec3 seen = hit ? color * (0.1f + (lit ? 0.7f * cosine[i] : 0.0f)) : program_.background;
            float* pixel = image.row(y + uint32_t(i / 4)) + 3 * (x + uint32_t(i % 4));
            for (int k = 0; k < 3; ++k)
                pixel[k] = seen[k];
        }
    }
    static void set(RTCRay16& rays, int i, const glm::vec3& origin, const glm::vec3& direction, float farthest) {
        rays.org_x[i] = origin.x, rays.org_y[i] = origin.y, rays.org_z[i] = origin.z;
        rays.dir_x[i] = direction.x, rays.dir_y[i] = direction.y, rays.dir_z[i] = direction.z;
        rays.tnear[i] = 0, rays.tfar[i] = farthest, rays.time[i] = 0;
        rays.mask[i] = 0xffffffffu, rays.flags[i] = 0;
    }

    const SceneProgram& program_;
    RTCDevice device_;
    RTCScene scene_;
    RTCGeometry geometry_;
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

struct Contender {
    std::string name;
    std::function<void(double& build, double& trace, Image&)> frame;
    std::vector<double> build{}, trace{}, both{};
    Image image{};
};

/// The share of pixels that are farther apart than a level of eight bits.
double different(const Image& a, const Image& b) {
    size_t count = 0;
    for (size_t i = 0; i < a.rgb.size(); i += 3)
        count += std::abs(a.rgb[i] - b.rgb[i]) > 1.0f / 255;
    return 100.0 * double(count) / double(a.rgb.size() / 3);
}

} // namespace

int main(int argc, char** argv) {
    const uint64_t spheres = argc > 1 ? std::stoull(argv[1]) : 1'000'000;
    const int frames = argc > 2 ? std::stoi(argv[2]) : 11;
    SceneOptions options;
    std::tie(options.width, options.height) = parse_size(argc > 3 ? argv[3] : "1280x720");
    options.scene = std::filesystem::temp_directory_path() / "embree_bench.scn";
    bench::write_scene(options.scene, spheres);
    SceneSource source(options);
    const auto program = source.scenes(0).programs.front();

    const auto renderer = make_cpu_renderer(0);
    renderer->set_scene(*program, Precision::float32);
    FrameSettings settings;
    settings.width = options.width;
    settings.height = options.height;
    std::vector<Contender> contenders{{"Proxima", [&](double& build, double& trace, Image& image) {
                                           const FrameStatistics s = renderer->render(settings, image);
                                           build = s.build_ms + s.cloud_ms;
                                           trace = s.trace_ms;
                                       }}};
    EmbreeSpheres medium(*program, RTC_BUILD_QUALITY_MEDIUM), low(*program, RTC_BUILD_QUALITY_LOW);
    const auto add_embree = [&](const char* name, EmbreeSpheres& embree) {
        contenders.push_back({name, [&](double& build, double& trace, Image& image) {
                                  image.fit(settings.width, settings.height);
                                  timed(build, [&] { embree.build(); });
                                  timed(trace, [&] { embree.trace(image); });
                              }});
    };
    add_embree("Embree, dynamic", medium);
    add_embree("Embree, dynamic, low quality", low);

    for (int frame = 0; frame <= frames; ++frame)
        for (Contender& contender : contenders) {
            double build = 0, trace = 0;
            contender.frame(build, trace, contender.image);
            if (frame == 0) // makes room
                continue;
            contender.build.push_back(build);
            contender.trace.push_back(trace);
            contender.both.push_back(build + trace);
        }
    fmt::print(
        "{} uniform spheres, {}x{}, primary and shadow rays, packets of 16{}; ms, medians of {} frames in turn\n",
        spheres, settings.width, settings.height, medium.has_packets_of_16() ? "" : " (not native here)", frames);
    fmt::print("{:<30}{:>10}{:>10}{:>10}{:>22}\n", "", "build", "trace", "both", "pixels that differ");
    for (const Contender& contender : contenders)
        fmt::print("{:<30}{:>10.1f}{:>10.1f}{:>10.1f}{:>20.3f} %\n", contender.name, median(contender.build),
                   median(contender.trace), median(contender.both), different(contenders[0].image, contender.image));
    std::filesystem::remove(options.scene);
}
