// SPDX-License-Identifier: Apache-2.0
// LANGUAGE.md beside the parser that it describes.
#include "parser/words.h"

#include <cctype>
#include <doctest/doctest.h>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

using namespace proxima;

TEST_CASE("language reference: it has every word that Proxima understands") {
    std::ostringstream stream;
    stream << std::ifstream(PROXIMA_LANGUAGE_REFERENCE).rdbuf();
    std::set<std::string> described;
    std::string word;
    for (const char c : stream.str() + " ") {
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
            word += c;
        } else {
            described.insert(word);
            word.clear();
        }
    }
    for (size_t i = 0; i < size_t(Word::first_unsupported); ++i) {
        CAPTURE(reserved_words()[i]);
        CHECK(described.contains(std::string(reserved_words()[i])));
    }
}
