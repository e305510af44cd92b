// SPDX-License-Identifier: Apache-2.0
// Evaluates a scene that stands in a test as a string.
#pragma once
#include "parser/evaluator.h"

#include <doctest/doctest.h>
#include <string>

namespace proxima::testing {

struct Evaluated {
    SceneProgram scene;
    Diagnostics diagnostics;
    std::string messages; ///< as printed
};

inline Evaluated evaluate(const std::string& text, const EvaluationSettings& settings = {}) {
    Evaluated result;
    ScriptSources sources;
    sources.files.add_text("scene", text);
    result.scene = Evaluator(sources, settings, result.diagnostics).run();
    result.messages = result.diagnostics.format(sources.files);
    return result;
}

/// The scene of a text that has no mistakes.
inline SceneProgram scene_of(const std::string& text, const EvaluationSettings& settings = {}) {
    Evaluated result = evaluate(text, settings);
    INFO(text);
    INFO(result.messages);
    CHECK(!result.diagnostics.has_errors());
    return std::move(result.scene);
}

/// The first error's message, or "".
inline std::string error_of(const std::string& text, const EvaluationSettings& settings = {}) {
    const Evaluated result = evaluate(text, settings);
    for (const Diagnostic& diagnostic : result.diagnostics.all())
        if (diagnostic.severity == Severity::error)
            return diagnostic.message;
    return "";
}

/// The value of a number expression.
inline double number_of(const std::string& expression) {
    const SceneProgram scene = scene_of("#declare Value = (" + expression + "); sphere { Value*x, 1 }");
    return scene.spheres.size() == 1 ? scene.spheres[0].center.x : NAN;
}

/// The value of a vector expression.
inline Vec3<double> vector_of(const std::string& expression) {
    const SceneProgram scene = scene_of("sphere { " + expression + ", 1 }");
    return scene.spheres.size() == 1 ? scene.spheres[0].center : Vec3<double>(NAN);
}

inline const Layer& top_layer(const SceneProgram& scene, uint32_t material) {
    const Material& found = scene.materials[material];
    return scene.layers[found.first_layer + found.layer_count - 1];
}

/// The pigment and finish of the first sphere's top layer.
inline const Pigment& pigment_of(const SceneProgram& scene) {
    return scene.pigments[top_layer(scene, scene.sphere_materials.at(0)).pigment];
}
inline const Finish& finish_of(const SceneProgram& scene) {
    return scene.finishes[top_layer(scene, scene.sphere_materials.at(0)).finish];
}

template <class Vector> void check_near(const Vector& a, const Vector& b, double tolerance = 1e-9) {
    CHECK(std::abs(a.x - b.x) <= tolerance);
    CHECK(std::abs(a.y - b.y) <= tolerance);
    CHECK(std::abs(a.z - b.z) <= tolerance);
}

} // namespace proxima::testing
