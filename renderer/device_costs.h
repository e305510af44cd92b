// SPDX-License-Identifier: Apache-2.0
// The costs of each kind of device, by which grid or cloud is chosen before either was timed. Where they come from is
// in tests/bench/NOTES.md; `choice_bench fit` makes them anew.
#pragma once
#include "renderer/method_costs.h"

namespace proxima {

/// Two cores together.
inline constexpr DeviceCosts cpu_costs{
    .of = {.grid = {.primitive = 36, .reference = 13, .voxel = 2, .ray = 120, .lookup = 25, .shared = 60},
           .cloud = {.primitive = 55, .reference = 20, .voxel = 5, .brick = 28, .ray = 120, .lookup = 50}},
    .fewest = 5'000};

inline constexpr DeviceCosts cuda_costs{
    .of = {.grid = {.build_ms = 0.05, .primitive = 0.15, .reference = 0.015, .ray = 0.2, .lookup = 0.012},
           .cloud = {.build_ms = 0.06,
                     .primitive = 0.13,
                     .reference = 0.035,
                     .voxel = 0.017,
                     .map_ms = 0.03,
                     .brick = 0.08,
                     .ray = 0.15,
                     .lookup = 0.029}},
    .fewest = 10'000};

} // namespace proxima
