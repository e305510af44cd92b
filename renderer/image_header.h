// SPDX-License-Identifier: Apache-2.0
// What is written about a picture into its file, in OpenImageIO's words. Part of the image module.
#pragma once
#include "renderer/image_encoder.h"

#include <OpenImageIO/imageio.h>

namespace proxima {

/// A name with the format's ending, by which OpenImageIO finds the writer.
const char* file_name_of(ImageFormat format);

OIIO::TypeDesc file_type(SampleType type);

/// Size, type, how to compress, and the facts as far as the format has a place for them.
OIIO::ImageSpec describe(const EncodeRequest& request);

} // namespace proxima
