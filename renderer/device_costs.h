// SPDX-License-Identifier: Apache-2.0
// What units of a frame's work take on the devices that were measured. Others differ, but less in what decides: how
// much more one unit takes than another.
#pragma once
#include "renderer/frame_cost.h"

namespace proxima {

/// One core.
inline constexpr CostCoefficients cpu_costs{
    .grid = {.primitive = 60, .cell = 1, .link = 10, .pixel = 450, .lookup = 9, .test = 7},
    .cloud = {.primitive = 80,
              .cell = 2,
              .link = 20,
              .mark = 10,
              .brick = 20,
              .distance = 20,
              .pixel = 450,
              .lookup = 15,
              .test = 7}};

/// An H100.
inline constexpr CostCoefficients cuda_costs{.grid = {.build_fixed = 90e3,
                                                      .primitive = 0.05,
                                                      .cell = 0.01,
                                                      .link = 0.02,
                                                      .trace_fixed = 50e3,
                                                      .pixel = 0.1,
                                                      .lookup = 0.006,
                                                      .test = 0.006,
                                                      .goes_together = true},
                                             .cloud = {.build_fixed = 100e3,
                                                       .primitive = 0.1,
                                                       .cell = 0.01,
                                                       .link = 0.02,
                                                       .mark = 0.01,
                                                       .map_fixed = 40e3,
                                                       .brick = 0.03,
                                                       .distance = 0.01,
                                                       .trace_fixed = 50e3,
                                                       .pixel = 0.1,
                                                       .lookup = 0.012,
                                                       .test = 0.006,
                                                       .goes_together = true}};

} // namespace proxima
