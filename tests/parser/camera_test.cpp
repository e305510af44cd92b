// SPDX-License-Identifier: Apache-2.0
// Camera vectors and lights.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

Camera<double> camera_of(const std::string& text) {
    return scene_of("camera { " + text + " }").camera;
}

} // namespace

TEST_CASE("camera: the default looks along z with POV-Ray's 1.33") {
    const Camera<double> camera = camera_of("");
    check_near(camera.location, {0, 0, 0});
    check_near(camera.direction, {0, 0, 1});
    check_near(camera.right, {1.33, 0, 0});
    check_near(camera.up, {0, 1, 0});
    CHECK(camera.kind == CameraKind::perspective);
}

TEST_CASE("camera: angle is horizontal and follows right") {
    CHECK(glm::length(camera_of("angle 90").direction) == doctest::Approx(1.33 / 2));
    CHECK(glm::length(camera_of("angle 90 right 2*x").direction) == doctest::Approx(1));
    CHECK(glm::length(camera_of("angle 60 right 2*x direction 7*z").direction) ==
          doctest::Approx(1 / std::tan(0.5235987755982988)));
}

TEST_CASE("camera: look_at turns right and up about sky") {
    Camera<double> camera = camera_of("location <0, 0, -5> look_at 0");
    check_near(camera.direction, {0, 0, 1});
    check_near(camera.right, {1.33, 0, 0});
    camera = camera_of("location <5, 0, 0> look_at 0 right 2*x");
    check_near(camera.direction, {-1, 0, 0});
    check_near(camera.right, {0, 0, 2});
    check_near(camera.up, {0, 1, 0});
    camera = camera_of("location <0, 5, 0> look_at 0 sky z right -2*x up 3*y");
    check_near(camera.direction, {0, -1, 0});
    check_near(camera.right, {-2, 0, 0});
    check_near(camera.up, {0, 0, 3});
}

TEST_CASE("camera: along its sky vector the given right stays") {
    Camera<double> camera = camera_of("location 10*y look_at 0 right x");
    check_near(camera.right, {1, 0, 0});
    check_near(camera.up, {0, 0, 1});
    camera = camera_of("location 10*y look_at 0 right -x");
    check_near(camera.right, {1, 0, 0});
    check_near(camera.up, {0, 0, -1});
    camera = camera_of("location -10*y look_at 0 right z");
    check_near(camera.right, {0, 0, -1});
    check_near(camera.up, {1, 0, 0});
}

TEST_CASE("camera: the order of its statements does not matter, except among transforms") {
    const Camera<double> one = camera_of("look_at <1, 2, 3> angle 40 right x*4/3 location <0, 1, -9>");
    const Camera<double> other = camera_of("location <0, 1, -9> right x*4/3 angle 40 look_at <1, 2, 3>");
    check_near(one.direction, other.direction, 1e-15);
    check_near(one.right, other.right, 1e-15);
    check_near(camera_of("location x rotate 90*z translate x").location, {1, 1, 0});
    check_near(camera_of("location x translate x rotate 90*z").location, {0, 2, 0});
    check_near(camera_of("rotate 90*y").direction, {1, 0, 0});
}

TEST_CASE("camera: an orthographic picture is as large as the perspective one at the point looked at") {
    Camera<double> camera = camera_of("orthographic location -5*z look_at 0 right 4*x up 3*y");
    CHECK(camera.kind == CameraKind::orthographic);
    check_near(camera.right, {4, 0, 0});
    camera = camera_of("orthographic location -5*z look_at 0");
    check_near(camera.right, {1.33 * 5, 0, 0});
    check_near(camera.up, {0, 5, 0});
    camera = camera_of("orthographic location -5*z look_at 0 right 2*x angle 90");
    check_near(camera.right, {10, 0, 0});
}

TEST_CASE("camera: the width and height of the picture") {
    EvaluationSettings settings;
    settings.image_width = 300;
    settings.image_height = 100;
    check_near(scene_of("camera { right x*image_width/image_height }", settings).camera.right, {3, 0, 0});
}

TEST_CASE("camera: mistakes") {
    struct Case {
        const char* text;
        const char* message;
    };
    const Case cases[] = {
        {"angle 180", "angle must lie between 0 and 180 degrees, this one is 180"},
        {"angle -5", "angle must lie between 0 and 180 degrees, this one is -5"},
        {"location x look_at x", "the camera looks at its own location"},
        {"right 0*x", "right, up, direction and sky must have a length"},
        {"fisheye", "Proxima does not support 'fisheye'"},
        {"aperture 0.5", "Proxima does not support 'aperture'"},
        {"locatoin x", "'locatoin' is not declared"},
        {"location x orthographic", "unexpected 'orthographic'"},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        CHECK(error_of(std::string("camera { ") + test.text + " }") == test.message);
    }
    CHECK(evaluate("camera { } camera { location x }").messages.find("replaces the one before it") !=
          std::string::npos);
}
