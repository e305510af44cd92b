// SPDX-License-Identifier: Apache-2.0
// Small pictures in rows under a heading, with a name before each row, as one PNG.
#pragma once
#include "renderer/image.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace proxima::testing {

/// A picture of linear light, and what is written under it.
struct SheetPicture {
    std::optional<Image> image; ///< none: an empty place
    std::string text;
};

struct SheetRow {
    std::string name;
    std::vector<SheetPicture> pictures;
};

/// Pictures are shown `cell` pixels wide. Throws std::runtime_error when the file cannot be written.
void write_contact_sheet(const std::filesystem::path& file, const std::vector<std::string>& heading,
                         const std::vector<SheetRow>& rows, int cell);

} // namespace proxima::testing
