// SPDX-License-Identifier: Apache-2.0
// How transforms move the parts of objects: at once where everything is still; else they are kept with the part, in the
// order of the script, until it goes into the scene.
#pragma once
#include "parser/scene_builder.h"

#include <utility>

namespace proxima {

template <class Number> Affine<Number> unit_sphere_map(const Sphere<Number>& sphere) {
    return {Mat3<Number>(sphere.radius), sphere.center};
}

/// Where a plane goes. dot(n, q) = d with q = inverse(p): the normal goes back through the transposed inverse.
template <class Number> Plane<Number> moved(const Plane<Number>& plane, const Affine<Number>& inverse) {
    using std::sqrt;
    const Vec3<Number> normal = inverse.normal_to_source(plane.normal);
    const Number length = glm::length(normal);
    return {normal / length, (plane.distance - glm::dot(plane.normal, inverse.offset)) / length, plane.material};
}

/// Walks along the nodes of parts in step with the parts.
class PartNodesReader {
public:
    explicit PartNodesReader(const std::vector<PartNodes>& nodes) : next_(nodes.begin()), end_(nodes.end()) {}
    /// Of one part after the other.
    PartNodes of(size_t part) { return next_ != end_ && next_->part == part ? *next_++ : PartNodes{}; }

private:
    std::vector<PartNodes>::const_iterator next_, end_;
};

/// Maps a shape, with its textures.
void transform_shape(Shape& shape, const Transform& transform, SceneBuilder& builder);

} // namespace proxima
