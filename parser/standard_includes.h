// SPDX-License-Identifier: Apache-2.0
// POV-Ray's standard include files, as far as Proxima knows what they declare: the values, without the files.
#pragma once
#include <span>
#include <string_view>

namespace proxima {

struct StandardColor {
    std::string_view name;
    double rgbft[5] = {};
};

enum class StandardInclude {
    unknown,       ///< not a standard file, or one that Proxima cannot do without
    colors,        ///< colors.inc: standard_colors() are its names
    names_unknown, ///< may be included, but none of its names is known
};

StandardInclude standard_include(std::string_view name);

std::span<const StandardColor> standard_colors();

} // namespace proxima
