// SPDX-License-Identifier: Apache-2.0
// The order of work of `proxima compare`: pair after pair is loaded, measured, drawn and told; then the whole.
#include "renderer/atomic_file.h"
#include "renderer/commands.h"
#include "renderer/comparison_page.h"
#include "renderer/comparison_text.h"
#include "renderer/difference_picture.h"
#include "renderer/errors.h"
#include "renderer/picture_pairs.h"
#include "renderer/program_pairs.h"
#include "renderer/stop_signal.h"

#include <cstdio>
#include <fmt/format.h>
#include <tbb/global_control.h>

namespace proxima {
namespace {

/// The run's state: what every pair goes through.
class Comparison {
public:
    explicit Comparison(const CompareOptions& options) : options_(options) {
        record_.a = options.povray ? options.scene.scene.string() + " by POV-Ray" : options.a.string();
        record_.b = options.povray ? options.scene.scene.string() + " by Proxima" : options.b.string();
        record_.tolerance = options.tolerance;
        record_.allowed_share = options.allowed_share;
        if (options.heatmap)
            check_writable(*options.heatmap);
        if (options.json)
            check_writable(*options.json);
        if (options.report)
            page_.emplace(*options.report);
        if (options.heatmap || options.report)
            encoder_.emplace();
    }

    void add(const PicturePair& pair) {
        PairRecord record{.name = pair.name, .a = pair.a, .b = pair.b};
        if (!pair.load_a || !pair.load_b) {
            record.verdict = Verdict::missing;
            record.reason = pair.load_a ? "B has none" : pair.load_b ? "A has none" : "neither A nor B has it";
        } else if (const auto images = load(pair, record)) {
            measure_pair(*images, record);
        }
        record_.pairs.push_back(std::move(record));
    }

    const ComparisonRecord& record() const { return record_; }

    void finish() const {
        if (page_)
            page_->finish(record_);
        if (options_.json) {
            const std::string text = to_json(record_);
            write_file(*options_.json, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
        }
    }

private:
    /// What is wrong with the pictures goes into the record; what is wrong with a program is thrown.
    std::optional<ImagePair> load(const PicturePair& pair, PairRecord& record) const {
        try {
            StoredImage a = pair.load_a(), b = pair.load_b();
            for (const StoredImage* image : {&a, &b})
                record.ignored_channels.insert(record.ignored_channels.end(), image->ignored_channels.begin(),
                                               image->ignored_channels.end());
            return pair_images(std::move(a), std::move(b), options_.linear);
        } catch (const NotComparable& reason) {
            record.verdict = Verdict::not_comparable;
            record.reason = reason.what();
        } catch (const FileError& reason) {
            if (options_.povray)
                throw;
            record.verdict = Verdict::unreadable;
            record.reason = reason.what();
        }
        return std::nullopt;
    }

    void measure_pair(const ImagePair& images, PairRecord& record) {
        record.width = images.width;
        record.height = images.height;
        record.channels = images.channels;
        record.white = images.white;
        record.rule = images.rule;
        record.figures = measure(images, options_.tolerance);
        const ImageFigures& figures = *record.figures;
        const bool is_equal = figures.non_finite_a + figures.non_finite_b == 0 &&
                              double(figures.pixels_over) <= options_.allowed_share * double(figures.pixels);
        record.verdict = is_equal ? Verdict::equal : Verdict::different;
        if (page_)
            page_->add_pictures(record_.pairs.size(), images, options_.tolerance, *encoder_);
        if (options_.heatmap) {
            const Image picture = side_by_side(
                {displayed(images, images.a), displayed(images, images.b), difference_map(images, options_.tolerance)});
            write_file(*options_.heatmap, encoder_->encode(picture, {.facts = {.color_encoding = "sRGB"}}));
        }
    }

    const CompareOptions& options_;
    ComparisonRecord record_;
    std::optional<ComparisonPage> page_;
    std::optional<ImageEncoder> encoder_;
};

/// Says how it went, and throws unless everything is equal.
void conclude(const ComparisonRecord& record) {
    const size_t total = record.pairs.size(), unreadable = record.count(Verdict::unreadable);
    if (total == 1 && !record.pairs.front().figures) {
        const PairRecord& pair = record.pairs.front();
        if (unreadable > 0)
            throw FileError(pair.reason);
        throw PicturesDiffer(fmt::format("{}, {}: {}", record.a, record.b, pair.reason));
    }
    if (unreadable > 0)
        throw FileError(fmt::format("{} of {} pairs could not be read; {} in all are not equal", unreadable, total,
                                    record.failures()));
    if (record.failures() > 0)
        throw PicturesDiffer(total == 1 ? fmt::format("{}, {}: the pictures differ", record.a, record.b)
                                        : fmt::format("{} of {} pairs are not equal", record.failures(), total));
}

} // namespace

void compare_command(const CompareOptions& options) {
    const StopSignal stop;
    std::optional<tbb::global_control> limit;
    if (options.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
    Comparison comparison(options);
    const auto pairs = options.povray ? pair_programs(options) : pair_files(options.a, options.b, options.frames);
    if (options.heatmap && pairs.size() > 1)
        throw UsageError("--heatmap: it shows one pair; for a set write --report DIR");
    for (const PicturePair& pair : pairs) {
        try {
            comparison.add(pair);
        } catch (const SceneRejected&) { // a signal reaches POV-Ray too, and ends it
            if (stop.caught())
                throw Interrupted(stop.caught());
            throw;
        }
        if (stop.caught())
            throw Interrupted(stop.caught());
        const PairRecord& record = comparison.record().pairs.back();
        if (pairs.size() > 1)
            std::fputs(short_text(record).c_str(), stdout);
        else if (record.figures)
            std::fputs(full_text(record, options.tolerance).c_str(), stdout);
    }
    comparison.finish();
    if (pairs.size() > 1)
        std::fputs(
            fmt::format("{} of {} pairs are equal\n", comparison.record().count(Verdict::equal), pairs.size()).c_str(),
            stdout);
    conclude(comparison.record());
}

} // namespace proxima
