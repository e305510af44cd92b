// SPDX-License-Identifier: Apache-2.0
// camera: its statements apply in a fixed order, whatever their order in the text.
#include "parser/evaluator.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace proxima {

namespace {

bool has_length(const Vec3<Varying>& v) {
    return !decide(apply(MotionOp::is_zero, glm::length(v)));
}

void move(Camera<Varying>& camera, const Transform& transform) {
    if (transform.is_identity)
        return;
    const Affine<Varying> map = transform.with_nodes().map;
    camera.location = map.point(camera.location);
    camera.direction = map.direction(camera.direction);
    camera.right = map.direction(camera.right);
    camera.up = map.direction(camera.up);
}

} // namespace

/// `camera { ... }` after its word. The rules are those of POV-Ray 3.7: right, direction, angle, up, sky, location,
/// look_at, then the transforms.
Camera<Varying> Evaluator::camera() {
    const Token& start = peek();
    expect(TokenKind::left_brace);
    Camera<Varying> camera;
    if (const CameraRef* declared = identifier<CameraRef>()) {
        camera = **declared;
        advance();
        Transform transform;
        while (transform_item(transform)) {
        }
        move(camera, transform);
        if (!accept(TokenKind::right_brace))
            fail_unexpected("a transform or '}': the rest of a declared camera cannot be changed");
        return camera;
    }
    std::optional<Vec3<Varying>> right, up, look_at;
    std::optional<Varying> angle;
    Vec3<Varying> sky(0, 1, 0);
    Transform transform;
    if (accept(Word::orthographic)) // the kind comes first
        camera.kind = CameraKind::orthographic;
    else
        accept(Word::perspective);
    for (;;) {
        const Token& token = peek();
        if (accept(Word::location)) {
            camera.location = moving_vector();
        } else if (accept(Word::look_at)) {
            look_at = moving_vector();
        } else if (accept(Word::right)) {
            right = moving_vector();
        } else if (accept(Word::up)) {
            up = moving_vector();
        } else if (accept(Word::sky)) {
            sky = moving_vector();
        } else if (accept(Word::direction)) {
            camera.direction = moving_vector();
        } else if (accept(Word::angle)) {
            angle = moving_number();
            if (!decide(apply(MotionOp::greater, *angle, 0)) || !decide(apply(MotionOp::less, *angle, 180)))
                fail(token, fmt::format("angle must lie between 0 and 180 degrees, this one is {}", angle->value));
        } else if (!transform_item(transform)) {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("location, look_at, angle, right, up, sky, direction, a transform or '}'");

    camera.right = right.value_or(camera.right);
    camera.up = up.value_or(camera.up);
    if (!has_length(camera.right) || !has_length(camera.direction) || !has_length(camera.up) || !has_length(sky))
        fail(start, "right, up, direction and sky must have a length");
    Varying direction_length = glm::length(camera.direction);
    if (angle) {
        const Varying length = glm::length(camera.right) / tan(*angle * std::numbers::pi / 360) / 2;
        camera.direction *= length / direction_length;
        direction_length = length;
    }
    if (look_at)
        aim_camera(camera, *look_at - camera.location, {sky, direction_length}, start);
    if (camera.kind == CameraKind::orthographic && ((!right && !up) || angle)) {
        // The picture is as large as a perspective camera's would be at the point looked at.
        const Varying scale =
            glm::length(look_at.value_or(Vec3<Varying>(0, 0, 1)) - camera.location) / direction_length;
        camera.right *= scale;
        camera.up *= scale;
    }
    move(camera, transform);
    return camera;
}

/// Turns the camera to what lies `aim` away from it.
void Evaluator::aim_camera(Camera<Varying>& camera, const Vec3<Varying>& aim, const CameraFrame& frame,
                           const Token& at) {
    const Varying distance = glm::length(aim);
    if (distance.value == 0)
        fail(at, "the camera looks at its own location");
    const Varying handedness = glm::dot(glm::cross(camera.up, camera.direction), camera.right);
    const Varying right_length = glm::length(camera.right), up_length = glm::length(camera.up);
    const Vec3<Varying> across = glm::cross(frame.sky, aim / distance);
    camera.direction = aim / distance * frame.direction_length;
    const bool parallel = decide(apply(MotionOp::less, glm::length(across), epsilon));
    if (parallel)
        warn(at, "the camera looks along its sky vector");
    const Vec3<Varying> side = glm::normalize(parallel ? camera.right : across);
    const bool is_right_handed = decide(apply(MotionOp::greater, handedness, 0));
    camera.right = is_right_handed ? side * right_length : -side * right_length;
    camera.up = glm::cross(aim / distance, side) * up_length;
}

} // namespace proxima
