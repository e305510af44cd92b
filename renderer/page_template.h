// SPDX-License-Identifier: Apache-2.0
// A page that is inside the program, with a place for data.
#pragma once
#include <string>
#include <string_view>

namespace proxima {

/// The page with `json` in place of `place`, where a script reads it; no name in it can end the script.
std::string fill_page(std::string page, std::string_view place, std::string json);

} // namespace proxima
