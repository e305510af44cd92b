// SPDX-License-Identifier: Apache-2.0
#include "parser/transform.h"

#include <utility>

namespace proxima {

Transform::Transform(const TransformOf<Varying>& pair)
    : still{value_of(pair.map), value_of(pair.inverse)}, is_identity(false) {
    if (moves(pair.map) || moves(pair.inverse))
        moving = std::make_shared<const TransformOf<Varying>>(pair);
}

TransformOf<Varying> Transform::with_nodes() const {
    return moving ? *moving : TransformOf<Varying>{varying(still.map), varying(still.inverse)};
}

Transform then(const Transform& first, const Transform& second) {
    if (first.is_identity || second.is_identity)
        return first.is_identity ? second : first;
    Transform result = first.moving || second.moving ? Transform(then(first.with_nodes(), second.with_nodes()))
                                                     : Transform(then(first.still, second.still));
    result.keeps_spheres = first.keeps_spheres && second.keeps_spheres;
    return result;
}

Transform inverse_of(const Transform& transform) {
    Transform result = transform;
    std::swap(result.still.map, result.still.inverse);
    if (transform.moving)
        result.moving = std::make_shared<const TransformOf<Varying>>(
            TransformOf<Varying>{transform.moving->inverse, transform.moving->map});
    return result;
}

} // namespace proxima
