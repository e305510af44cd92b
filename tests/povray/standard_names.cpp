// SPDX-License-Identifier: Apache-2.0
#include "tests/povray/standard_names.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace proxima::testing {

std::vector<StandardName> standard_names(const std::filesystem::path& path) {
    std::ostringstream stream;
    stream << std::ifstream(path, std::ios::binary).rdbuf();
    const std::string text = stream.str();

    // Comments and strings are taken whole, so that nothing in them counts.
    const std::regex token(R"(//[^\n]*|/\*[^*]*\*+([^/*][^*]*\*+)*/|"[^"\n]*"|#[ \t]*([a-z]+)|[A-Za-z_]\w*)");
    std::vector<StandardName> names;
    std::vector<std::string> blocks;
    std::string declaring;
    bool declared_last = false; ///< the piece before this one was the name of a #declare
    for (std::sregex_iterator at(text.begin(), text.end(), token), end; at != end; ++at) {
        const std::string directive = (*at)[2].str(), piece = at->str();
        if (piece[0] == '/' || piece[0] == '"')
            continue;
        if (!directive.empty()) {
            const bool in_macro = std::find(blocks.begin(), blocks.end(), "macro") != blocks.end();
            declaring =
                !in_macro && (directive == "declare" || directive == "macro" || directive == "undef") ? directive : "";
            if (directive == "end" && !blocks.empty())
                blocks.pop_back();
            else if (directive.starts_with("if") || directive == "switch" || directive == "while" ||
                     directive == "for" || directive == "macro")
                blocks.push_back(directive);
        } else if (piece == "function" && declared_last) {
            names.back().is_called = true;
            declared_last = false;
        } else if (!declaring.empty() && piece != "deprecated" && piece != "once") {
            std::erase_if(names, [&](const StandardName& known) { return known.name == piece; });
            if (declaring != "undef")
                names.push_back({piece, declaring == "macro"});
            declared_last = declaring == "declare";
            declaring.clear();
        } else {
            declared_last = false;
        }
    }
    return names;
}

} // namespace proxima::testing
