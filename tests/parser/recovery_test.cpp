// SPDX-License-Identifier: Apache-2.0
// Several mistakes in one scene are reported together, and none that follows from another.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

/// "line:message" of every error.
std::vector<std::string> errors_of(const std::string& text) {
    SourceFiles files;
    files.add_text("scene", text);
    std::vector<std::string> result;
    const Evaluated evaluated = evaluate(text);
    for (const Diagnostic& diagnostic : evaluated.diagnostics.all())
        if (diagnostic.severity == Severity::error)
            result.push_back(std::to_string(files.line_column(diagnostic.place.location).line) + ":" +
                             diagnostic.message);
    return result;
}

using Errors = std::vector<std::string>;

} // namespace

TEST_CASE("recovery: after a mistake the next item is read") {
    CHECK(errors_of("sphere { 0, Big }\nbox { 0, 1 }\nsphere { 0, 1 pigment { color } }\nsphere { 0, 1 }\nfoo") ==
          Errors{"1:'Big' is not declared", "2:Proxima does not support 'box'", "3:unexpected '}'",
                 "5:'foo' is not declared"});
    CHECK(errors_of("union {\n  sphere { 0, A }\n  sphere { 0, B }\n}\nsphere { 0, C }") ==
          Errors{"2:'A' is not declared", "5:'C' is not declared"});
    CHECK(errors_of("#declare A = 1\n#declare B = C;\nsphere { 0, 1 }") ==
          Errors{"1:this #declare lacks its ';'", "2:'C' is not declared"});
}

TEST_CASE("recovery: a name whose declaration is wrong is not reported again") {
    CHECK(errors_of("#declare T = texture { pigment { bozo } }\nsphere { 0, 1 texture { T } }\nsphere { <1, 2, 3>, 1 "
                    "texture { T } }") == Errors{"1:Proxima does not support 'bozo'"});
    CHECK(errors_of("#declare R = 1/0;\nsphere { 0, R }\nsphere { 0, Q }") ==
          Errors{"1:division by zero", "3:'Q' is not declared"});
}

TEST_CASE("recovery: a mistake in a loop is reported once and ends it") {
    CHECK(errors_of("#for (I, 1, 1000)\n  sphere { 0, A }\n  sphere { 0, B }\n#end\nsphere { 0, C }") ==
          Errors{"2:'A' is not declared", "3:'B' is not declared", "5:'C' is not declared"});
    CHECK(errors_of("#declare I = 0;\n#while (I < 5)\n  sphere { I, 1 - I }\n  #declare I = I + 1;\n#end") ==
          Errors{"3:the radius of a sphere must be above 0, this one is 0"});
}

TEST_CASE("recovery: a scene full of mistakes ends") {
    std::string text;
    for (int i = 0; i < 5000; ++i)
        text += "foo { }\n";
    CHECK(evaluate(text).diagnostics.error_count() <= 200);
    CHECK(errors_of("}}}}").size() == 4);
    CHECK(!errors_of("{{{{").empty());
}
