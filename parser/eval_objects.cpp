// SPDX-License-Identifier: Apache-2.0
// Objects: sphere, plane, union and object, and what stands behind their geometry.
#include "parser/evaluator.h"

#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <unordered_map>

namespace proxima {

bool Evaluator::starts_object() {
    const Token& token = peek();
    if (token.kind == TokenKind::sphere_run)
        return true;
    return token.kind == TokenKind::word && token.index <= uint32_t(Word::object);
}

bool Evaluator::starts_shape() {
    return starts_object() || identifier<ShapeRef>();
}

Shape Evaluator::object() {
    const Nesting nesting(*this);
    if (const ShapeRef* declared = identifier<ShapeRef>()) {
        const ShapeRef copied = *declared; // behind the name an element's array may be gone
        advance();
        return *copied;
    }
    Shape shape;
    if (peek().kind == TokenKind::sphere_run) {
        literal_sphere(shape);
        return shape;
    }
    const Word word = Word(next().index);
    expect(TokenKind::left_brace);
    switch (word) {
    case Word::sphere:
        sphere(shape);
        break;
    case Word::plane:
        plane(shape);
        break;
    case Word::union_:
        union_parts(shape);
        break;
    case Word::light_source:
        light_source(shape);
        return shape;
    default:
        object_reference(shape);
    }
    object_modifiers(shape, word);
    charge(shape.bytes());
    return shape;
}

void Evaluator::sphere(Shape& shape) {
    if (const ShapeRef* declared = identifier<ShapeRef>()) {
        shape = **declared;
        advance();
        return;
    }
    PartNodes nodes;
    const Sphere<double> numbers = sphere_numbers(nodes);
    shape.add(numbers, nodes);
}

/// Centre and radius, and their nodes. The programs for spheres see to it that a radius stays above 0.
Sphere<double> Evaluator::sphere_numbers(PartNodes& nodes) {
    const Terms center = vector_of(3, "a vector");
    accept(TokenKind::comma);
    const Token& at = peek();
    const Varying radius = moving_number();
    if (!(radius.value > 0))
        fail(at, fmt::format("the radius of a sphere must be above 0, this one is {}", radius.value));
    nodes.vector = center.nodes;
    nodes.number = radius.node;
    return {center.vector(), radius.value};
}

/// A sphere of its own, behind its word. Loops make millions of them: one that ends plainly goes straight into the
/// scene.
void Evaluator::sphere_item(const Token& start) {
    const Nesting nesting(*this);
    expect(TokenKind::left_brace);
    const bool is_copy = identifier<ShapeRef>();
    Sphere<double> numbers;
    PartNodes nodes;
    if (!is_copy) {
        numbers = sphere_numbers(nodes);
        Surface surface;
        if (plain_end(surface))
            return builder_.add_sphere(numbers, nodes, surface, default_texture_);
    }
    Shape shape;
    if (is_copy)
        sphere(shape);
    else
        shape.add(numbers, nodes);
    object_modifiers(shape, Word::sphere);
    add_to_scene(shape, start);
}

/// An object that begins at `start`, whole.
void Evaluator::add_to_scene(Shape& shape, const Token& start) {
    shape.dress_parts();
    if (builder_.add_shape(shape, default_texture_))
        return;
    if (cursor_ > program_->tokens.data() && cursor_[-1].kind == TokenKind::right_brace)
        --cursor_; // the object's own: recover() goes on behind it
    fail(start, "the transforms of this object lead to numbers that are not finite",
         "scale and move it by less: its numbers, the product of its three scales, and their inverses must be below "
         "1.8e308");
}

/// Steps over `}` or `texture { Name } }`, if nothing else follows.
bool Evaluator::plain_end(Surface& surface) {
    const Token* const token = &peek();
    if (accept(TokenKind::right_brace))
        return true;
    static constexpr TokenKind kinds[] = {TokenKind::word, TokenKind::left_brace, TokenKind::name,
                                          TokenKind::right_brace, TokenKind::right_brace};
    for (size_t i = 0; i < std::size(kinds); ++i)
        if (token[i].kind != kinds[i] || token[i].directive != Directive::none)
            return false;
    const Binding* binding = token->index == uint32_t(Word::texture) ? lookup(token[2]) : nullptr;
    const TextureRef* texture = binding ? std::get_if<TextureRef>(&binding->value) : nullptr;
    if (!texture)
        return false;
    surface.texture = texture->index;
    for (size_t i = 0; i < std::size(kinds); ++i)
        advance();
    return true;
}

void Evaluator::plane(Shape& shape) {
    if (const ShapeRef* declared = identifier<ShapeRef>()) {
        shape = **declared;
        advance();
        return;
    }
    const Token& at = peek();
    const Vec3<Varying> normal = moving_vector();
    accept(TokenKind::comma);
    const Varying distance = moving_number();
    const Varying length = glm::length(normal);
    if (!(length.value > 0))
        fail(at, "the normal of a plane must have a length");
    const Vec3<Varying> unit = normal / length;
    shape.planes.push_back({{value_of(unit), distance.value, 0}, {}});
    if (const NodeId nodes = Terms(unit).nodes; (nodes | distance.node) != 0)
        shape.moving_planes.push_back({0, nodes, distance.node});
}

void Evaluator::union_parts(Shape& shape) {
    if (const ShapeRef* declared = identifier<ShapeRef>()) {
        shape = **declared;
        advance();
        return;
    }
    bool any = false;
    while (starts_object()) {
        Shape part = object();
        part.dress_parts();
        shape.append(part);
        any = true;
    }
    if (!any)
        fail_unexpected("an object: a union has one or more");
}

void Evaluator::object_reference(Shape& shape) {
    if (const ShapeRef* declared = identifier<ShapeRef>()) {
        shape = **declared;
        advance();
    } else if (starts_object()) {
        shape = object();
    } else {
        fail_unexpected("the name of a declared object");
    }
}

/// What follows an object's geometry, to the closing brace. The order matters: a transform moves what stands before it.
void Evaluator::object_modifiers(Shape& shape, Word kind) {
    Surface& own = shape.own;
    for (;;) {
        Transform transform;
        if (accept(TokenKind::right_brace)) {
            return;
        } else if (accept(Word::texture)) {
            own.texture = layered(own.texture, texture().index);
        } else if (accept(Word::pigment)) {
            own.texture = with_pigment(own.texture == Surface::none ? default_texture_ : own.texture);
        } else if (accept(Word::finish)) {
            own.texture = with_finish(own.texture == Surface::none ? default_texture_ : own.texture);
        } else if (accept(Word::interior)) {
            own.interior = interior(own.interior == Surface::none ? 0 : own.interior).index;
        } else if (accept(Word::material)) {
            const MaterialValue value = material();
            if (value.texture != Surface::none)
                own.texture = layered(own.texture, value.texture);
            if (value.interior != Surface::none)
                own.interior = value.interior;
        } else if (flag_item(own)) {
        } else if (kind == Word::union_ && accept(Word::split_union)) {
            number(); // matters to POV-Ray's bounding boxes alone
        } else if (transform_item(transform)) {
            transform_shape(shape, transform, builder_);
        } else {
            fail_unexpected("texture, pigment, finish, interior, a transform or '}'");
        }
    }
}

/// Reads a word that turns something on or off for the object, if the next token is one.
bool Evaluator::flag_item(Surface& surface) {
    if (accept(Word::no_shadow)) {
        surface.flags |= material_no_shadow;
    } else if (accept(Word::no_image)) {
        surface.flags |= material_no_image;
    } else if (accept(Word::no_reflection)) {
        surface.flags |= material_no_reflection;
    } else if (accept(Word::double_illuminate)) {
        surface.flags |= material_double_illuminate;
    } else if (accept(Word::hollow)) {
        surface.says_hollow = true;
        surface.flags &= ~uint32_t(material_hollow);
        if (optional_flag(true))
            surface.flags |= material_hollow;
    } else {
        return false;
    }
    return true;
}

/// Takes one sphere of the run under the cursor.
void Evaluator::literal_sphere(Shape& shape) {
    const SphereRun& run = program_->runs[peek().index];
    shape.spheres.push_back({run.spheres[run_position_], {}});
    shape.own.texture = literal_texture(run.surfaces[run_position_]);
    if (++run_position_ == run.spheres.size()) {
        run_position_ = 0;
        advance();
    }
}

/// What a literal sphere wears: Surface::none or a texture.
uint32_t Evaluator::literal_texture(uint32_t surface) {
    if (surface == SphereRun::no_surface)
        return Surface::none;
    if (surface & SphereRun::color_flag) {
        PigmentValue value;
        value.pigment.record.color.rgb = program_->colors[surface & ~SphereRun::color_flag];
        std::vector<Layer> layers = builder_.texture(default_texture_);
        layers.back().pigment = builder_.add_pigment(value);
        return builder_.add_texture(layers);
    }
    const Symbol name = surface;
    Binding* binding = scopes_.find(name);
    const TextureRef* texture = binding ? std::get_if<TextureRef>(&binding->value) : nullptr;
    if (texture) {
        binding->used = true;
        return texture->index;
    }
    // A run keeps no places: find the name behind the run's beginning.
    const std::string_view spelled = sources_.symbols.name(name);
    const std::string_view text = sources_.files.text(program_->file);
    Token token = *cursor_;
    size_t at = text.find(spelled, token.offset);
    const auto part_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    while (at != std::string_view::npos && (part_of_name(text[at - 1]) || (at + spelled.size() < text.size() &&
                                                                           part_of_name(text[at + spelled.size()]))))
        at = text.find(spelled, at + 1);
    token.offset = uint32_t(at);
    token.length = uint16_t(spelled.size());
    if (const Refused* refused = binding ? std::get_if<Refused>(&binding->value) : nullptr)
        fail_refused(token, spelled, *refused);
    if (binding)
        fail(token, fmt::format("unexpected '{}', which is {}", spelled, value_description(binding->value)),
             "expected the name of a texture");
    fail_undeclared(token, spelled, "the name of a texture");
}

/// Moves the rest of the run under the cursor into the scene.
void Evaluator::emit_sphere_run() {
    SphereRun& run = program_->runs[cursor_->index];
    SceneProgram& scene = builder_.program();
    uint32_t last = SphereRun::no_surface;
    uint32_t material = builder_.material({}, default_texture_);
    std::unordered_map<uint32_t, uint32_t> named{{last, material}}; // the materials of textures by name
    for (size_t i = run_position_; i < run.spheres.size(); ++i) {
        if (run.surfaces[i] != last) {
            last = run.surfaces[i];
            const auto known = named.find(last);
            material = known != named.end() ? known->second
                                            : builder_.material({.texture = literal_texture(last)}, default_texture_);
            if ((last & SphereRun::color_flag) == 0)
                named.emplace(last, material);
        }
        scene.spheres.push_back(run.spheres[i]);
        scene.sphere_materials.push_back(material);
    }
    run_position_ = 0;
    // Nothing comes back to the scene file's own runs outside of loops.
    if (settings_.last_evaluation && frames_.empty() && loops_.empty())
        run = SphereRun();
    advance();
}

} // namespace proxima
