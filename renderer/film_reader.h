// SPDX-License-Identifier: Apache-2.0
// A finished film on a device in, its band of the image on the host out: as floats, or as half-floats made on the
// device, which are half as much to copy.
#pragma once
#include "kernels/film.h"
#include "kernels/half.h"
#include "renderer/frame_renderer.h"

namespace proxima {

template <class Backend> class FilmReader {
public:
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    explicit FilmReader(Backend& backend) : backend_(backend), halves_(backend), repairs_(backend) {}

    /// Fills the band of the image that the film is.
    void read(Buffer<glm::vec3>& pixels, const FilmView& film, const FrameSettings& settings, Image& image,
              FrameStatistics& statistics) {
        static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
        image.fit(film.columns(), film.rows(), settings.in_halves, settings.aovs.any());
        if (!settings.in_halves)
            return pixels.download(reinterpret_cast<glm::vec3*>(image.row(film.first_row)));
        const std::span<const float> samples(&film.pixels.data()->x, film.pixels.size() * 3);
        halves_.resize(samples.size());
        repairs_.resize(1);
        repairs_.fill_bytes(0);
        backend_.for_each(uint32_t(samples.size()), HalveSamples{samples, halves_.view(), repairs_.view()});
        halves_.download(image.row_of_halves(film.first_row));
        const SampleRepairs repairs = repairs_.read(0);
        statistics.replaced_samples = repairs.replaced;
        statistics.clamped_samples = repairs.clamped;
    }

    /// Gives back the memory that grows with the picture.
    void free() { halves_.free(); }

private:
    Backend& backend_;
    Buffer<uint16_t> halves_;
    Buffer<SampleRepairs> repairs_;
};

} // namespace proxima
