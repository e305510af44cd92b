// SPDX-License-Identifier: Apache-2.0
// Traces a film on a backend: by the smallest kernels that do all that the scene has, as many pixels at a time as there
// is memory for. A scene with its grid and a film come in; the film's sums of samples go out.
#pragma once
#include "kernels/first_hit_tile.h"
#include "renderer/antialiaser.h"
#include "renderer/device_error.h"
#include "renderer/frame_renderer.h"
#include "renderer/scene_needs.h"

#include <algorithm>
#include <string>

namespace proxima {

template <class Backend, class Real> class FilmTracer {
public:
    explicit FilmTracer(Backend& backend)
        : backend_(backend), antialiaser_(backend), pending_states_(backend), pending_interiors_(backend),
          overflows_(backend) {}

    /// Starts to trace; pictures with several waves of pixels are waited for, and end by FrameCancelled.
    void trace(const SceneView<Real>& scene, const SceneNeeds& needs, const FilmView& film,
               const Antialiasing& antialiasing) {
        needs_ = needs;
        const auto trace_film = [&](const FilmView& part) { trace_pixels(scene, part); };
        const bool looks_closer =
            antialiasing.method == Antialiasing::Method::blocks || antialiasing.method == Antialiasing::Method::squares;
        if (looks_closer)
            antialiaser_.render(antialiasing, film, trace_film);
        else
            trace_film(film);
        camera_rays_ = looks_closer ? antialiaser_.camera_rays() : uint64_t(film.pixels.size()) * film.samples;
    }

    /// Of the last film: see Antialiaser.
    uint64_t camera_rays() const { return camera_rays_; }

    /// Gives back the memory that grows with the picture.
    void free() {
        antialiaser_.free();
        pending_states_.free();
        pending_interiors_.free();
    }

private:
    static constexpr uint32_t most_tiles = 1u << 20; ///< traced at a time: whose indices of pixels fit in 32 bits
    template <class T> using Buffer = typename Backend::template Buffer<T>;
    using WaitingPrecision = PathPrecision<Real, Features::all>;
    using WaitingPath = PathState<Real, WaitingPrecision>;

    void trace_pixels(const SceneView<Real>& scene, const FilmView& film) {
        trace_features(scene, film);
        check_overflow();
    }

    void trace_features(const SceneView<Real>& scene, const FilmView& film) {
        switch (needs_.features) {
        case Features::opaque:
            if constexpr (sizeof(Real) == sizeof(float))
                if (scene.lights.size() <= FirstHitPass<Real>::most_lights)
                    return scene.geometry.ellipsoids.empty() ? trace_first_hits<RoundShapes::spheres>(scene, film)
                                                             : trace_first_hits<RoundShapes::all>(scene, film);
            return trace_waves<Features::opaque>(scene, film);
        case Features::mirrors:
            return trace_waves<Features::mirrors>(scene, film);
        case Features::furnished:
            return trace_waves<Features::furnished>(scene, film);
        case Features::all:
            return trace_waves<Features::all>(scene, film);
        }
    }

    /// By the kernel that knows no more ways through the grid than it needs, where that is worth one of its own.
    template <Features features> void trace_waves(const SceneView<Real>& scene, const FilmView& film) {
        if constexpr (features != Features::all && sizeof(Real) == sizeof(float))
            if (scene.geometry.ellipsoids.empty())
                switch (ways_of(scene.grid)) {
                case Ways::steps:
                    return trace_waves<features, RoundShapes::spheres, Ways::steps>(scene, film);
                case Ways::leaps:
                    return trace_waves<features, RoundShapes::spheres, Ways::leaps>(scene, film);
                case Ways::any:
                    break;
                }
        trace_waves<features, RoundShapes::all, Ways::any>(scene, film);
    }
    /// Traces as many pixels at a time as there is memory for stacks.
    template <Features features, RoundShapes shapes, Ways ways>
    void trace_waves(const SceneView<Real>& scene, const FilmView& film) {
        const uint64_t pixels = tiled_pixel_count(film.width, film.height);
        const uint32_t wave = wave_size(pixels, film.samples);
        PendingView<Real, PathPrecision<Real, features>> pending;
        if constexpr (features == Features::all)
            pending = make_pending(wave);
        for (uint64_t first = 0; first < pixels; first += wave) {
            backend_.for_each(uint32_t(std::min<uint64_t>(wave, pixels - first)),
                              TracePixels<Real, features, shapes, ways>{scene, film, pending, first});
            if (wave < pixels)
                wait();
        }
    }

    /// The same for scenes whose paths end at their first surface.
    template <RoundShapes shapes> void trace_first_hits(const SceneView<Real>& scene, const FilmView& film) {
        if constexpr (Backend::traces_packets && shapes == RoundShapes::spheres)
            if (scene.grid.in_use() && !scene.grid.cloud.in_use())
                return trace_tiles(scene, film);
        if constexpr (shapes == RoundShapes::spheres)
            switch (ways_of(scene.grid)) {
            case Ways::steps:
                return trace_first_hits<shapes, Ways::steps>(scene, film);
            case Ways::leaps:
                return trace_first_hits<shapes, Ways::leaps>(scene, film);
            case Ways::any:
                break;
            }
        trace_first_hits<shapes, Ways::any>(scene, film);
    }
    template <RoundShapes shapes, Ways ways> void trace_first_hits(const SceneView<Real>& scene, const FilmView& film) {
        const uint64_t pixels = tiled_pixel_count(film.width, film.height);
        const uint32_t wave = wave_size(pixels, 1);
        FirstHitPass<Real> pass{scene, film};
        for (; pass.first < pixels; pass.first += wave) {
            const uint32_t count = uint32_t(std::min<uint64_t>(wave, pixels - pass.first));
            for (pass.sample = 0; pass.sample < film.samples; ++pass.sample)
                backend_.for_each(count, TraceFirstHits<Real, shapes, ways>{pass});
            if (wave < pixels)
                wait();
        }
    }

    /// The same where rays go as packets.
    void trace_tiles(const SceneView<Real>& scene, const FilmView& film) {
        using Tile = TraceFirstHitTile<Real>;
        const uint64_t tiles = tiled_pixel_count(film.width, film.height) / Tile::lanes;
        FirstHitPass<Real> pass{scene, film};
        for (uint64_t first = 0; first < tiles; first += most_tiles) {
            pass.first = first * Tile::lanes;
            const uint32_t count = uint32_t(std::min<uint64_t>(most_tiles, tiles - first));
            for (pass.sample = 0; pass.sample < film.samples; ++pass.sample)
                backend_.for_each_packet(count, Tile{pass});
            wait();
        }
    }

    uint32_t wave_size(uint64_t pixels, uint32_t samples) const {
        const uint64_t most = std::max<uint64_t>((1u << 30) / samples, 1u << 18); // a wave can be waited for
        if (needs_.stack_entries == 0)
            return uint32_t(std::min(pixels, most));
        const uint64_t entry = sizeof(WaitingPath) + sizeof(uint32_t) * needs_.interior_capacity;
        const uint64_t stack = entry * needs_.stack_entries;
        const uint64_t memory = std::min(Backend::stack_memory, backend_.available_memory() / 4);
        const uint64_t fitting = std::max<uint64_t>(memory / stack / 1024 * 1024, 1024);
        return uint32_t(std::min({pixels, fitting, most}));
    }

    PendingView<Real, WaitingPrecision> make_pending(uint32_t threads) {
        pending_states_.resize(size_t(threads) * needs_.stack_entries);
        pending_interiors_.resize(size_t(threads) * needs_.stack_entries * needs_.interior_capacity);
        overflows_.resize(1);
        overflows_.fill_bytes(0);
        return {.states = pending_states_.view(),
                .interiors = pending_interiors_.view(),
                .overflows = overflows_.view(),
                .interior_capacity = needs_.interior_capacity,
                .threads = threads};
    }

    void check_overflow() {
        if (needs_.features == Features::all && overflows_.read(0) > 0)
            throw DeviceError(DeviceError::Kind::scene, "a ray is inside more than " +
                                                            std::to_string(InteriorList::capacity) +
                                                            " transparent objects at once, which is the limit");
    }

    void wait() {
        backend_.synchronize();
        if (backend_.is_cancelled())
            throw FrameCancelled();
    }

    Backend& backend_;
    SceneNeeds needs_; ///< of the scene that is being traced
    uint64_t camera_rays_ = 0;
    Antialiaser<Backend> antialiaser_;
    Buffer<WaitingPath> pending_states_;
    Buffer<uint32_t> pending_interiors_;
    Buffer<uint32_t> overflows_;
};

} // namespace proxima
