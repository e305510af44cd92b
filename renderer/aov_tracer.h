// SPDX-License-Identifier: Apache-2.0
// Traces the layers beside a film's picture on a backend, and reads them back. A scene with its grid and the film come
// in; what its pixels show goes out.
#pragma once
#include "kernels/aov.h"
#include "kernels/trace.h"
#include "renderer/image.h"

namespace proxima {

template <class Backend, class Real> class AovTracer {
public:
    explicit AovTracer(Backend& backend) : backend_(backend), aovs_(backend) {}

    /// Starts to trace. `features`: those that the film is traced with. `order`: see TraceAovs.
    void trace(const SceneView<Real>& scene, Features features, const FilmView& film, std::span<const uint32_t> order) {
        aovs_.resize(film.pixels.size());
        if (features == Features::opaque)
            run<PathPrecision<Real, Features::opaque>>(scene, film, order);
        else
            run<PathPrecision<Real, Features::all>>(scene, film, order);
    }

    /// Fills the band of the image, which must have been made to fit, that the film is.
    void read(const FilmView& film, Image& image) const { aovs_.download(image.row_of_aovs(film.first_row)); }

    /// Gives back the memory, which grows with the picture.
    void free() { aovs_.free(); }

private:
    template <class Path>
    void run(const SceneView<Real>& scene, const FilmView& film, std::span<const uint32_t> order) {
        backend_.for_each(uint32_t(tiled_pixel_count(film.width, film.height)),
                          TraceAovs<Real, Path>{scene, film, order, aovs_.view()});
    }

    Backend& backend_;
    typename Backend::template Buffer<AovSample> aovs_;
};

} // namespace proxima
