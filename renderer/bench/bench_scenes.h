// SPDX-License-Identifier: Apache-2.0
// The scenes of the experiments: tests/bench/scenes, which the program carries in itself, with any number of spheres.
#pragma once
#include "parser/scene_program.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace proxima {

class BenchScenes {
public:
    /// Writes the scene files into `folder`, which is made. Throws FileError.
    explicit BenchScenes(const std::filesystem::path& folder);

    /// The scene of that name with `spheres` spheres, all of which move. It is kept until another one is asked for.
    /// Throws FileError and SceneRejected.
    std::shared_ptr<const SceneProgram> load(const std::string& name, uint64_t spheres, uint32_t width,
                                             uint32_t height);

private:
    std::filesystem::path folder_;
    std::string loaded_; ///< what `program_` is
    std::shared_ptr<const SceneProgram> program_;
};

} // namespace proxima
