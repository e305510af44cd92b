// SPDX-License-Identifier: Apache-2.0
// The weights of an area light's places when all of them are asked: POV-Ray divides the grid into quarters down to
// single cells and averages their corners, so that places on the seams count more than once.
#pragma once
#include "kernels/light.h"

#include <vector>

namespace proxima {

/// Appends the places of a grid of `columns` by `rows` (each at least 1); their weights sum up to 1.
void append_area_samples(std::vector<AreaSample>& samples, uint32_t columns, uint32_t rows);

} // namespace proxima
