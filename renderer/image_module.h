// SPDX-License-Identifier: Apache-2.0
// What stands between the program and OpenImageIO, which brings 260 libraries with it: they cost a quarter of a second
// and 130 MB to load. They stay in a module of their own (image_encoder.cpp, image_decoder.cpp) that is loaded when the
// first picture is read, or the first that is not a PNG written.
#pragma once

namespace proxima {

inline constexpr const char image_module[] = "libproxima_image_codec.so";

/// The address of one of the module's functions. The first call loads the module, from the program's folder, an
/// installation's, or the library path. Throws FileError.
void* image_module_symbol(const char* name);

template <class Function> Function* image_module_function(const char* name) {
    return reinterpret_cast<Function*>(image_module_symbol(name));
}

} // namespace proxima
