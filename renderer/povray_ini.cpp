// SPDX-License-Identifier: Apache-2.0
#include "renderer/povray_ini.h"
#include "parser/source_files.h"
#include "renderer/errors.h"
#include "renderer/ini_antialiasing.h"
#include "renderer/ini_value.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace proxima {
namespace fs = std::filesystem;
namespace {

/// What the value of a setting has to be, where Proxima has only one way.
enum class Rule { any, off, on };

struct Setting {
    std::string_view name;
    Rule rule;
};

// Settings that are no option of ours. `any` changes no picture; `off` and `on` are refused when they are not.
constexpr Setting settings[] = {
    {"display", Rule::any},
    {"verbose", Rule::any},
    {"pause_when_done", Rule::any},
    {"test_abort", Rule::any},
    {"test_abort_count", Rule::any},
    {"continue_trace", Rule::any},
    {"create_ini", Rule::any},
    {"warning_level", Rule::any},
    {"all_console", Rule::any},
    {"debug_console", Rule::any},
    {"fatal_console", Rule::any},
    {"render_console", Rule::any},
    {"statistic_console", Rule::any},
    {"warning_console", Rule::any},
    {"all_file", Rule::any},
    {"debug_file", Rule::any},
    {"fatal_file", Rule::any},
    {"render_file", Rule::any},
    {"statistic_file", Rule::any},
    {"warning_file", Rule::any},
    {"bounding", Rule::any},
    {"bounding_method", Rule::any},
    {"bounding_threshold", Rule::any},
    {"bsp_maxdepth", Rule::any},
    {"light_buffer", Rule::any},
    {"vista_buffer", Rule::any},
    {"remove_bounds", Rule::any},
    {"split_unions", Rule::any},
    {"render_block_size", Rule::any},
    {"render_block_step", Rule::any},
    {"preview_start_size", Rule::any},
    {"preview_end_size", Rule::any},
    {"video_mode", Rule::any},
    {"display_gamma", Rule::any},
    {"palette", Rule::any},
    {"draw_vistas", Rule::any},
    {"buffer_output", Rule::any},
    {"buffer_size", Rule::any},
    {"compression", Rule::any},
    {"output_alpha", Rule::off},
    {"dither", Rule::off},
    {"field_render", Rule::off},
    {"odd_field", Rule::off},
    {"grayscale_output", Rule::off},
    {"output_to_file", Rule::on},
};

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The lines of a file as settings, and what they mean together.
class IniReader {
public:
    explicit IniReader(std::string name) : name_(std::move(name)) {}

    void line(size_t number, std::string_view text) {
        number_ = number;
        const size_t equal = text.find('=');
        if (equal == std::string_view::npos)
            fail(fmt::format("'{}' is no setting; write Name=value", text));
        const std::string_view name = trimmed(text.substr(0, equal));
        std::string_view value = trimmed(text.substr(equal + 1));
        const bool quoted = value.size() >= 2 && value.front() == value.back() && (value[0] == '"' || value[0] == '\'');
        if (quoted)
            value = value.substr(1, value.size() - 2);
        set(name, value);
    }

    IniOptions finish() {
        if (options_.scene.empty())
            throw UsageError(fmt::format("{}: it names no scene; write Input_File_Name=scene.pov in it", name_));
        if (width_.empty() != height_.empty())
            throw UsageError(fmt::format("{}: Width and Height need each other", name_));
        if (!width_.empty())
            options_.size = width_ + "x" + height_;
        const bool still = (first_ == 0 || first_ == 1) && (last_ == 0 || last_ == 1);
        if (still) {
            options_.clock = clock_;
            options_.cyclic = false;
        } else {
            options_.frames = fmt::format("{}-{}", first_, last_);
            options_.clock = fmt::format("{}:{}", first_clock_, last_clock_);
            if (!subset_first_.empty() || !subset_last_.empty())
                options_.subset = fmt::format("{}-{}", subset_first_.empty() ? std::to_string(first_) : subset_first_,
                                              subset_last_.empty() ? std::to_string(last_) : subset_last_);
        }
        try {
            options_.antialias = antialiasing_.option();
        } catch (const UsageError& error) {
            options_.antialias_refusal = fmt::format("{}:{}: {}", name_, antialias_line_, error.what());
        }
        name_output(still);
        return std::move(options_);
    }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw UsageError(fmt::format("{}:{}: {}", name_, number_, message));
    }

