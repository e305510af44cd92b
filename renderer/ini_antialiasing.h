// SPDX-License-Identifier: Apache-2.0
// The antialiasing of a POV-Ray .ini file: its settings in, the text of our --antialias out.
#pragma once
#include <string>
#include <string_view>

namespace proxima {

class IniAntialiasing {
public:
    /// Takes one of its settings. False if `name` is none of them.
    bool set(std::string_view name, std::string_view value);

    /// What --antialias takes; empty when antialiasing is off. Throws UsageError, which begins with the setting, for
    /// what Proxima does otherwise than POV-Ray would.
    std::string option() const;

private:
    bool on_ = false, jitter_ = true;
    std::string threshold_ = "0.3", depth_ = "3", method_ = "1", jitter_amount_ = "1", gamma_ = "2.5";
};

} // namespace proxima
