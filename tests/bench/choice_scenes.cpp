// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/choice_scenes.h"
#include "tests/bench/choice_arrangements.h"

#include <glm/geometric.hpp>

namespace proxima::bench {
namespace {

struct View {
    const char* name;
    Point from, at;
    double width; ///< of the picture one unit away
};
const View outside{"outside", {0.5, 0.7, -1.5}, Point(0.5), 1.0};
const View inside{"inside", {0.45, 0.52, 0.4}, {0.9, 0.6, 0.7}, 1.6};
const View near_by{"near", {0.8, 0.9, -0.1}, {0.5, 0.4, 0.6}, 1.2};
const View far_away{"far", {4.0, 3.0, -6.0}, Point(0.5), 0.6};
const View grazing{"grazing", {-0.6, 0.35, 0.06}, {0.6, 0.32, 0.3}, 0.9};
const View above{"above", {0.5, 2.0, 0.45}, Point(0.5), 1.0};

struct Recipe {
    const char* name;
    uint32_t count;
    Arrangement arrangement;
    View view;
    uint32_t lights = 1;
};

const std::vector<Recipe>& recipes(SceneSet set) {
    static const std::vector<Recipe> fit{
        {"uniform", 20000, uniform(0.3), outside},
        {"uniform", 5000, uniform(0.15), inside, 2},
        {"two planes", 20000, planes(2, 0.4), outside},
        {"two planes", 5000, planes(2, 0.3), grazing},
        {"clusters of 50", 20000, clusters(50, 0.012, 0.3), outside},
        {"clusters of 8", 8000, clusters(8, 0.05, 0.3), near_by, 2},
        {"shell", 20000, shell(0.0, 0.5), outside},
        {"thick shell", 10000, shell(0.15, 0.3), inside},
        {"lines of 20", 10000, lines(20, 0.005, 0.2), outside},
        {"mixed", 20000, mixed(1.0), near_by},
        {"lattice", 20000, lattice(0.3), outside},
        {"disc", 20000, disc(0.01), above},
        {"corner", 20000, corner(0.3), outside},
        {"outliers", 20000, outliers(0.05, 100), outside},
        {"sponge", 20000, sponge(20, 0.15), outside, 0},
        {"hills", 20000, hills(0.4), near_by},
        {"dust", 20000, uniform(0.03), outside},
        {"spiral", 10000, spiral(3), outside},
    };
    static const std::vector<Recipe> test{
        {"uniform", 3000, uniform(0.25), outside},
        {"uniform", 40000, uniform(0.35), near_by},
        {"uniform", 15000, uniform(0.1), far_away},
        {"uniform", 10000, uniform(0.05), inside},
        {"uniform", 30000, uniform(0.2), above, 2},
        {"two planes", 30000, planes(2, 0.35), outside},
        {"two planes", 15000, planes(2, 0.45), near_by},
        {"two planes", 4000, planes(2, 0.4), outside},
        {"three planes", 20000, planes(3, 0.25), outside, 2},
        {"five planes", 40000, planes(5, 0.3), inside},
        {"one plane", 20000, planes(1, 0.4), outside},
        {"twenty planes", 40000, planes(20, 0.3), outside},
        {"clusters of 200", 40000, clusters(200, 0.012, 0.2), outside},
        {"clusters of 30", 6000, clusters(30, 0.02, 0.4), outside},
        {"clusters of 5", 30000, clusters(5, 0.03, 0.25), far_away},
        {"clusters of 500", 30000, clusters(500, 0.01, 0.3), inside},
        {"clusters of 20", 15000, clusters(20, 0.08, 0.3), above},
        {"clusters of 100", 10000, clusters(100, 0.004, 0.5), near_by, 3},
        {"shell", 40000, shell(0.0, 0.4), inside},
        {"shell", 8000, shell(0.02, 0.6), outside},
        {"shell", 20000, shell(0.0, 1.0), far_away},
        {"thick shell", 30000, shell(0.25, 0.2), near_by},
        {"lines of 5", 6000, lines(5, 0.002, 0.1), outside},
        {"lines of 100", 30000, lines(100, 0.004, 0.3), inside},
        {"lines of 40", 20000, lines(40, 0.01, 0.2), near_by},
        {"mixed", 10000, mixed(1.4), outside},
        {"mixed", 30000, mixed(0.7), inside},
        {"mixed", 20000, mixed(1.2), far_away, 2},
        {"lattice", 30000, lattice(0.2), inside},
        {"lattice", 8000, lattice(0.45), near_by},
        {"disc", 30000, disc(0.03), outside},
        {"disc", 10000, disc(0.005), grazing},
        {"disc", 40000, disc(0.1), inside},
        {"corner", 10000, corner(0.5), outside},
        {"corner", 30000, corner(0.2), near_by},
        {"corner", 20000, corner(0.1), outside},
        {"outliers", 30000, outliers(0.1, 300), outside},
        {"outliers", 10000, outliers(0.03, 50), near_by},
        {"outliers", 40000, outliers(0.2, 1000), inside},
        {"sponge", 30000, sponge(50, 0.1), inside},
        {"sponge", 15000, sponge(8, 0.25), outside},
        {"hills", 30000, hills(0.5), outside},
        {"hills", 10000, hills(0.2), grazing},
        {"dust", 40000, uniform(0.02), inside, 2},
        {"spiral", 20000, spiral(4), near_by},
        {"spiral", 5000, spiral(2), above},
    };
    return set == SceneSet::fit ? fit : test;
}

void look(SceneProgram& scene, const View& view) {
    const Point forward = glm::normalize(view.at - view.from);
    const Point right = glm::normalize(glm::cross(Point(0, 1, 0), forward));
    scene.camera.location = view.from;
    scene.camera.direction = forward;
    scene.camera.right = view.width * right;
    scene.camera.up = view.width * 9 / 16 * glm::cross(forward, right);
}

} // namespace

size_t choice_scene_count(SceneSet set) {
    return recipes(set).size();
}

ChoiceScene choice_scene(SceneSet set, size_t place, double scale) {
    const Recipe& recipe = recipes(set)[place];
    const uint32_t count = uint32_t(recipe.count * scale);
    ChoiceScene made{std::string(recipe.name) + " " + std::to_string(count) + " " + recipe.view.name, {}};
    SceneProgram& scene = made.scene;
    scene.layers = {{0, 0}};
    scene.pigments = {{.color = {glm::vec3(0.8f, 0.5f, 0.3f)}, .second_color = {}}};
    scene.finishes = {Finish{}};
    scene.interiors = {Interior{}};
    scene.materials = {Material{}};
    scene.spheres.reserve(count);
    Dice dice(uint32_t(place) + (set == SceneSet::fit ? 1 : 5000));
    for (uint32_t i = 0; i < count; ++i) {
        const Ball ball = recipe.arrangement(dice, i, count);
        scene.spheres.push_back({ball.center, ball.radius});
    }
    scene.sphere_materials.assign(count, 0);
    const Point lights[] = {{3, 5, -4}, {-4, 3, 1}, {0.5, 8, 0.5}};
    for (uint32_t i = 0; i < recipe.lights; ++i)
        scene.lights.push_back({.position = lights[i], .color = glm::vec3(1.0f)});
    look(scene, recipe.view);
    return made;
}

} // namespace proxima::bench
