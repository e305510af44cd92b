// SPDX-License-Identifier: Apache-2.0
#include "parser/area_weights.h"

namespace proxima {
namespace {

struct WeightGrid {
    uint32_t rows;
    std::vector<double> weights;

    void add(uint32_t u1, uint32_t v1, uint32_t u2, uint32_t v2, double weight) {
        if (u2 - u1 <= 1 && v2 - v1 <= 1) {
            for (const uint32_t u : {u1, u2})
                for (const uint32_t v : {v1, v2})
                    weights[u * rows + v] += weight / 4;
            return;
        }
        const uint32_t left = (u1 + u2) / 2, right = (u1 + u2 + 1) / 2;
        const uint32_t low = (v1 + v2) / 2, high = (v1 + v2 + 1) / 2;
        add(u1, v1, left, low, weight / 4);
        add(right, v1, u2, low, weight / 4);
        add(u1, high, left, v2, weight / 4);
        add(right, high, u2, v2, weight / 4);
    }
};

} // namespace

void append_area_samples(std::vector<AreaSample>& samples, uint32_t columns, uint32_t rows) {
    WeightGrid grid{rows, std::vector<double>(size_t(columns) * rows)};
    grid.add(0, 0, columns - 1, rows - 1, 1);
    for (uint32_t u = 0; u < columns; ++u)
        for (uint32_t v = 0; v < rows; ++v)
            samples.push_back({u, v, float(grid.weights[size_t(u) * rows + v])});
}

} // namespace proxima
