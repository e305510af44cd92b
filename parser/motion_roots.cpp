// SPDX-License-Identifier: Apache-2.0
#include "parser/motion_roots.h"

#include "parser/array.h"
#include "parser/user_function.h"

#include <unordered_set>

namespace proxima {
namespace {

class Marker {
public:
    explicit Marker(MotionGraph& graph) : graph_(graph) {}

    void mark(const Value& value) { std::visit(*this, value); }

    void operator()(const Terms& terms) {
        if (terms.nodes)
            graph_.mark(terms.nodes);
    }
    void operator()(const ShapeRef& shape) {
        if (!is_new(shape.get()))
            return;
        for (const auto* parts : {&shape->moving_spheres, &shape->moving_planes})
            for (const PartNodes& part : *parts) {
                graph_.mark(part.vector);
                graph_.mark(part.number);
            }
        for (const MotionChainRef& chain : shape->chains)
            for (const MotionChain* link = chain.get(); link && is_new(link); link = link->before.get())
                mark(link->transform);
        for (const LightSource& light : shape->lights) {
            light.light.nodes.mark(graph_);
            if (light.area)
                light.area->nodes.mark(graph_);
        }
    }
    void operator()(const SkyRef& sky) { sky->nodes.mark(graph_); }
    void operator()(const FogRef& fog) { fog->nodes.mark(graph_); }
    void operator()(const CameraRef& camera) {
        for (const Vec3<Varying>* vector : {&camera->location, &camera->direction, &camera->right, &camera->up})
            mark(*vector);
    }
    void operator()(const TransformRef& transform) { mark(*transform); }
    void operator()(const ArrayRef& array) {
        if (array->may_move && is_new(array.get()))
            for (const Value& element : array->elements)
                mark(element);
    }
    void operator()(const FunctionRef& function) {
        if (is_new(function.get()))
            for (const UserFunction::Capture& capture : function->captures)
                mark(capture.value);
    }
    /// Surfaces are in the builder's tables.
    template <class Other> void operator()(const Other&) {}

private:
    bool is_new(const void* thing) { return seen_.insert(thing).second; }
    void mark(const Vec3<Varying>& v) {
        for (int i = 0; i < 3; ++i)
            graph_.mark(v[i].node);
    }
    void mark(const Transform& transform) {
        if (!transform.moving)
            return;
        for (const Affine<Varying>* map : {&transform.moving->map, &transform.moving->inverse})
            for (int i = 0; i < 4; ++i)
                mark(i < 3 ? map->linear[i] : map->offset);
    }

    MotionGraph& graph_;
    std::unordered_set<const void*> seen_;
};

} // namespace

void mark_names(const Scopes& scopes, MotionGraph& graph) {
    Marker marker(graph);
    for (const std::vector<Binding>& bindings : scopes.bindings())
        for (const Binding& binding : bindings)
            marker.mark(binding.value);
}

} // namespace proxima
