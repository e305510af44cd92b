// SPDX-License-Identifier: Apache-2.0
// A compared pair in, pictures for people out: display colours from 0 to 1.
#pragma once
#include "renderer/image.h"
#include "renderer/image_pair.h"

namespace proxima {

/// One side as a display shows it, without alpha: levels as they are, linear light by the sRGB curve.
Image displayed(const ImagePair& pair, const std::vector<float>& samples);

/// How far apart the pixels are, by their worst sample: black where equal, greys within the tolerance, then on a
/// logarithmic scale up to 1 from violet to pale yellow. Cyan where a sample is not finite.
Image difference_map(const ImagePair& pair, double tolerance);

/// Pictures of one size in a row, a few grey columns between them.
Image side_by_side(const std::vector<Image>& pictures);

} // namespace proxima