    int64_t whole(std::string_view name, std::string_view value) const {
        int64_t result = 0;
        const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), result);
        if (error != std::errc() || end != value.data() + value.size() || result < 0)
            fail(fmt::format("{}={}: write a whole number", name, value));
        return result;
    }

    /// Runs what throws a UsageError and says where in the file that was.
    template <class Read> auto placed(const Read& read) const {
        try {
            return read();
        } catch (const UsageError& error) {
            fail(error.what());
        }
    }

    bool flag(std::string_view name, std::string_view value) const {
        return placed([&] { return ini_flag(name, value); });
    }

    /// One setting after the other, in the order of POV-Ray's manual.
    void set(std::string_view name, std::string_view value) {
        const auto is = [&](std::string_view known) { return same_letters(name, known); };
        if (is("Input_File_Name"))
            options_.scene = value;
        else if (is("Output_File_Name"))
            output_ = value;
        else if (is("Output_File_Type"))
            set_type(name, value);
        else if (is("Bits_Per_Color"))
            options_.bits = std::to_string(whole(name, value));
        else if (is("Width"))
            width_ = value;
        else if (is("Height"))
            height_ = value;
        else if (is("Initial_Frame"))
            first_ = whole(name, value);
        else if (is("Final_Frame"))
            last_ = whole(name, value);
        else if (is("Initial_Clock"))
            first_clock_ = value;
        else if (is("Final_Clock"))
            last_clock_ = value;
        else if (is("Clock"))
            clock_ = value;
        else if (is("Cyclic_Animation"))
            options_.cyclic = flag(name, value);
        else if (is("Subset_Start_Frame"))
            subset_first_ = std::to_string(whole(name, value));
        else if (is("Subset_End_Frame"))
            subset_last_ = std::to_string(whole(name, value));
        else if (is("Declare"))
            options_.declares.emplace_back(value);
        else if (is("Library_Path"))
            options_.include_paths.emplace_back(value);
        else if (is("Work_Threads"))
            options_.threads = std::to_string(whole(name, value));
        else if (!placed([&] { return antialiasing_.set(name, value); }))
            check(name, value);
        else if (same_letters(name, "Antialias"))
            antialias_line_ = number_;
    }

    void set_type(std::string_view name, std::string_view value) {
        static const std::map<char, std::string> extensions{{'n', ".png"}, {'e', ".exr"}, {'j', ".jpg"}};
        const auto found = extensions.find(value.empty() ? ' ' : char(std::tolower(uint8_t(value[0]))));
        if (value.size() != 1 || found == extensions.end())
            fail(fmt::format("{}={}: Proxima writes N (PNG), E (OpenEXR) and J (JPEG)", name, value));
        extension_ = found->second;
    }

    /// A setting that Proxima knows and has no choice in, or refuses.
    void check(std::string_view name, std::string_view value) const {
        const auto same_number = [&](std::string_view number) { return value == number; };
        if (same_letters(name, "Quality") && (same_number("9") || same_number("10") || same_number("11")))
            return;
        if (same_letters(name, "Frame_Step") && same_number("1"))
            return;
        if (same_letters(name, "File_Gamma") && same_letters(value, "sRGB"))
            return;
        const auto found = std::ranges::find_if(settings, [&](const Setting& s) { return same_letters(s.name, name); });
        if (found == std::end(settings))
            fail(fmt::format("Proxima does not support {}={}", name, value));
        if (found->rule != Rule::any && flag(name, value) != (found->rule == Rule::on))
            fail(fmt::format("Proxima does not support {}={}", name, value));
    }

    /// POV-Ray numbers the frames with as many digits as the last one has; a cyclic animation counts one more.
    void name_output(bool still) {
        fs::path path(output_);
        if (output_.empty() || output_.ends_with('/'))
            path /= fs::path(options_.scene).stem();
        const std::string given = path.extension().string();
        const std::string extension = given.empty() ? extension_ : given;
        if (!still || !output_.empty() || extension_ != ".png") {
            const size_t digits = std::to_string(last_ + (options_.cyclic ? 1 : 0)).size();
            path.replace_extension();
            options_.output = path.string() + (still ? "" : fmt::format("%0{}d", digits)) + extension;
        }
    }

    std::string name_;
    size_t number_ = 0;
    IniOptions options_;
    IniAntialiasing antialiasing_;
    size_t antialias_line_ = 0; ///< the last one that turns it on or off
    std::string output_, extension_ = ".png", width_, height_, clock_, first_clock_ = "0", last_clock_ = "1";
    std::string subset_first_, subset_last_;
    int64_t first_ = 1, last_ = 1;
};

/// The file's name and the section behind it.
std::pair<std::string, std::string> split_section(const std::string& scene) {
    const size_t bracket = scene.ends_with(']') ? scene.rfind('[') : std::string::npos;
    if (bracket == std::string::npos)
        return {scene, ""};
    return {scene.substr(0, bracket), scene.substr(bracket + 1, scene.size() - bracket - 2)};
}

} // namespace

bool is_povray_ini(std::string_view scene) {
    return same_letters(fs::path(split_section(std::string(scene)).first).extension().string(), ".ini");
}

IniOptions parse_povray_ini(std::string_view text, std::string_view section, const std::string& name) {
    IniReader reader(name);
    bool wanted = true;
    bool found = section.empty();
    size_t number = 0;
    while (!text.empty()) {
        const size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        line = trimmed(line.substr(0, line.find(';')));
        ++number;
        if (line.empty() || line.starts_with('#'))
            continue;
        if (line.starts_with('[') && line.ends_with(']')) {
            wanted = !section.empty() && same_letters(trimmed(line.substr(1, line.size() - 2)), section);
            found = found || wanted;
        } else if (wanted) {
            reader.line(number, line);
        }
    }
    if (!found)
        throw UsageError(fmt::format("{}: it has no section [{}]", name, section));
    return reader.finish();
}

IniOptions read_povray_ini(const std::string& scene) {
    const auto [name, section] = split_section(scene);
    std::ifstream file(name);
    std::ostringstream text;
    if (!file || !fs::is_regular_file(name) || !(text << file.rdbuf()))
        throw FileError(fmt::format("cannot read {}", name));
    IniOptions options = parse_povray_ini(text.str(), section, name);
    if (!fs::exists(options.scene) && fs::exists(fs::path(name).parent_path() / options.scene))
        options.scene = (fs::path(name).parent_path() / options.scene).string();
    return options;
}

} // namespace proxima
