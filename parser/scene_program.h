// SPDX-License-Identifier: Apache-2.0
// The product of the parser and the input of the renderer: one frame's scene as plain arrays, in double, in the order
// of the scene file. Nothing here knows about text, devices or images.
#pragma once
#include "kernels/camera.h"
#include "kernels/fog.h"
#include "kernels/geometry.h"
#include "kernels/light.h"
#include "kernels/material.h"
#include "parser/motion_programs.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace proxima {

/// How the numbers of the working space become linear light. POV-Ray applies it to the finished pixel.
enum class WorkingCurve : uint32_t {
    linear,  ///< assumed_gamma 1: the numbers are linear light
    power,   ///< assumed_gamma g: linear = v^g
    srgb,    ///< assumed_gamma srgb: the numbers are sRGB-encoded
    display, ///< neither #version 3.7 nor assumed_gamma: the numbers go to the file as they are; taken as sRGB-encoded
};

/// What surrounds the scene, in front of the background: pigments, the last one in front, seen at unit directions.
struct SkySphere {
    std::vector<uint32_t> pigments;
    glm::vec3 emission{1.0f};
};

/// All of a scene but its spheres: what is small enough to be sent to a device anew for every frame.
struct SceneTables {
    // More geometry: ids count spheres, then ellipsoids, then planes.
    std::vector<Ellipsoid<double>> ellipsoids;
    std::vector<Plane<double>> planes;

    // Surfaces. Equal records are stored once.
    std::vector<Material> materials;
    std::vector<Layer> layers;
    std::vector<Pigment> pigments;
    std::vector<Pattern> patterns;
    std::vector<ColorStop> color_stops; ///< colour maps, one behind the other
    std::vector<Finish> finishes;
    std::vector<Interior> interiors;
    std::vector<Affine<double>> transforms; ///< world -> pattern space, for Pigment::transform

    std::vector<Light<double>> lights;
    std::vector<AreaLight<double>> area_lights;
    std::vector<AreaSample> area_samples;
    Camera<double> camera;

    SkySphere sky;
    std::vector<Fog<double>> fogs;
    glm::vec3 background{0.0f}; ///< already scaled by 1 - transmit where POV-Ray does
    glm::vec3 ambient_light{1.0f};
    uint32_t max_trace_level = 5; ///< 1 ... 256
    float adc_bailout = 1.0f / 255.0f;
    WorkingCurve working_curve = WorkingCurve::linear;
    float working_gamma = 1.0f;       ///< the exponent of WorkingCurve::power
    bool legacy_transparency = false; ///< version < 3.7: opacity is 1 - (filter * max(r, g, b) + transmit)
};

struct SceneProgram : SceneTables {
    // Two arrays of one length.
    std::vector<Sphere<double>> spheres;
    std::vector<uint32_t> sphere_materials;

    /// How the numbers above, which are those of one frame, follow from the time of others.
    MotionPrograms motion;

    /// The script read clock, frame_number or clock_delta: another frame may be another scene.
    bool depends_on_time = false;

    /// What kept a script that depends on the time from becoming motion programs.
    std::optional<MotionObstacle> obstacle;
};

} // namespace proxima
