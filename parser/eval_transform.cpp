// SPDX-License-Identifier: Apache-2.0
// translate, rotate, scale, matrix and transform.
#include "parser/evaluator.h"

#include <cmath>

namespace proxima {

/// Reads one transform, if the next token begins one, and appends it to `result`.
bool Evaluator::transform_item(Transform& result) {
    const Token& token = peek();
    if (accept(Word::translate)) {
        const Terms terms = vector_of(3, "a vector");
        result = then(result, terms.nodes ? Transform(translation(terms.varying_vector()))
                                          : Transform(translation(terms.vector())));
    } else if (accept(Word::rotate)) {
        const Terms terms = vector_of(3, "a vector");
        result = then(result,
                      terms.nodes ? Transform(rotation(terms.varying_vector())) : Transform(rotation(terms.vector())));
    } else if (accept(Word::scale)) {
        result = then(result, scale_item(token));
    } else if (accept(Word::matrix)) {
        const Affine<Varying> map = matrix();
        const double determinant = glm::determinant(value_of(map).linear);
        if (!std::isfinite(determinant) || determinant == 0)
            fail(token, "this matrix squeezes space flat: it has no inverse");
        Transform transform(from_matrix(map));
        transform.keeps_spheres = false;
        result = then(result, transform);
    } else if (accept(Word::transform)) {
        if (const TransformRef* declared = identifier<TransformRef>()) {
            result = then(result, **declared);
            advance();
        } else {
            result = then(result, transform_block());
        }
    } else {
        return false;
    }
    return true;
}

/// `scale` behind its word.
Transform Evaluator::scale_item(const Token& token) {
    const Terms terms = vector_of(3, "a vector");
    Vec3<Varying> factors = terms.varying_vector();
    for (int i = 0; i < 3; ++i) {
        if (!decide(apply(MotionOp::is_zero, factors[i])))
            continue;
        warn(token, "a scale of 0 is taken as 1");
        factors[i] = 1.0;
    }
    if (!terms.nodes) {
        Transform transform(scaling(value_of(factors)));
        transform.keeps_spheres = factors.x.value == factors.y.value && factors.x.value == factors.z.value;
        return transform;
    }
    Transform transform(scaling(factors));
    transform.keeps_spheres = factors.x.node == factors.y.node && factors.x.node == factors.z.node;
    return transform;
}

Transform Evaluator::transform_block() {
    expect(TokenKind::left_brace);
    Transform result;
    bool inverted = false;
    for (;;) {
        if (const TransformRef* declared = identifier<TransformRef>()) {
            result = then(result, **declared);
            advance();
        } else if (accept(Word::inverse)) {
            inverted = true;
        } else if (!transform_item(result)) {
            break;
        }
    }
    expect(TokenKind::right_brace);
    return inverted ? inverse_of(result) : result;
}

/// Twelve numbers: where x, y, z and the origin go.
Affine<Varying> Evaluator::matrix() {
    expect(TokenKind::left_angle);
    Affine<Varying> map;
    for (int row = 0; row < 4; ++row) {
        Vec3<Varying> image;
        for (int i = 0; i < 3; ++i) {
            const Token& at = peek();
            image[i] = checked(at, moving_number());
            if (row < 3 || i < 2)
                accept(TokenKind::comma);
        }
        if (row < 3)
            map.linear[row] = image;
        else
            map.offset = image;
    }
    expect(TokenKind::right_angle);
    return map;
}

} // namespace proxima
