// SPDX-License-Identifier: Apache-2.0
// The options that say in which colours a picture is written.
#pragma once
#include "renderer/shared_options.h"

#include <string>

namespace proxima {

struct ColorTexts {
    std::string ocio, display, view, look, space, working_space = "rec709";
    bool list = false, dither = false;
};

void add_color_options(CLI::App& command, ColorTexts& texts);

/// For a file of this sample type, or `with_view`, for something that is shown. Throws UsageError.
ColorSettings read_color_options(const ColorTexts& texts, SampleType type, bool with_view);

} // namespace proxima
