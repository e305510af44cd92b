// SPDX-License-Identifier: Apache-2.0
// translate, rotate, scale, matrix and transform.
#include "parser/evaluator.h"

namespace proxima {

/// Reads one transform, if the next token begins one, and appends it to `result`.
bool Evaluator::transform_item(TransformPair& result) {
    const Token& token = peek();
    if (accept(Word::translate)) {
        result = then(result, translation(vector()));
    } else if (accept(Word::rotate)) {
        result = then(result, rotation(vector()));
    } else if (accept(Word::scale)) {
        Vec3<double> factors = vector();
        for (int i = 0; i < 3; ++i) {
            if (factors[i] != 0)
                continue;
            warn(token, "a scale of 0 is taken as 1");
            factors[i] = 1;
        }
        result = then(result, scaling(factors));
    } else if (accept(Word::matrix)) {
        bool invertible = false;
        const TransformPair map = from_matrix(matrix(), invertible);
        if (!invertible)
            fail(token, "this matrix squeezes space flat: it has no inverse");
        result = then(result, map);
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

TransformPair Evaluator::transform_block() {
    expect(TokenKind::left_brace);
    TransformPair result;
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
Affine<double> Evaluator::matrix() {
    expect(TokenKind::left_angle);
    Affine<double> map;
    for (int row = 0; row < 4; ++row) {
        Vec3<double> image;
        for (int i = 0; i < 3; ++i) {
            const Token& at = peek();
            image[i] = checked(at, number());
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
