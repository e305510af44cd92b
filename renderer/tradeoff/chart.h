// SPDX-License-Identifier: Apache-2.0
// Time against error as a picture: every setting a point, the front a line of steps, both axes logarithmic.
#pragma once
#include "renderer/tradeoff/record.h"

namespace proxima {

/// An SVG; a point says what it is when it is pointed at, its bar is from the shortest to the longest repeat.
std::string tradeoff_svg(const TradeoffRecord& record);

} // namespace proxima
