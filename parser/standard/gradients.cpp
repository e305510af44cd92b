// SPDX-License-Identifier: Apache-2.0
// The part of math.inc that takes slopes of functions: differences over a short way along each axis.
#include "parser/standard/texts.h"

namespace proxima::standard {
namespace {

/// The function's value a step ahead along an axis (0 to 2) of the place less that a step behind, in parentheses.
std::string rise(const std::string& function, int axis, const std::string& place = "") {
    const auto call = [&](const char* sign) {
        std::string arguments;
        for (int i = 0; i < 3; ++i)
            arguments += fmt::format("{}{}{}{}", i > 0 ? ", " : "", place, "xyz"[i],
                                     i == axis ? fmt::format(" {} __Gradient_Fn_Accuracy_", sign) : "");
        return fmt::format("{}({})", function, arguments);
    };
    return fmt::format("({} - {})", call("+"), call("-"));
}

} // namespace

std::string gradients() {
    const std::string step = "(2*__Gradient_Fn_Accuracy_)", at = "Place.";
    const std::string flow = fmt::format("({} + {} + {})/{}", rise("F1", 0), rise("F2", 1), rise("F3", 2), step);
    const std::string flow_there =
        fmt::format("({} + {} + {})/{}", rise("F1", 0, at), rise("F2", 1, at), rise("F3", 2, at), step);
    return fmt::format(R"(
#ifndef (__Gradient_Fn_Accuracy_)
  #declare __Gradient_Fn_Accuracy_ = 0.001;
#end
#macro SetGradientAccuracy(Step)
  #declare __Gradient_Fn_Accuracy_ = abs(Step);
#end
#macro fn_Gradient(Fn) function {{ sqrt(pow({0}, 2) + pow({1}, 2) + pow({2}, 2))/{3} }} #end
#macro fn_Gradient_Directional(Fn, Way)
  #local Way_x = vnormalize(Way).x;
  #local Way_y = vnormalize(Way).y;
  #local Way_z = vnormalize(Way).z;
  function {{ ({0}*Way_x + {1}*Way_y + {2}*Way_z)/{3} }}
#end
#macro fn_Divergence(F1, F2, F3) function {{ {4} }} #end
#macro vGradient(Fn, Place) (<{5}, {6}, {7}>/{3}) #end
#macro vCurl(F1, F2, F3, Place) (<{8} - {9}, {10} - {11}, {12} - {13}>/{3}) #end
#macro Divergence(F1, F2, F3, Place) ({14}) #end
#macro Gradient_Length(Fn, Place) vlength(vGradient(Fn, Place)) #end
#macro Gradient_Directional(Fn, Place, Way) vdot(vGradient(Fn, Place), vnormalize(Way)) #end
)",
                       rise("Fn", 0), rise("Fn", 1), rise("Fn", 2), step, flow, rise("Fn", 0, at), rise("Fn", 1, at),
                       rise("Fn", 2, at), rise("F3", 1, at), rise("F2", 2, at), rise("F1", 2, at), rise("F3", 0, at),
                       rise("F2", 0, at), rise("F1", 1, at), flow_there);
}

} // namespace proxima::standard
