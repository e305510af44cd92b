// SPDX-License-Identifier: Apache-2.0
// The baselines of the experiments on every backend: what they make is what the renderer makes.
#pragma once
#include "kernels/cloud_build.h"
#include "renderer/bench/paper_renderer.h"
#include "tests/kernels/backend_tests.h"

TEST_CASE_TEMPLATE("baseline: pair by pair the map has the bytes that it has pass by pass", Backend, BACKENDS) {
    Backend backend;
    std::mt19937 engine(11);
    for (const uint32_t one_in : {2u, 30u, 500u, 4000u}) {
        baselines::PaperGridView paper;
        const Vec3<int32_t> size(int32_t(engine() % 20) + 1, int32_t(engine() % 20) + 1, int32_t(engine() % 300) + 1);
        paper.grid = make_grid<float>({Vec3<float>(0.0f), Vec3<float>(1.0f)}, size);
        paper.capacity = 2;
        const uint32_t voxels = paper.grid.cell_count();
        CAPTURE(one_in);
        CAPTURE(voxels);
        typename Backend::template Buffer<uint32_t> words(backend), filled(backend), count(backend), far(backend);
        typename Backend::template Buffer<uint32_t> marks(backend);
        typename Backend::template Buffer<uint8_t> map(backend), passed(backend), between(backend);
        typename Backend::template Buffer<DistanceTotal> total(backend);
        words.resize(size_t(voxels) * paper.stride());
        paper.words = words.view();
        backend.for_each(uint32_t(size.x * size.y), baselines::ClearPaperVoxels{paper});
        std::vector<uint32_t> filled_words(words.size());
        words.download(filled_words.data());
        std::vector<uint32_t> occupied(BrickMarks::word_count(size));
        const BrickMarks occupied_bits{occupied, BrickMarks::row_words(size)};
        for (uint32_t voxel = 0; voxel < voxels; ++voxel)
            if (engine() % one_in == 0) {
                filled_words[size_t(voxel) * paper.stride()] = 1;
                occupied_bits.set(voxel / uint32_t(size.x), int32_t(voxel % uint32_t(size.x)));
            }
        words.upload(filled_words.size(), [&](size_t i) { return filled_words[i]; });
        marks.upload(occupied.size(), [&](size_t i) { return occupied[i]; });

        for (const Metric metric : {Metric::chessboard, Metric::city_block}) {
            filled.resize(voxels);
            far.resize(voxels);
            map.resize(voxels);
            count.resize(1);
            count.fill_bytes(0);
            backend.for_each(voxels, baselines::ListFilledVoxels{paper, filled.view(), count.view(), far.view()});
            backend.for_each(voxels * count.read(0), baselines::MeasurePairs{paper, metric, filled.view(), far.view()});
            backend.for_each(voxels, baselines::NarrowDistances{far.view(), map.view()});

            total.resize(1);
            total.fill_bytes(0);
            DistancePass pass{.cloud = {.size = size, .metric = metric},
                              .marks = {marks.view(), BrickMarks::row_words(size)},
                              .piece = 32,
                              .total = total.view()};
            passed.resize(voxels);
            between.resize(voxels);
            const RowDistances<1> rows{pass.cloud, pass.marks, passed.view()};
            backend.for_each(rows.item_count(), rows);
            for (pass.axis = 1; pass.axis < 3; ++pass.axis) {
                pass.in = pass.axis == 1 ? passed.view() : between.view();
                pass.out = pass.axis == 1 ? between.view() : passed.view();
                backend.for_each(pass.item_count(), pass);
            }
            std::vector<uint8_t> by_pairs(voxels), by_passes(voxels);
            map.download(by_pairs.data());
            passed.download(by_passes.data());
            CHECK(by_pairs == by_passes);
        }
    }
}

TEST_CASE_TEMPLATE("baseline: the paper's way makes the renderer's bits", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    baselines::PaperRenderer<Backend> paper;
    const RandomSceneSpec specs[] = {
        {.spheres = 300, .radius = 0.1},
        {.spheres = 300, .shape = Shape::flat},
        {.spheres = 100, .shape = Shape::line, .radius = 0.02},
        {.spheres = 500, .shape = Shape::clusters, .radius = 0.02, .ground = false},
        {.spheres = 5, .radius = 0.1},
    };
    for (uint32_t seed = 20; const RandomSceneSpec& spec : specs) {
        const SceneProgram scene = random_scene(++seed, spec);
        CAPTURE(seed);
        FrameSettings settings;
        settings.width = 80;
        settings.height = 60;
        settings.accelerator = Accelerator::brute;
        const Image brute = render(*renderer, scene, settings);
        for (const std::array<uint32_t, 3> grid : {std::array<uint32_t, 3>{1, 1, 1}, {20, 20, 20}, {3, 40, 7}})
            for (const Metric metric : {Metric::chessboard, Metric::city_block})
                for (const Accelerator accelerator : {Accelerator::grid, Accelerator::cloud}) {
                    settings.grid = grid;
                    settings.metric = metric;
                    settings.accelerator = accelerator;
                    FrameStatistics statistics;
                    CHECK(same_bits(brute, render(paper, scene, settings, &statistics)));
                    CHECK(statistics.method == (accelerator == Accelerator::cloud ? "paper-cloud" : "paper-grid"));
                }
    }
}
