// SPDX-License-Identifier: Apache-2.0
// Builds the cloud over a frame's grid on a device: the occupied bricks first, since only they get voxels, and the
// distances of the others, which can wait until the lists are made. Nothing here waits for the device.
#pragma once
#include "kernels/cloud_build.h"
#include "kernels/grid_build.h"

namespace proxima {

template <class Backend, class Real> class CloudBuilder {
public:
    explicit CloudBuilder(Backend& backend)
        : backend_(backend), marks_(backend),
          ranks_(backend), maps_{Buffer<uint8_t>(backend), Buffer<uint8_t>(backend)}, total_(backend),
          seen_total_(backend) {}

    /// Adds the cloud to scene.grid, which knows its size and has the memory of its lists' heads. The distances are 0
    /// and, for all empty bricks, 255.
    void mark(SceneView<Real>& scene, Metric metric, std::span<GridCounts> counts) {
        CloudView& cloud = scene.grid.cloud;
        cloud.metric = metric;
        marks_.resize(cloud.brick_count());
        marks_.fill_bytes(0xff);
        ranks_.resize(cloud.brick_count());
        ranks_.fill_bytes(0xff); // MarkBricks::no_rank
        cloud.distances = marks_.view();
        cloud.ranks = ranks_.view();
        backend_.for_each(scene.geometry.round_count(),
                          MarkBricks<Real>{scene.grid, scene.geometry, counts, marks_.view()});
    }

    /// Measures the distances: a pass along each axis.
    void measure(CloudView& cloud) {
        DistancePass pass{.cloud = cloud, .occupied = marks_.view()};
        pass.in = marks_.view();
        for (pass.axis = 0; pass.axis < 3; ++pass.axis) {
            Buffer<uint8_t>& out = maps_[pass.axis % 2];
            out.resize(size_t(pass.maps()) * cloud.brick_count());
            pass.out = out.view();
            backend_.for_each(pass.item_count(), pass);
            pass.in = pass.out;
        }
        cloud.distances = pass.out;
        total_.resize(1);
        backend_.reduce_into(total_, uint32_t(pass.out.size()), MeasureDistances{pass.out});
        seen_total_.request(total_);
    }

    /// Over the empty bricks, as measured last; 0 when there are none. After a synchronize().
    double mean_distance() const {
        const DistanceTotal& total = seen_total_.value();
        return total.empty ? double(total.sum) / double(total.empty) : 0.0;
    }
    uint64_t bytes() const { return marks_.bytes() + ranks_.bytes() + maps_[0].bytes() + maps_[1].bytes(); }

private:
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    Backend& backend_;
    Buffer<uint8_t> marks_; ///< 0 where a brick is occupied, else 255
    Buffer<uint32_t> ranks_;
    Buffer<uint8_t> maps_[2];
    Buffer<DistanceTotal> total_;
    typename Backend::template Receipt<DistanceTotal> seen_total_;
};

} // namespace proxima
