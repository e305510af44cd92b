// SPDX-License-Identifier: Apache-2.0
// A number for all that an evaluated scene holds: its arrays and its motion programs, not its text.
#pragma once
#include "parser/scene_program.h"

#include <cstdint>
#include <string>

namespace proxima {

struct Hash128 {
    uint64_t high = 0, low = 0;

    /// 32 hexadecimal digits.
    std::string text() const;
    friend bool operator==(const Hash128&, const Hash128&) = default;
};

/// Equal for equal scenes. What moves counts by its programs, not by where it is in the frame that was evaluated.
/// XXH3 (Collet) of 128 bits: for mistakes, not against malice.
Hash128 hash_scene(const SceneProgram& scene);

Hash128 hash_text(std::string_view text);

} // namespace proxima
