// SPDX-License-Identifier: Apache-2.0
// What a declared name can stand for. Surfaces are indices into the tables of the scene being built: they cost nothing
// to copy, and equal ones are the same.
#pragma once
#include "kernels/camera.h"
#include "kernels/light.h"
#include "kernels/material.h"
#include "kernels/vector_math.h"
#include "parser/moving_record.h"
#include "parser/scene_program.h"
#include "parser/transform.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace proxima {

/// A number or a vector of 2 to 5 terms; five are a colour: red, green, blue, filter, transmit. Unused terms are 0.
struct Terms {
    double value[5] = {};
    int count = 1;
    NodeId nodes = 0; ///< a node of terms; or one that all terms have; 0 when no term follows from the time

    Terms() = default;
    Terms(double number) : value{number} {}
    Terms(const Varying& number) : value{number.value}, nodes(number.node) {}
    Terms(const Vec3<double>& v) : value{v.x, v.y, v.z}, count(3) {}
    Terms(const Vec3<Varying>& v) : Terms({v.x, v.y, v.z}, 3) {}
    /// At most five.
    Terms(std::initializer_list<Varying> terms, int count);

    /// The terms as a vector; a number stands for all of them.
    Vec3<double> vector() const {
        return count == 1 ? Vec3<double>(value[0]) : Vec3<double>(value[0], value[1], value[2]);
    }
    /// Makes `count` terms of fewer: a number is repeated, a vector is padded with 0.
    void promote(int new_count) {
        if (count == 1)
            for (int i = 1; i < new_count; ++i)
                value[i] = value[0];
        else if (nodes != 0 && new_count > count)
            pad_nodes();
        count = new_count;
    }
    Varying term(int index) const { return {value[index], nodes ? node_of_term(index) : 0}; }
    /// The terms as a vector, as of vector().
    Vec3<Varying> varying_vector() const {
        return count == 1 ? Vec3<Varying>(term(0)) : Vec3<Varying>(term(0), term(1), term(2));
    }
    bool finite() const {
        for (int i = 0; i < count; ++i)
            if (!std::isfinite(value[i]))
                return false;
        return true;
    }

private:
    NodeId node_of_term(int index) const;
    void pad_nodes();
};
static_assert(sizeof(Terms) == 6 * sizeof(double));

/// Puts the terms of a colour into a record.
template <class Record> void set_color(Moving<Record>& record, PigmentColor& place, const Terms& terms) {
    record.set(place.rgb, Vec3<Varying>(terms.term(0), terms.term(1), terms.term(2)));
    record.set(place.filter, terms.term(3));
    record.set(place.transmit, terms.term(4));
}

// Indices into SceneProgram, or into a table of the SceneBuilder (textures).
struct PigmentRef {
    uint32_t index = 0;
};
struct FinishRef {
    uint32_t index = 0;
};
struct InteriorRef {
    uint32_t index = 0;
};
struct TextureRef {
    uint32_t index = 0;
};
/// A range of SceneProgram::color_stops.
struct ColorMapRef {
    uint32_t first = 0;
    uint32_t count = 0;
};

/// The same, of stops with pigments.
struct PigmentMapRef {
    uint32_t first = 0;
    uint32_t count = 0;
};

/// What a primitive wears. `none` is what a surrounding union or the default may still give.
struct Surface {
    static constexpr uint32_t none = 0xffffffffu;

    uint32_t texture = none;
    uint32_t interior = none;
    uint32_t flags = 0;       ///< bits of Material::flags that words like no_shadow set
    bool says_hollow = false; ///< `hollow` or `hollow off` was written: no surrounding union changes it

    /// Fills in what is missing here.
    void inherit(const Surface& outer);
};

struct MaterialValue {
    uint32_t texture = Surface::none;
    uint32_t interior = Surface::none;
};

