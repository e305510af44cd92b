// SPDX-License-Identifier: Apache-2.0
// Builds the cloud over a frame's grid on a device: the occupied bricks first, since only they get voxels, and the
// distances of the others, which can wait until the lists are made.
#pragma once
#include "kernels/cloud_build.h"
#include "kernels/grid_build.h"

namespace proxima {

template <class Backend, class Real> class CloudBuilder {
public:
    explicit CloudBuilder(Backend& backend)
        : backend_(backend), marks_(backend),
          ranks_(backend), maps_{Buffer<uint8_t>(backend), Buffer<uint8_t>(backend)} {}

    /// The cloud over scene.grid, which knows its size. Its distances are 0 and, for all empty bricks, 255.
    CloudView mark(const SceneView<Real>& scene, Metric metric) {
        CloudView cloud = scene.grid.cloud;
        cloud.metric = metric;
        const uint32_t bricks = cloud.brick_count();
        marks_.resize(bricks);
        marks_.fill_bytes(255);
        backend_.for_each(scene.geometry.round_count(),
                          MarkBricks<Real>{brick_grid(scene.grid), scene.geometry, marks_.view()});
        ranks_.resize(size_t(bricks) + 1); // the last one becomes the number of occupied bricks
        backend_.for_each(bricks + 1, CountBricks{marks_.view(), ranks_.view()});
        backend_.exclusive_scan(ranks_.view());
        occupied_ = ranks_.read(bricks);
        cloud.distances = marks_.view();
        cloud.ranks = ranks_.view();
        return cloud;
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
        total_ = backend_.template reduce<DistanceTotal>(uint32_t(pass.out.size()), MeasureDistances{pass.out});
    }

    uint32_t occupied() const { return occupied_; }
    /// Over the empty bricks; 0 when there are none.
    double mean_distance() const { return total_.empty ? double(total_.sum) / double(total_.empty) : 0.0; }
    uint64_t bytes() const { return marks_.bytes() + ranks_.bytes() + maps_[0].bytes() + maps_[1].bytes(); }

private:
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    Backend& backend_;
    Buffer<uint8_t> marks_; ///< 0 where a brick is occupied, else 255
    Buffer<uint32_t> ranks_;
    Buffer<uint8_t> maps_[2];
    uint32_t occupied_ = 0;
    DistanceTotal total_;
};

} // namespace proxima
