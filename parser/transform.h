// SPDX-License-Identifier: Apache-2.0
// A transform of the scene language: its map now, and the same with nodes when it follows from the time.
#pragma once
#include "parser/affine_math.h"
#include "parser/varying.h"

#include <memory>

namespace proxima {

struct Transform {
    TransformPair still; ///< the map now
    std::shared_ptr<const TransformOf<Varying>> moving;
    bool is_identity = true; ///< nothing was put into it
    /// Made of moves, turns and equal scaling alone: spheres stay spheres at all times.
    bool keeps_spheres = true;

    Transform() = default;
    Transform(const TransformPair& pair) : still(pair), is_identity(false) {}
    explicit Transform(const TransformOf<Varying>& pair);

    /// With nodes, where there are any.
    TransformOf<Varying> with_nodes() const;
};

Transform then(const Transform& first, const Transform& second);
Transform inverse_of(const Transform& transform);

} // namespace proxima
