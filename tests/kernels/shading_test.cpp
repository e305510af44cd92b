// SPDX-License-Identifier: Apache-2.0
// Shading terms against values worked out by hand from POV-Ray's formulas.
#include "kernels/shading.h"

#include <cmath>
#include <doctest/doctest.h>

using namespace proxima;

namespace {

const Vec3<double> up{0, 1, 0};
Vec3<double> tilted(double cosine) {
    return {std::sqrt(1 - cosine * cosine), cosine, 0};
}
const LayerColor<double> orange{{1, 0.5, 0}, {0, 0, 0}, 1};

Finish dark() {
    Finish finish;
    finish.diffuse = 0;
    return finish;
}

} // namespace

TEST_CASE("diffuse: proportional to the cosine to the power of brilliance, and to opacity") {
    Finish finish;
    finish.diffuse = 0.6f;
    const LightGeometry<double> geometry{up, tilted(0.5), -up};
    const Vec3<double> white(1.0);
    CHECK(reflected_light(finish, orange, geometry, white, true).x == doctest::Approx(0.3));
    CHECK(reflected_light(finish, orange, geometry, white, true).y == doctest::Approx(0.15));
    finish.brilliance = 3;
    CHECK(reflected_light(finish, orange, geometry, white, true).x == doctest::Approx(0.075));
    LayerColor<double> veil = orange;
    veil.opacity = 0.5;
    CHECK(reflected_light(finish, veil, geometry, white, true).x == doctest::Approx(0.0375));
}

TEST_CASE("highlights: white unless metallic, and none of a shadowless light") {
    const LightGeometry<double> mirror{up, tilted(0.8), {tilted(0.8).x, -0.8, 0}}; // the mirrored ray meets the light
    Finish phong = dark();
    phong.phong = 0.9f;
    CHECK(reflected_light(phong, orange, mirror, Vec3<double>(1.0), true).z == doctest::Approx(0.9));
    CHECK(reflected_light(phong, orange, mirror, Vec3<double>(1.0), false) == Vec3<double>(0.0));
    Finish specular = dark();
    specular.specular = 0.5f;
    CHECK(reflected_light(specular, orange, mirror, Vec3<double>(1.0), true).z == doctest::Approx(0.5));
    phong.metallic = 1;
    const Vec3<double> metal = reflected_light(phong, orange, mirror, Vec3<double>(1.0), true);
    CHECK(metal.x == doctest::Approx(0.9));
    CHECK(metal.z < 0.05);
}

TEST_CASE("highlights: fall off with phong_size and roughness") {
    Finish finish;
    finish.phong = 1;
    finish.phong_size = 40;
    CHECK(phong_highlight(finish, 0.9) == doctest::Approx(std::pow(0.9, 40)));
    CHECK(phong_highlight(finish, -0.1) == 0);
    finish.phong_size = 80;
    CHECK(phong_highlight(finish, 0.0007) == 0);
    finish.specular = 0.5f;
    finish.inverse_roughness = 20;
    CHECK(specular_highlight(finish, 0.9) == doctest::Approx(0.5 * std::pow(0.9, 20)));
}

TEST_CASE("metallic tint: the pigment's colour head on, white at grazing incidence") {
    const Vec3<double> rgb{0.2, 0.5, 1};
    // F(0) = 0.014567225 / 1.12^2 - 0.011612903
    const double head_on = 0.014567225 / (1.12 * 1.12) - 0.011612903;
    CHECK(metallic_tint(rgb, 1.0, 1.0).x == doctest::Approx(1 + (1 - head_on) * (0.2 - 1)));
    CHECK(metallic_tint(rgb, 1.0, 0.0).x == doctest::Approx(1).epsilon(1e-6));
    CHECK(metallic_tint(rgb, 0.0, 0.7) == Vec3<double>(1.0));
}

TEST_CASE("Fresnel: reflectance of glass, from either side") {
    struct Row {
        double ior, cosine, reflectance;
    };
    const Row rows[] = {
        {1.5, 1, 0.04},    {1 / 1.5, 1, 0.04}, {1.5, 0, 1}, {1.5, 0.5, 0.0891867}, // s 0.1779.., p 0.0004.. halved
        {1 / 1.5, 0.5, 1},                                                         // beyond the critical angle
        {1, 0.3, 0},
    };
    for (const Row& row : rows) {
        CAPTURE(row.ior);
        CAPTURE(row.cosine);
        CHECK(fresnel_reflectance(row.ior, row.cosine) == doctest::Approx(row.reflectance).epsilon(1e-4));
    }
}

TEST_CASE("reflection: from min head on to max at grazing, by falloff or by Fresnel") {
    Finish finish;
    finish.reflection_min = {0.2f, 0, 0};
    finish.reflection_max = {0.6f, 0.5f, 0};
    CHECK(reflection_of(finish, orange.rgb, 1.0, 1.0).color.x == doctest::Approx(0.2));
    CHECK(reflection_of(finish, orange.rgb, 0.0, 1.0).color.x == doctest::Approx(0.6));
    CHECK(reflection_of(finish, orange.rgb, 0.5, 1.0).color.y == doctest::Approx(0.25));
    CHECK(reflection_of(finish, orange.rgb, 0.5, 1.0).weight == doctest::Approx(0.6));
    finish.reflection_falloff = 2;
    CHECK(reflection_of(finish, orange.rgb, 0.5, 1.0).color.y == doctest::Approx(0.125));
    finish.fresnel = 1;
    CHECK(reflection_of(finish, orange.rgb, 1.0, 1.5).color.x == doctest::Approx(0.04 * 0.6 + 0.96 * 0.2));
    CHECK(reflection_of(finish, orange.rgb, 1.0, 1.5).weight == doctest::Approx(0.04 * 0.6 + 0.96 * 0.2));
}

TEST_CASE("Snell: rays bend by the ratio of the indices, until all is reflected") {
    Vec3<double> bent;
    const Vec3<double> down{std::sqrt(0.5), -std::sqrt(0.5), 0};
    REQUIRE(refracted(down, up, 1 / 1.5, bent));
    CHECK(bent.x == doctest::Approx(std::sqrt(0.5) / 1.5));
    CHECK(glm::length(bent) == doctest::Approx(1));
    REQUIRE(refracted(down, up, 1.0, bent));
    CHECK(glm::length(bent - down) < 1e-15);
    CHECK(refracted(down, up, 1.41, bent));
    CHECK_FALSE(refracted(down, up, 1.42, bent)); // 1.42 sin 45 > 1
    CHECK(glm::length(mirrored(down, up) - Vec3<double>(std::sqrt(0.5), std::sqrt(0.5), 0)) < 1e-15);
}
