// SPDX-License-Identifier: Apache-2.0
// Builds the cloud over a frame's grid on a device: the occupied bricks first, since only they get voxels, and the
// distances of the others, which can wait until the lists are made. Nothing here waits for the device.
#pragma once
#include "kernels/cloud_build.h"
#include "kernels/grid_build.h"

#include <algorithm>

namespace proxima {

template <class Backend, class Real> class CloudBuilder {
public:
    explicit CloudBuilder(Backend& backend)
        : backend_(backend), marks_(backend),
          ranks_(backend), maps_{Buffer<uint8_t>(backend), Buffer<uint8_t>(backend)}, total_(backend),
          seen_total_(backend) {}

    /// Adds the cloud to scene.grid, which knows its size and has the memory of its lists' heads. There are no
    /// distances yet.
    void mark(SceneView<Real>& scene, Metric metric, std::span<GridCounts> counts) {
        CloudView& cloud = scene.grid.cloud;
        cloud.metric = metric;
        clear_marks(cloud);
        ranks_.resize(cloud.brick_count());
        ranks_.fill_bytes(0xff); // MarkBricks::no_rank
        cloud.ranks = ranks_.view();
        backend_.for_each(scene.geometry.round_count(),
                          MarkBricks<Real>{scene.grid, scene.geometry, counts, marks_of(cloud)});
    }

    /// The same for distances alone: its bricks get no ranks, and there need not be lists.
    void mark_planned(SceneView<Real>& scene, Metric metric) {
        CloudView& cloud = scene.grid.cloud;
        cloud.metric = metric;
        clear_marks(cloud);
        backend_.for_each(scene.geometry.round_count(),
                          MarkPlannedBricks<Real>{scene.grid, scene.geometry, marks_of(cloud)});
    }

    /// Measures the distances: a pass along each axis.
    void measure(CloudView& cloud) {
        total_.resize(1);
        total_.fill_bytes(0);
        DistancePass pass{.cloud = cloud, .marks = marks_of(cloud), .total = total_.view()};
        pass.piece = int32_t(std::clamp<uint32_t>(cloud.brick_count() / pieces_wanted, 4, 4096));
        if (RowDistances<16>::fits(cloud))
            measure_rows<16>(pass);
        else
            measure_rows<1>(pass);
        for (pass.axis = 1; pass.axis < 3; ++pass.axis) {
            pass.in = pass.out;
            pass.out = room_for(pass);
            backend_.for_each(pass.item_count(), pass);
        }
        cloud.distances = pass.out;
        seen_total_.request(total_);
    }

    /// Over the empty bricks, as measured last; 0 when there are none. After a synchronize().
    double mean_distance() const {
        const DistanceTotal& total = seen_total_.value();
        return total.empty ? double(total.sum) / double(total.empty) : 0.0;
    }
    /// Those that it is the mean of.
    uint64_t empty_bricks() const { return seen_total_.value().empty; }
    uint64_t bytes() const { return marks_.bytes() + ranks_.bytes() + maps_[0].bytes() + maps_[1].bytes(); }

private:
    static constexpr uint32_t pieces_wanted = 1u << 18; ///< of all lines: as many as a large device has threads
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    void clear_marks(const CloudView& cloud) {
        marks_.resize(BrickMarks::word_count(cloud.size));
        marks_.fill_bytes(0);
    }
    BrickMarks marks_of(const CloudView& cloud) { return {marks_.view(), BrickMarks::row_words(cloud.size)}; }
    std::span<uint8_t> room_for(const DistancePass& pass) {
        Buffer<uint8_t>& out = maps_[pass.axis % 2];
        out.resize(size_t(pass.maps()) * pass.cloud.brick_count());
        return out.view();
    }
    template <int32_t group> void measure_rows(DistancePass& pass) {
        pass.axis = 0;
        RowDistances<group> rows{pass.cloud, pass.marks, pass.out = room_for(pass)};
        backend_.for_each(rows.item_count(), rows);
    }

    Backend& backend_;
    Buffer<uint32_t> marks_; ///< of BrickMarks
    Buffer<uint32_t> ranks_;
    Buffer<uint8_t> maps_[2];
    Buffer<DistanceTotal> total_;
    typename Backend::template Receipt<DistanceTotal> seen_total_;
};

} // namespace proxima
