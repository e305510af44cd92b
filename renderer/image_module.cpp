// SPDX-License-Identifier: Apache-2.0
#include "renderer/image_module.h"
#include "parser/source_files.h"

#include <dlfcn.h>
#include <filesystem>
#include <fmt/format.h>

namespace proxima {
namespace {

/// Libraries deep below OpenImageIO. The loader looks for each of 150,000 symbols in every library of what is being
/// opened together, so opening these on their own first nearly halves the time (0.25 s to 0.14 s). One that has another
/// version is passed over.
constexpr const char* opened_first[] = {"libdcmdata.so.17", "libopencv_imgcodecs.so.406", "libopenvdb.so.10.0"};

[[noreturn]] void fail() {
    const char* reason = ::dlerror();
    throw FileError(fmt::format("the image module cannot be loaded: {}; it belongs beside the program",
                                reason ? reason : "it is not one"));
}

/// The module beside the program, where an installation puts it, or on the library path.
void* open_module() {
    for (const char* library : opened_first)
        ::dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    std::filesystem::path found = image_module;
    for (const auto& path : {folder / "../lib/proxima" / image_module, folder / image_module})
        if (std::filesystem::exists(path))
            found = path;
    void* const module = ::dlopen(found.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (!module)
        fail();
    return module;
}

} // namespace

void* image_module_symbol(const char* name) {
    static void* const module = open_module();
    void* const symbol = ::dlsym(module, name);
    if (!symbol)
        fail();
    return symbol;
}

} // namespace proxima
