// SPDX-License-Identifier: Apache-2.0
// Antialiasing as POV-Ray does it, on a backend: a function that traces a film comes in, the finished picture goes out.
// Deciding and tracing take turns until no sample is missing.
#pragma once
#include "kernels/antialias.h"
#include "renderer/device_error.h"
#include "renderer/frame_renderer.h"

namespace proxima {

template <class Backend> class Antialiaser {
public:
    explicit Antialiaser(Backend& backend)
        : backend_(backend), coarse_(backend), fine_(backend), marks_(backend), refined_(backend), missing_(backend) {}

    /// Fills `picture`; `trace(film)` sums up the samples of the film that are wanted.
    template <class Trace> void render(const Antialiasing& settings, const FilmView& picture, const Trace& trace) {
        missing_.resize(1);
        if (settings.method == Antialiasing::Method::blocks)
            render_blocks(settings, picture, trace);
        else
            render_squares(settings, picture, trace);
    }

    /// Camera rays of the last picture. Method 2's may count one twice that two pixels asked for at the same time.
    uint64_t camera_rays() const { return camera_rays_; }

    /// Gives the memory back.
    void free() {
        coarse_.free();
        fine_.free();
        marks_.free();
        refined_.free();
    }

private:
    template <class T> using Buffer = typename Backend::template Buffer<T>;
    static_assert(Rows::unit % DecideBlock::side == 0, "a band has whole blocks");

    template <class Trace>
    void render_blocks(const Antialiasing& settings, const FilmView& picture, const Trace& trace) {
        FilmView centers = resized(picture, coarse_, picture.width + 1, picture.height + 1);
        centers.origin = -1;
        trace(centers);
        camera_rays_ = centers.pixels.size();

        FilmView grids = resized(picture, fine_, picture.width, picture.height);
        grids.pattern = SamplePattern::grid;
        grids.grid_side = settings.depth;
        grids.samples = settings.depth * settings.depth;
        grids.marks = cleared_marks(grids);
        refined_.resize(picture.pixels.size());
        const uint32_t across = (picture.width + DecideBlock::side - 1) / DecideBlock::side;
        const uint32_t down = (picture.height + DecideBlock::side - 1) / DecideBlock::side;
        take_turns(
            across * down, grids, trace,
            DecideBlock{picture, centers, grids, refined_.view(), missing_.view(), settings.threshold, settings.depth});
    }

    template <class Trace>
    void render_squares(const Antialiasing& settings, const FilmView& picture, const Trace& trace) {
        const uint32_t levels = settings.depth - 1;
        FilmView lattice = resized(picture, fine_, (picture.width << levels) + 1, (picture.height << levels) + 1);
        lattice.pattern = SamplePattern::corner;
        lattice.step = 1.0f / float(1u << levels);
        lattice.first_row = picture.first_row << levels;
        lattice.marks = cleared_marks(lattice);
        backend_.for_each(uint32_t(lattice.pixels.size()), WantCorners{lattice, (1u << levels) - 1});
        trace(lattice);
        camera_rays_ = uint64_t(picture.width + 1) * (picture.height + 1);
        take_turns(uint32_t(picture.pixels.size()), lattice, trace,
                   DecideSquares{picture, lattice, missing_.view(), settings.threshold, levels});
    }

    template <class Trace, class Decide>
    void take_turns(uint32_t count, const FilmView& film, const Trace& trace, const Decide& decide) {
        for (;;) {
            missing_.fill_bytes(0);
            backend_.for_each(count, decide);
            backend_.synchronize();
            const uint32_t missing = missing_.read(0);
            if (missing == 0)
                return;
            camera_rays_ += uint64_t(missing) * film.samples;
            trace(film);
        }
    }

    FilmView resized(const FilmView& picture, Buffer<glm::vec3>& buffer, uint64_t width, uint64_t height) {
        if (width * height > (1ull << 31))
            throw DeviceError(DeviceError::Kind::out_of_memory,
                              "this picture has too many samples; give --antialias a smaller depth");
        buffer.resize(size_t(width * height));
        FilmView film = picture;
        film.pixels = buffer.view();
        film.width = uint32_t(width);
        film.height = uint32_t(height);
        film.picture_width = picture.columns();
        film.picture_height = picture.rows();
        return film;
    }
    std::span<uint8_t> cleared_marks(const FilmView& film) {
        marks_.resize(film.pixels.size());
        marks_.fill_bytes(sample_unknown);
        return marks_.view();
    }

    Backend& backend_;
    Buffer<glm::vec3> coarse_;
    Buffer<glm::vec3> fine_;
    Buffer<uint8_t> marks_;
    Buffer<uint8_t> refined_;
    Buffer<uint32_t> missing_;
    uint64_t camera_rays_ = 0;
};

} // namespace proxima
