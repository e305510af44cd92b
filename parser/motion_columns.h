// SPDX-License-Identifier: Apache-2.0
// The constants of things whose expressions have one shape: a table with a row for each thing and a column for each
// place where a constant stands. Columns that are equal in every row are kept once, and one that never varies is a
// single number.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace proxima {

class MotionColumns {
public:
    explicit MotionColumns(size_t places = 0) : column_of_(places), columns_(places > 0 ? 1 : 0) {}

    /// Adds a row: a number for each place.
    void add(std::span<const double> row);

    uint32_t rows() const { return rows_; }
    /// Which column a place has.
    uint32_t column_of(size_t place) const { return column_of_[place]; }
    bool varies(uint32_t column) const { return columns_[column].varies; }
    /// A column's number in the first row, or in all of them.
    double first(uint32_t column) const { return columns_[column].first; }
    /// The numbers of a column that varies.
    std::span<const double> numbers(uint32_t column) const { return columns_[column].numbers; }

private:
    struct Column {
        double first = 0;
        bool varies = false;
        uint32_t rows = 0; ///< that it has a number for
        double last = 0;   ///< the number in the last of them
        std::vector<double> numbers;

        void add(double number);
    };
    struct Split {
        uint32_t from;
        uint32_t column;
    };

    std::vector<uint32_t> column_of_;
    std::vector<Column> columns_;
    std::vector<Split> splits_; ///< of the row that is added
    uint32_t rows_ = 0;
};

} // namespace proxima
