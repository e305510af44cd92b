// SPDX-License-Identifier: Apache-2.0
#include "tests/parser/random_script.h"

#include <fmt/format.h>
#include <utility>

namespace proxima::testing {

std::string RandomScript::constant() {
    switch (below(6)) {
    case 0:
        return std::to_string(below(4));
    case 1:
        return "pi";
    case 2:
        return "rand(R)";
    default:
        return fmt::format("{:.3f}", double(below(4000)) / 1000 - 1);
    }
}

std::string RandomScript::condition() {
    return fmt::format("({}{}{})", number(1), one_of({"<", ">", "<=", ">=", "=", "!="}), number(1));
}

std::string RandomScript::spline() {
    std::string text =
        fmt::format("spline {{ {}", one_of({"linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"}));
    const uint32_t points = 3 + below(5);
    for (uint32_t i = 0; i < points; ++i)
        text += fmt::format("{} {:.3f}, <{}, {}, {}>", i ? "," : "", 0.25 * i - 0.5 + 0.2 * double(below(100)) / 100,
                            constant(), constant(), constant());
    return text + " }";
}

/// Of the parameters A and B, in the grammar that functions have.
std::string RandomScript::function_body(int depth) {
    if (depth <= 0)
        return one_of({"A", "B", "A", "B", "clock", "pi", "0.5", "2"});
    const auto inner = [&] { return function_body(depth - 1); };
    switch (below(7)) {
    case 0:
    case 1:
        return fmt::format("({}{}{})", inner(), one_of({"+", "-", "*"}), inner());
    case 2:
        return fmt::format("{}({})", one_of({"sin", "cos", "tanh", "atan", "abs", "floor", "-"}), inner());
    case 3:
        return fmt::format("{}/(abs({})+0.3)", inner(), inner());
    case 4:
        return fmt::format("select({},{},{},{})", inner(), inner(), inner(), inner());
    case 5:
        return fmt::format("({}{}{} {} {})", inner(), one_of({"<", ">", "<=", ">=", "=", "!="}), inner(),
                           one_of({"&", "|"}), inner());
    default:
        return fmt::format("{}({},{})", one_of({"max", "min"}), inner(), inner());
    }
}

/// Of an array's dimension: a number, or what follows from the variable of the loop around.
std::string RandomScript::index(uint32_t size) {
    if (loop_.empty() || chance(0.3))
        return std::to_string(below(size));
    return fmt::format("mod({}+{}, {})", loop_, below(size), size);
}

std::string RandomScript::element() {
    return chance(0.5) ? fmt::format("D[{}]", index(3)) : fmt::format("E[{}][{}]", index(2), index(3));
}

/// Macros that stand for numbers and vectors, and arrays of numbers, vectors and functions: before anything has a name
/// that a macro's parameter or a function's has.
std::string RandomScript::declarations() {
    std::string text =
        fmt::format("#declare R = seed({});\n#declare S0 = {}\n#declare S1 = {}\n", below(1000), spline(), spline());
    text += fmt::format("#declare F0 = function(A, B) {{ {} }}\n#declare F1 = function(A, B) {{ {} + F0(B, A) }}\n",
                        function_body(3), function_body(2));
    const std::string in_time = fmt::format("{:.3f}*clock", double(below(4000)) / 1000 - 1);
    text += fmt::format("#declare D = array[3] {{ {}, {}, 1 }}\n"
                        "#declare E = array[2][3] {{ {{ 2, {}, {} }}, {{ {}, 0.5, clock }} }}\n"
                        "#declare W = array[2] {{ <{}, 1, {}>, <2, clock, {}> }}\n",
                        in_time, constant(), constant(), in_time, constant(), in_time, constant(), constant());
    text += fmt::format("#declare F2 = function {{ x*D[0] + y*E[1][2] - z*({}) }}\n"
                        "#declare H = array[2] {{ F0, F1 }}\n",
                        in_time);
    return text +
           fmt::format("#macro Mixed(P, Q) ({}*P + clock*Q) #end\n"
                       "#macro Sum(Count, P) (#if (Count > 0) P + Sum(Count - 1, P*0.5 + {}) #else P #end) #end\n"
                       "#macro Beside(P, Q) <P.x, Q, P.z*clock> #end\n"
                       "#macro Raise(P) #declare P = P*0.5 + {}; #end\n",
                       constant(), in_time, in_time);
}

std::string RandomScript::number(int depth) {
    if (depth <= 0 || chance(0.2)) {
        switch (below(8)) {
        case 0:
        case 1:
            return "clock";
        case 2:
            return one_of({"frame_number", "clock_delta"});
        case 3:
            return loop_.empty() ? constant() : loop_;
        case 4:
        case 5:
            return numbers_ > 0 ? name("N", numbers_) : constant();
        case 6:
            return vectors_ > 0 ? name("V", vectors_) + one_of({".x", ".y", ".z"}) : constant();
        default:
            return constant();
        }
    }
    const auto inner = [&] { return number(depth - 1); };
    switch (below(22)) {
    case 0:
    case 1:
    case 2:
        return fmt::format("({}{}{})", inner(), one_of({"+", "-", "*"}), inner());
    case 3: // a zero is possible, and makes the frame the script's
        return chance(0.02) ? fmt::format("({}/{})", inner(), inner())
                            : fmt::format("({}/(abs({})+0.3))", inner(), inner());
    case 4:
        return fmt::format("{}({})", one_of({"sin", "cos", "tanh", "atan", "abs", "floor", "ceil", "int", "sinh"}),
                           inner());
    case 5:
        return fmt::format("{}(abs({})+1)", one_of({"sqrt", "acosh", "ln", "log", "exp", "degrees", "radians"}),
                           inner());
    case 6:
        return fmt::format("{}({},abs({})+0.2)", one_of({"max", "min", "atan2", "mod", "div"}), inner(), inner());
    case 7:
        return fmt::format("pow(abs({})+0.1,{})", inner(), inner());
    case 8:
        return fmt::format("({}?{}:{})", condition(), inner(), inner());
    case 9:
        return fmt::format("select({},{},{},{})", inner(), inner(), inner(), inner());
    case 10:
        return fmt::format("({}{}{})", condition(), one_of({"&", "|"}), condition());
    case 11:
        return fmt::format("vdot({},{})", vector(depth - 1), vector(depth - 1));
    case 12:
        return fmt::format("{}({})", one_of({"-", "!", "+"}), inner());
    case 13:
        return fmt::format("{}({}{}){}", name("S", 2), inner(), one_of({"", ",cubic_spline", ",natural_spline"}),
                           one_of({".x", ".y", ".z"}));
    case 14:
        return fmt::format("{}({},{})", name("F", 2), inner(), inner());
    case 16:
        return element();
    case 17:
        return fmt::format("W[{}]{}", index(2), one_of({".x", ".y", ".z"}));
    case 18:
        return fmt::format("Mixed({}, {})", inner(), inner());
    case 19:
        return fmt::format("Sum({}, {})", below(4), inner());
    case 20:
        return fmt::format("F2({}, {}, {})", inner(), inner(), inner());
    case 21:
        return fmt::format("H[{}]({}, {})", index(2), inner(), inner());
    default:
        return fmt::format("{}{}", one_of({"vlength(", "vlength(2*"}), vector(depth - 1) + ")");
    }
}

std::string RandomScript::vector(int depth) {
    if (depth <= 0 && vectors_ > 0 && chance(0.5))
        return name("V", vectors_);
    switch (depth <= 0 ? 0 : below(11)) {
    case 0:
    case 1:
    case 2:
        return fmt::format("<{},{},{}>", number(depth), number(depth), number(depth));
    case 3:
        return fmt::format("({}{}{})", vector(depth - 1), one_of({"+", "-", "*"}), vector(depth - 1));
    case 4:
        return fmt::format("({}*{})", number(depth), vector(depth - 1));
    case 5:
        return fmt::format("{}({},{})", one_of({"vrotate", "vcross"}), vector(depth - 1), vector(depth - 1));
    case 6:
        return fmt::format("{}({})", name("S", 2), number(depth));
    case 7:
        return fmt::format("vnormalize({}+<0,7,0.1>)", vector(depth - 1));
    case 9:
        return fmt::format("W[{}]", index(2));
    case 10:
        return fmt::format("Beside({}, {})", vector(depth - 1), number(depth - 1));
    default:
        return fmt::format("vaxis_rotate({},{}+<3,0,0>,{})", vector(depth - 1), vector(depth - 1), number(depth));
    }
}

std::string RandomScript::transform() {
    switch (below(8)) {
    case 0:
    case 1:
        return fmt::format(" translate {}", vector(1));
    case 2:
    case 3:
        return fmt::format(" rotate {}*40", vector(1));
    case 4:
        return fmt::format(" scale abs({})+0.5", number(1));
    case 5:
        return fmt::format(" scale <abs({})+0.5,1,2>", number(1));
    case 6:
        return fmt::format(" matrix <1,{},0, 0,1,0, 0,{},1, {},0,2>", number(1), number(0), number(1));
    default:
        return fmt::format(" transform {{ rotate {}*x scale 2 {} }}", number(1), chance(0.5) ? "inverse" : "");
    }
}

std::string RandomScript::color() {
    return fmt::format("{} {}", one_of({"rgb", "color rgb", "srgb"}),
                       chance(0.7) ? vector(1) : fmt::format("<0.5,abs({}),0.2>", number(1)));
}

std::string RandomScript::surface() {
    switch (below(6)) {
    case 0:
        return fmt::format(" pigment {{ {} }}", color());
    case 1:
        return fmt::format(" pigment {{ rgbf <1,{},0,abs({})> }}", number(1), number(1));
    case 2:
        return fmt::format(" pigment {{ checker {} {} {} }}", color(), color(), transform());
    case 3:
        return fmt::format(" finish {{ diffuse {} abs({}) phong {} {} brilliance abs({})+1 reflection {{ {} }} }}",
                           one_of({"", "albedo"}), number(1), one_of({"", "albedo"}), constant(), number(1), color());
    case 4:
        return fmt::format(
            " pigment {{ gradient {}+3*y color_map {{ [0 {}] [0.4+0.1*sin({}) {}] [1 {}] }} phase {} {} }}", vector(1),
            color(), number(1), color(), color(), number(1), transform());
    default:
        return " texture { T }";
    }
}

std::string RandomScript::sphere() {
    std::string text = fmt::format("sphere {{ {}, abs({})+0.01", vector(), number(1));
    for (uint32_t i = below(3); i > 0; --i)
        text += chance(0.5) ? surface() : transform();
    return text + " }";
}

std::string RandomScript::object(int depth) {
    if (depth <= 0 || chance(0.5))
        return sphere();
    std::string text = "union {";
    for (uint32_t i = 1 + below(3); i > 0; --i)
        text += " " + object(depth - 1);
    if (chance(0.4))
        text += fmt::format(" plane {{ {}+y*5, {} }}", vector(1), number(1));
    for (uint32_t i = below(4); i > 0; --i)
        text += chance(0.3) ? surface() : transform();
    return text + " }";
}

std::string RandomScript::statement(bool control, int depth) {
    switch (below(depth > 0 ? 19 : 9)) {
    case 0:
    case 1: {
        const std::string value = number();
        const size_t place = loop_.empty() && numbers_ < 6 ? numbers_++ : numbers_ > 0 ? below(uint32_t(numbers_)) : 99;
        return fmt::format("#declare N{} = {};\n", place, value);
    }
    case 2: {
        const std::string value = vector();
        const size_t place = loop_.empty() && vectors_ < 4 ? vectors_++ : vectors_ > 0 ? below(uint32_t(vectors_)) : 99;
        return fmt::format("#declare V{} = {};\n", place, value);
    }
    case 3:
        return fmt::format("#declare A[{}] = {};\nsphere {{ A[{}]*x, 0.5 }}\n", below(3), number(), below(3));
    case 4:
        return fmt::format("Ball({}, {})\n", vector(), number(1));
    case 5:
        return fmt::format("#declare O = {}\nobject {{ O {} }}\n", object(1), transform());
    case 6:
        return fmt::format("#declare T = texture {{ {} }}\n", fmt::format("pigment {{ {} }}", color()));
    case 7:
        return fmt::format("light_source {{ {}, {} {} }}\n", vector(), color(),
                           one_of({"", "spotlight radius 10+clock falloff 30", "fade_power 2 fade_distance 3+clock",
                                   "parallel point_at <clock,0,0>"}));
    case 8:
    case 9:
        return object(2) + "\n";
    case 10:
    case 11: {
        const std::string outer = std::exchange(loop_, fmt::format("I{}", depth));
        std::string text = fmt::format("#for ({}, 0, {})\n", loop_, 1 + below(3));
        for (uint32_t i = 1 + below(3); i > 0; --i)
            text += statement(control, depth - 1);
        loop_ = outer;
        return text + "#end\n";
    }
    case 12: {
        std::string text = control ? fmt::format("#if {}\n", condition()) : "#if (rand(R) < 0.5)\n";
        return text + object(1) + "\n#else\n" + object(1) + "\n#end\n";
    }
    case 14: {
        const std::string value = number();
        return fmt::format("#declare {} = {};\n", element(), value);
    }
    case 15: {
        const std::string value = vector();
        return fmt::format("#declare W[{}] = {};\n", index(2), value);
    }
    case 16: // changes what it is given
        return numbers_ > 0 && chance(0.5) ? fmt::format("Raise({})\n", name("N", numbers_))
                                           : fmt::format("Raise({})\n", element());
    case 17:
        return fmt::format("Row({}, {})\n", vector(), number(1));
    case 18:
        return fmt::format("sphere {{ W[{}], abs({})+0.1 }}\n", index(2), element());
    default:
        return fmt::format("{}\n", sphere());
    }
}

std::string RandomScript::scene(bool control) {
    numbers_ = vectors_ = 0;
    loop_.clear();
    std::string text = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n" + declarations() +
                       "#declare A = array[3] {clock, 2, 3+clock}\n"
                       "#declare T = texture { pigment { rgb 1 } }\n"
                       "#macro Ball(P, Q) #local L = Q*2; sphere { P, abs(L)+0.1 translate L*y } #end\n"
                       "#macro Row(P, Q) #local L = array[3] { Q, Q*clock, 2 } #for (K, 0, 2) "
                       "sphere { P + K*x*L[K], abs(L[2 - K]) + 0.1 } #end #end\n"
                       "#declare N99 = 1; #declare V99 = x;\n";
    for (int i = 0; i < 8; ++i)
        text += statement(control, 2);
    text += fmt::format("camera {{ location {}+<0,0,-9> look_at {} angle 30+clock {} }}\n", vector(1), vector(1),
                        chance(0.5) ? transform() : "");
    text += fmt::format("background {{ {} }}\n", color());
    if (chance(0.3))
        text += fmt::format("fog {{ distance abs({})+1 {} }}\n", number(1), color());
    return text;
}

} // namespace proxima::testing
