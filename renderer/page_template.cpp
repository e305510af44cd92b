// SPDX-License-Identifier: Apache-2.0
#include "renderer/page_template.h"

namespace proxima {

std::string fill_page(std::string page, std::string_view place, std::string json) {
    for (size_t at = 0; (at = json.find('<', at)) != std::string::npos;)
        json.replace(at, 1, "\\u003c");
    return page.replace(page.find(place), place.size(), json);
}

} // namespace proxima
