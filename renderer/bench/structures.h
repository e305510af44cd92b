// SPDX-License-Identifier: Apache-2.0
// What other structures would look up on the same rays: a study by counting, on the host, for `proxima bench sparse`. A
// grid, a grid of grids (Kalojanov, Billeter and Slusallek, "Two-Level Grids for Ray Tracing on GPUs", 2011), and an
// octree (Glassner, "Space Subdivision for Fast Ray Tracing", 1984).
#pragma once
#include "parser/scene_program.h"

#include <span>
#include <string>
#include <vector>

namespace proxima {

struct StructureFigures {
    std::string name;
    double lookups = 0;  ///< voxels and nodes a ray, of the rays that meet the scene's bounds
    double tests = 0;    ///< spheres a ray
    double bytes = 0;    ///< of its lists and its voxels or nodes
    double checksum = 0; ///< the sum of the distances that it found: all structures find the same
};

/// `columns` by `rows` camera rays, each to its nearest hit.
std::vector<StructureFigures> count_structures(const SceneProgram& scene, uint32_t columns, uint32_t rows);

} // namespace proxima
