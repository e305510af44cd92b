// SPDX-License-Identifier: Apache-2.0
#include "parser/motion_columns.h"

#include <bit>

namespace proxima {
namespace {

/// -0 is another number than 0 here, and NaN is equal to itself.
bool same(double a, double b) {
    return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

} // namespace

void MotionColumns::Column::add(double number) {
    if (rows == 0) {
        first = number;
    } else if (!varies && !same(number, first)) {
        varies = true;
        numbers.assign(rows, first);
    }
    if (varies)
        numbers.push_back(number);
    last = number;
    ++rows;
}

void MotionColumns::add(std::span<const double> row) {
    splits_.clear();
    for (size_t place = 0; place < row.size(); ++place) {
        const uint32_t shared = column_of_[place];
        Column* column = &columns_[shared];
        if (column->rows == rows_) { // the first of its places in this row
            column->add(row[place]);
            continue;
        }
        if (same(column->last, row[place]))
            continue;
        // The place leaves the column, perhaps with others.
        uint32_t joined = shared;
        for (const Split& split : splits_)
            if (split.from == shared && same(columns_[split.column].last, row[place]))
                joined = split.column;
        if (joined == shared) {
            joined = uint32_t(columns_.size());
            splits_.push_back({shared, joined});
            Column next;
            next.first = column->first;
            next.rows = rows_;
            next.varies = column->varies && rows_ > 0;
            if (next.varies) {
                next.numbers.assign(column->numbers.begin(), column->numbers.begin() + rows_);
                // Up to here it may have been one number.
                bool varied = false;
                for (const double number : next.numbers)
                    varied |= !same(number, next.first);
                if (!varied) {
                    next.varies = false;
                    next.numbers.clear();
                }
            }
            next.add(row[place]);
            columns_.push_back(std::move(next));
        }
        column_of_[place] = joined;
    }
    ++rows_;
}

} // namespace proxima