/// Transforms, one behind the other, that are applied to a part of an object when it goes into the scene: the nodes of
/// a million moved spheres exist one by one only.
struct MotionChain {
    std::shared_ptr<const MotionChain> before;
    Transform transform;
    bool keeps_spheres = true; ///< the transform, at the times that the guards allow
};
using MotionChainRef = std::shared_ptr<const MotionChain>;

template <class Geometry> struct Dressed {
    static constexpr uint32_t still = 0xffffffffu;

    Geometry geometry;
    Surface surface;
    uint32_t chain = still; ///< of Shape::chains
};

struct LightSource {
    Moving<Light<double>> light; ///< its `direction` is not set yet
    std::optional<Moving<AreaLight<double>>> area;
};

/// The nodes of a sphere's or plane's own numbers.
struct PartNodes {
    uint32_t part = 0; ///< index of the sphere or plane
    NodeId vector = 0; ///< of terms: centre or normal
    NodeId number = 0; ///< radius or distance
};

/// An object: a sphere, a plane, a light, or a union of any number of them, flat.
struct Shape {
    std::vector<Dressed<Sphere<double>>> spheres;
    std::vector<Dressed<Affine<double>>> ellipsoids; ///< the map of the unit sphere into the world
    std::vector<Dressed<Plane<double>>> planes;
    std::vector<LightSource> lights;
    std::vector<PartNodes> moving_spheres, moving_planes; ///< by rising part
    std::vector<MotionChainRef> chains;
    Surface own; ///< the object's own: for those of its parts that have none

    /// What a copy takes.
    uint64_t bytes() const {
        return spheres.size() * sizeof(spheres[0]) + ellipsoids.size() * sizeof(ellipsoids[0]) +
               planes.size() * sizeof(planes[0]);
    }
    /// Adds a sphere of these numbers, which have these nodes.
    void add(const Sphere<double>& sphere, PartNodes nodes) {
        nodes.part = uint32_t(spheres.size());
        spheres.push_back({sphere, {}});
        if ((nodes.vector | nodes.number) != 0)
            moving_spheres.push_back(nodes);
    }
    /// Gives the own surface to the parts that lack one.
    void dress_parts();
    /// Takes over the parts of another object, which have to be dressed.
    void append(const Shape& other);
};

/// A name of a standard include file that needs a word which Proxima does not support.
struct Refused {
    std::string_view word;
};

struct Array;
class DataFile;
struct Macro;
class Spline;
struct UserFunction;

using ShapeRef = std::shared_ptr<const Shape>;
using SkyRef = std::shared_ptr<const Moving<SkySphere>>;
using FogRef = std::shared_ptr<const Moving<Fog<double>>>;
using CameraRef = std::shared_ptr<const Camera<Varying>>;
using TransformRef = std::shared_ptr<const Transform>;
using MacroRef = std::shared_ptr<const Macro>;
using ArrayRef = std::shared_ptr<Array>;       ///< see array.h
using DataFileRef = std::shared_ptr<DataFile>; ///< an open file
using FunctionRef = std::shared_ptr<UserFunction>;
using SplineRef = std::shared_ptr<const Spline>;

using Value = std::variant<std::monostate, Terms, std::string, PigmentRef, FinishRef, InteriorRef, TextureRef,
                           MaterialValue, ShapeRef, ColorMapRef, SkyRef, FogRef, CameraRef, TransformRef, MacroRef,
                           Refused, ArrayRef, DataFileRef, FunctionRef, SplineRef, PigmentMapRef>;

/// What POV-Ray tells apart where a value may replace only one of its kind.
struct ValueKind {
    size_t type = 0; ///< Value's alternative; 0 is none
    int terms = 0;   ///< of a number, vector or color

    friend bool operator==(const ValueKind&, const ValueKind&) = default;
};

ValueKind kind_of(const Value& value);

/// "a number", "a texture", ...: for messages.
const char* value_description(const Value& value);

} // namespace proxima
