// SPDX-License-Identifier: Apache-2.0
#include "parser/shape_transform.h"

#include <cmath>

namespace proxima {
namespace {

bool within(double a, double slack) {
    return std::abs(a) <= slack;
}
Varying within(const Varying& a, const Varying& slack) {
    return apply(MotionOp::logical_not, apply(MotionOp::greater, apply(MotionOp::abs, a), slack));
}
bool both(bool a, bool b) {
    return a && b;
}
Varying both(const Varying& a, const Varying& b) {
    return apply(MotionOp::logical_and, a, b);
}

/// Whether a map keeps spheres spheres.
template <class Number> auto similarity(const Mat3<Number>& m) {
    const Number xx = glm::dot(m[0], m[0]), yy = glm::dot(m[1], m[1]), zz = glm::dot(m[2], m[2]);
    const Number slack = Number(1e-12) * xx;
    const auto equal = both(within(xx - yy, slack), within(xx - zz, slack));
    const auto square = both(within(glm::dot(m[0], m[1]), slack),
                             both(within(glm::dot(m[0], m[2]), slack), within(glm::dot(m[1], m[2]), slack)));
    return both(equal, square);
}

/// Puts a transform behind the chains of a shape's parts.
class ChainLink {
public:
    ChainLink(Shape& shape, const Transform& transform, bool keeps_spheres)
        : shape_(shape), transform_(transform), keeps_spheres_(keeps_spheres) {
        for (MotionChainRef& chain : shape.chains)
            chain = std::make_shared<const MotionChain>(MotionChain{chain, transform, keeps_spheres});
    }

    /// Whether the part, whose own numbers have these nodes, takes the transform into its chain.
    template <class Part> bool takes(Part& part, const PartNodes& nodes) {
        if (part.chain != part.still)
            return true;
        if (!transform_.moving && (nodes.vector | nodes.number) == 0)
            return false;
        if (fresh_ == part.still) {
            fresh_ = uint32_t(shape_.chains.size());
            shape_.chains.push_back(
                std::make_shared<const MotionChain>(MotionChain{nullptr, transform_, keeps_spheres_}));
        }
        part.chain = fresh_;
        return true;
    }

private:
    Shape& shape_;
    const Transform& transform_;
    bool keeps_spheres_;
    uint32_t fresh_ = Dressed<int>::still;
};

void move_light(LightSource& source, const Affine<Varying>& map) {
    Moving<Light<double>>& light = source.light;
    light.set(light.record.position, map.point(light.get(light->position)));
    light.set(light.record.point_at, map.point(light.get(light->point_at)));
    if (!source.area)
        return;
    Moving<AreaLight<double>>& area = *source.area;
    area.set(area.record.axis1, map.direction(area.get(area->axis1)));
    area.set(area.record.axis2, map.direction(area.get(area->axis2)));
}

/// Makes ellipsoids of the spheres that stand still.
void squeeze_spheres(Shape& shape, const Affine<double>& map) {
    PartNodesReader nodes(shape.moving_spheres);
    std::vector<Dressed<Sphere<double>>> kept;
    std::vector<PartNodes> kept_nodes;
    for (size_t i = 0; i < shape.spheres.size(); ++i) {
        const auto& part = shape.spheres[i];
        PartNodes own = nodes.of(i);
        if (part.chain == part.still) {
            shape.ellipsoids.push_back({compose(map, unit_sphere_map(part.geometry)), part.surface});
            continue;
        }
        if ((own.vector | own.number) != 0) {
            own.part = uint32_t(kept.size());
            kept_nodes.push_back(own);
        }
        kept.push_back(part);
    }
    shape.spheres = std::move(kept);
    shape.moving_spheres = std::move(kept_nodes);
}

} // namespace

void transform_shape(Shape& shape, const Transform& transform, SceneBuilder& builder) {
    if (transform.is_identity)
        return;
    std::vector<std::pair<uint32_t, uint32_t>> moved_textures; // one that moves is never equal to another
    const auto move_surface = [&](Surface& surface) {
        if (surface.texture == Surface::none)
            return;
        for (const auto& [from, to] : moved_textures)
            if (from == surface.texture) {
                surface.texture = to;
                return;
            }
        const uint32_t to = builder.transform_texture(surface.texture, transform);
        if (to != surface.texture)
            moved_textures.emplace_back(surface.texture, to);
        surface.texture = to;
    };
    const bool keeps_spheres = transform.moving
                                   ? transform.keeps_spheres || decide(similarity(transform.moving->map.linear))
                                   : similarity(transform.still.map.linear);
    ChainLink link(shape, transform, keeps_spheres);
    const Affine<double>& map = transform.still.map;
    for (auto& part : shape.ellipsoids) {
        move_surface(part.surface);
        if (!link.takes(part, {}))
            part.geometry = compose(map, part.geometry);
    }
    PartNodesReader plane_nodes(shape.moving_planes), sphere_nodes(shape.moving_spheres);
    for (size_t i = 0; i < shape.planes.size(); ++i) {
        auto& part = shape.planes[i];
        move_surface(part.surface);
        if (!link.takes(part, plane_nodes.of(i)))
            part.geometry = moved(part.geometry, transform.still.inverse);
    }
    move_surface(shape.own);
    for (LightSource& source : shape.lights)
        move_light(source, transform.with_nodes().map);
    const double factor = glm::length(map.linear[0]);
    bool squeezed = false;
    for (size_t i = 0; i < shape.spheres.size(); ++i) {
        auto& part = shape.spheres[i];
        move_surface(part.surface);
        if (link.takes(part, sphere_nodes.of(i)))
            continue;
        if (keeps_spheres)
            part.geometry = {map.point(part.geometry.center), part.geometry.radius * factor};
        else
            squeezed = true;
    }
    if (squeezed)
        squeeze_spheres(shape, map);
}

} // namespace proxima
