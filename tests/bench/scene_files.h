// SPDX-License-Identifier: Apache-2.0
// The benchmark's scene, N spheres with centres uniform in the unit cube and radius 0.3 N^(-1/3), written in the scene
// language and in NFF: the same spheres, camera and light.
#pragma once
#include <cstdint>
#include <filesystem>

namespace proxima::bench {

/// One `sphere { <x,y,z>, r texture { T } }` a line, every number a literal.
void write_scene(const std::filesystem::path& path, uint64_t spheres);

/// Neutral File Format (Eric Haines, Standard Procedural Databases, 1987), which Tachyon reads.
void write_nff(const std::filesystem::path& path, uint64_t spheres, unsigned width, unsigned height);

} // namespace proxima::bench
