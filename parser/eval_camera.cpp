// SPDX-License-Identifier: Apache-2.0
// camera: its statements apply in a fixed order, whatever their order in the text.
#include "parser/evaluator.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace proxima {

/// `camera { ... }` after its word. The rules are those of POV-Ray 3.7: right, direction, angle, up, sky, location,
/// look_at, then the transforms.
Camera<double> Evaluator::camera() {
    const Token& start = peek();
    expect(TokenKind::left_brace);
    Camera<double> camera;
    if (const CameraRef* declared = identifier<CameraRef>()) {
        camera = **declared;
        advance();
        TransformPair transform;
        while (transform_item(transform)) {
        }
        camera.location = transform.map.point(camera.location);
        camera.direction = transform.map.direction(camera.direction);
        camera.right = transform.map.direction(camera.right);
        camera.up = transform.map.direction(camera.up);
        if (!accept(TokenKind::right_brace))
            fail_unexpected("a transform or '}': the rest of a declared camera cannot be changed");
        return camera;
    }
    std::optional<Vec3<double>> right, up, look_at;
    std::optional<double> angle;
    Vec3<double> sky(0, 1, 0);
    TransformPair transform;
    if (accept(Word::orthographic)) // the kind comes first
        camera.kind = CameraKind::orthographic;
    else
        accept(Word::perspective);
    for (;;) {
        const Token& token = peek();
        if (accept(Word::location)) {
            camera.location = vector();
        } else if (accept(Word::look_at)) {
            look_at = vector();
        } else if (accept(Word::right)) {
            right = vector();
        } else if (accept(Word::up)) {
            up = vector();
        } else if (accept(Word::sky)) {
            sky = vector();
        } else if (accept(Word::direction)) {
            camera.direction = vector();
        } else if (accept(Word::angle)) {
            angle = number();
            if (!(*angle > 0 && *angle < 180))
                fail(token, fmt::format("angle must lie between 0 and 180 degrees, this one is {}", *angle));
        } else if (!transform_item(transform)) {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("location, look_at, angle, right, up, sky, direction, a transform or '}'");

    camera.right = right.value_or(camera.right);
    camera.up = up.value_or(camera.up);
    const double right_length = glm::length(camera.right);
    double direction_length = glm::length(camera.direction);
    const double up_length = glm::length(camera.up);
    if (right_length == 0 || direction_length == 0 || up_length == 0 || glm::length(sky) == 0)
        fail(start, "right, up, direction and sky must have a length");
    if (angle) {
        const double length = right_length / std::tan(*angle * std::numbers::pi / 360) / 2;
        camera.direction *= length / direction_length;
        direction_length = length;
    }
    if (look_at) {
        const Vec3<double> aim = *look_at - camera.location;
        const double distance = glm::length(aim);
        if (distance == 0)
            fail(start, "the camera looks at its own location");
        const double handedness = glm::dot(glm::cross(camera.up, camera.direction), camera.right);
        const Vec3<double> across = glm::cross(sky, aim / distance);
        camera.direction = aim / distance * direction_length;
        const bool parallel = glm::length(across) < epsilon;
        if (parallel)
            warn(start, "the camera looks along its sky vector");
        const Vec3<double> side = glm::normalize(parallel ? camera.right : across);
        camera.right = handedness > 0 ? side * right_length : -side * right_length;
        camera.up = glm::cross(aim / distance, side) * up_length;
    }
    if (camera.kind == CameraKind::orthographic && ((!right && !up) || angle)) {
        // The picture is as large as a perspective camera's would be at the point looked at.
        const double scale = glm::length(look_at.value_or(Vec3<double>(0, 0, 1)) - camera.location) / direction_length;
        camera.right *= scale;
        camera.up *= scale;
    }
    camera.location = transform.map.point(camera.location);
    camera.direction = transform.map.direction(camera.direction);
    camera.right = transform.map.direction(camera.right);
    camera.up = transform.map.direction(camera.up);
    return camera;
}

} // namespace proxima
