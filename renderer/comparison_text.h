// SPDX-License-Identifier: Apache-2.0
// A compared pair as `proxima compare` prints it.
#pragma once
#include "renderer/comparison.h"

#include <string>

namespace proxima {

/// The figures of a pair that has them, a line each.
std::string full_text(const PairRecord& pair, double tolerance);

/// One line, for a pair among others.
std::string short_text(const PairRecord& pair);

} // namespace proxima
