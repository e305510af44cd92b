// SPDX-License-Identifier: Apache-2.0
// An OpenColorIO configuration, and what its names mean to us. With color.cpp all that knows OpenColorIO.
#pragma once
#include "renderer/color.h"

#include <OpenColorIO/OpenColorIO.h>
#include <string>
#include <vector>

namespace proxima {

namespace OCIO = OCIO_NAMESPACE;

struct ColorConfig {
    OCIO::ConstConfigRcPtr config;
    std::string name; ///< its file, for messages

    std::vector<std::string> displays() const;
    std::vector<std::string> views(const std::string& display) const;
    std::vector<std::string> looks() const;
    std::vector<std::string> spaces() const;

    /// The colour space, under one of the names that configurations give it, or empty.
    std::string find(WorkingSpace space) const;

    /// What a header says of this space, which may be a display's.
    FileColors file_colors(const std::string& space) const;
};

/// Throws FileError when it cannot be read.
ColorConfig load_color_config(const ColorSettings& settings);

/// Of a working space.
FileColors file_colors(WorkingSpace space);

} // namespace proxima
