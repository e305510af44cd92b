// SPDX-License-Identifier: Apache-2.0
// What an evaluation may cost.
#include "parser/evaluator.h"

namespace proxima {

void Evaluator::charge(uint64_t bytes) {
    (void)bytes;
}

} // namespace proxima
