// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/scene_files.h"

#include <cmath>
#include <fmt/os.h>
#include <random>

namespace proxima::bench {
namespace {

/// Calls `write(x, y, z)` for each centre: the same ones whoever asks.
template <class Write> void for_each_center(uint64_t spheres, Write&& write) {
    std::mt19937_64 random(2014);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (uint64_t i = 0; i < spheres; ++i) {
        const double x = uniform(random), y = uniform(random), z = uniform(random);
        write(x, y, z);
    }
}

double radius_for(uint64_t spheres) {
    return 0.3 / std::cbrt(double(spheres));
}

} // namespace

void write_scene(const std::filesystem::path& path, uint64_t spheres) {
    auto file = fmt::output_file(path.string());
    file.print("#version 3.7;\n"
               "global_settings {{ assumed_gamma 1.0 }}\n"
               "background {{ rgb <0.1, 0.2, 0.3> }}\n"
               "camera {{ location <0.5, 0.5, -2> look_at <0.5, 0.5, 0.5> right x*16/9 angle 50 }}\n"
               "light_source {{ <4, 6, -5>, rgb 1 }}\n"
               "#declare T = texture {{ pigment {{ rgb <0.9, 0.6, 0.3> }} finish {{ ambient 0.1 diffuse 0.7 }} }}\n");
    const double radius = radius_for(spheres);
    for_each_center(spheres, [&](double x, double y, double z) {
        file.print("sphere {{ <{:.6f},{:.6f},{:.6f}>, {:.6f} texture {{ T }} }}\n", x, y, z, radius);
    });
}

void write_nff(const std::filesystem::path& path, uint64_t spheres, unsigned width, unsigned height) {
    auto file = fmt::output_file(path.string());
    // NFF's angle is vertical here; the scene's 50 degrees are horizontal.
    const double degrees = 180 / std::acos(-1.0);
    const double vertical = 2 * std::atan(std::tan(25 / degrees) * double(height) / double(width)) * degrees;
    file.print("b 0.1 0.2 0.3\nv\nfrom 0.5 0.5 -2\nat 0.5 0.5 0.5\nup 0 1 0\nangle {:.4f}\nhither 0.001\n"
               "resolution {} {}\nl 4 6 -5\nf 0.9 0.6 0.3 0.7 0 0 0 1\n",
               vertical, width, height);
    const double radius = radius_for(spheres);
    for_each_center(
        spheres, [&](double x, double y, double z) { file.print("s {:.6f} {:.6f} {:.6f} {:.6f}\n", x, y, z, radius); });
}

} // namespace proxima::bench
