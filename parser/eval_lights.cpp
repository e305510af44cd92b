// SPDX-License-Identifier: Apache-2.0
// light_source: its kind, its area, and the object that shows it.
#include "parser/evaluator.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace proxima {
namespace {

Varying cosine_of(const Varying& degrees) {
    return cos(degrees * std::numbers::pi / 180);
}

} // namespace

/// `light_source { ...` after its brace, to the closing one: puts a light into the shape, and what it looks like.
void Evaluator::light_source(Shape& shape) {
    if (const ShapeRef* declared = identifier<ShapeRef>(); declared && (*declared)->lights.size() == 1) {
        shape = **declared;
        advance();
    } else {
        LightSource source;
        source.light.set(source.light.record.position, moving_vector());
        accept(TokenKind::comma);
        source.light.set(source.light.record.color, rgb_color());
        shape.lights.push_back(source);
    }
    for (;;) {
        Moving<Light<double>>& light = shape.lights.front().light;
        Transform transform;
        const Token& token = peek();
        if (accept(Word::fade_distance)) {
            light.set(light.record.fade_distance, moving_number());
        } else if (accept(Word::fade_power)) {
            light.set(light.record.fade_power, moving_number());
        } else if (accept(Word::looks_like)) {
            looks_like(shape);
        } else if (accept(Word::media_interaction)) {
            optional_flag(true); // matters to media alone
        } else if (accept(Word::media_attenuation)) {
            if (optional_flag(true))
                fail(token, "Proxima does not support 'media_attenuation'",
                     "leave it out: fog does not dim the way from a light");
        } else if (transform_item(transform)) {
            transform_shape(shape, transform, builder_);
        } else if (!light_kind_item(shape.lights.front()) && !area_light_item(shape.lights.front())) {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected(
            "spotlight, cylinder, parallel, area_light, shadowless, fade_distance, fade_power, looks_like, a "
            "transform or '}'");
    const std::optional<Moving<AreaLight<double>>>& area = shape.lights.front().area;
    if (!area)
        return;
    if (area->record.circular && (area->record.columns < 2 || area->record.rows < 2))
        fail(cursor_[-1], "a circular area light needs more than one place along each axis");
}

/// What shape the light's beam has.
bool Evaluator::light_kind_item(LightSource& source) {
    Light<double>& light = source.light.record;
    const auto set = [&](double& place, const Varying& value) { source.light.set(place, value); };
    const Token& token = peek();
    const auto only_in_beams = [&] {
        if (light.kind == LightKind::point)
            fail(token, fmt::format("'{}' stands in a point light", spelling(token)),
                 "write spotlight or cylinder before it");
    };
    const auto width = [&] {
        const Varying value = moving_number();
        return light.kind == LightKind::spot ? cosine_of(value) : value;
    };
    if (accept(Word::spotlight)) {
        light.kind = LightKind::spot;
        light.shadowless = 0;
        set(light.radius, cosine_of(30));
        set(light.falloff, cosine_of(45));
        set(light.tightness, 0);
    } else if (accept(Word::cylinder)) {
        light.kind = LightKind::cylinder;
        light.shadowless = 0;
        set(light.radius, 0.75);
        set(light.falloff, 1);
        set(light.tightness, 0);
    } else if (accept(Word::shadowless)) { // another kind of light to POV-Ray
        light.kind = LightKind::point;
        light.shadowless = 1;
    } else if (accept(Word::parallel)) {
        light.parallel = 1;
    } else if (accept(Word::point_at)) {
        if (light.kind == LightKind::point && !light.parallel)
            fail(token, "'point_at' stands in a light without a direction",
                 "write spotlight, cylinder or parallel before it");
        source.light.set(light.point_at, moving_vector());
    } else if (accept(Word::radius)) {
        only_in_beams();
        set(light.radius, width());
    } else if (accept(Word::falloff)) {
        only_in_beams();
        set(light.falloff, width());
    } else if (accept(Word::tightness)) {
        only_in_beams();
        set(light.tightness, moving_number());
    } else {
        return false;
    }
    return true;
}

bool Evaluator::area_light_item(LightSource& source) {
    std::optional<Moving<AreaLight<double>>>& area = source.area;
    const Token& token = peek();
    if (accept(Word::area_light)) {
        Moving<AreaLight<double>> given = area.value_or(Moving<AreaLight<double>>{});
        given.set(given.record.axis1, moving_vector());
        accept(TokenKind::comma);
        given.set(given.record.axis2, moving_vector());
        for (uint32_t* places : {&given.record.columns, &given.record.rows}) {
            accept(TokenKind::comma);
            const Token& at = peek();
            const double count = std::trunc(number());
            if (!(count >= 1 && count <= AreaLight<double>::most))
                fail(at, fmt::format("an area light has 1 to {} places along an axis, this one {}",
                                     AreaLight<double>::most, count));
            *places = uint32_t(count);
        }
        area = given;
        return true;
    }
    const bool belongs =
        peek_is(Word::adaptive) || peek_is(Word::circular) || peek_is(Word::orient) || peek_is(Word::jitter);
    if (!belongs)
        return false;
    advance();
    if (!area)
        fail(token, fmt::format("'{}' stands in a light without area", spelling(token)), "write area_light before it");
    switch (Word(token.index)) {
    case Word::adaptive: {
        const double level = std::trunc(number());
        area->record.adaptive = level >= 8 ? AreaLight<double>::every_place : level > 0 ? uint32_t(level) : 0u;
        break;
    }
    case Word::orient:
        area->record.orient = area->record.circular = 1; // POV-Ray makes such a light circular
        break;
    case Word::circular:
        area->record.circular = 1;
        break;
    default:
        area->record.jitter = 1;
    }
    return true;
}

/// `looks_like { object }` after its word: an object around the origin, moved to the light, that casts no shadow.
void Evaluator::looks_like(Shape& shape) {
    expect(TokenKind::left_brace);
    if (!starts_shape())
        fail_unexpected("an object");
    Shape look = object();
    look.own.flags |= material_no_shadow;
    look.dress_parts();
    const Moving<Light<double>>& light = shape.lights.front().light;
    transform_shape(look, Transform(translation(light.get(light->position))), builder_);
    expect(TokenKind::right_brace);
    shape.append(look);
}

} // namespace proxima
