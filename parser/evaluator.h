// SPDX-License-Identifier: Apache-2.0
// Runs token programs: a recursive-descent reader of the scene language whose next token may be a directive, which it
// runs first. In goes a ScriptSources, out comes a SceneProgram. The methods are defined by topic in the eval_*.cpp.
#pragma once
#include "parser/diagnostics.h"
#include "parser/random_streams.h"
#include "parser/scene_builder.h"
#include "parser/scene_script.h"
#include "parser/scopes.h"
#include "parser/script_sources.h"
#include "parser/shape_transform.h"
#include "parser/words.h"

#include <chrono>
#include <span>
#include <unordered_set>

namespace proxima {

enum class SplineKind : uint8_t;

class Evaluator {
public:
    Evaluator(ScriptSources& sources, const EvaluationSettings& settings, Diagnostics& diagnostics);

    /// Evaluates the scene file (file 0). Mistakes go to the diagnostics; the result is then incomplete.
    SceneProgram run();

private:
    static constexpr double epsilon = 1e-10; ///< POV-Ray's tolerance of comparisons
    static constexpr size_t include_depth_limit = 100;
    static constexpr size_t macro_depth_limit = 10'000;
    static constexpr size_t nesting_limit = 200; ///< of expressions and objects

    /// Where the caller of the text or macro that is being read goes on.
    struct Frame {
        TokenProgram* program;
        const Token* return_to;
        size_t loops;
        const Token* macro; ///< its #macro, or nullptr for an included text
    };
    struct Loop {
        const Token* opener;
        const Token* body = nullptr; ///< of #for, as are the variable, end and step
        Symbol variable = 0;
        uint64_t changes = 0; ///< changes_ when the body began
        double start = 0;
        double end = 0;
        double step = 1;
        bool stopped = false; ///< after a mistake: ends at its #end

        bool goes_on(double value) const; ///< #for: whether the body runs with this value of the variable
    };
    /// Counts how deep the reader stands in itself.
    struct Nesting {
        Evaluator& evaluator;
        explicit Nesting(Evaluator& evaluator);
        Nesting(const Nesting&) = delete;
        ~Nesting() { --evaluator.nesting_; }
    };

    /// The element that the name under the cursor stands for, found when it was first asked for.
    struct Element {
        const Token* name = nullptr;  ///< nullptr when there is none
        const Token* after = nullptr; ///< behind its subscripts
        std::vector<uint32_t> path;   ///< as BindingRef::element
        ArrayRef array;               ///< which keeps the value
        const Value* value = nullptr; ///< std::monostate: none yet
    };

    /// What look_at needs beside the camera.
    struct CameraFrame {
        Vec3<Varying> sky;
        Varying direction_length;
    };

    // eval_tokens.cpp: the stream of tokens
    const Token& peek() {
        while (cursor_->directive != Directive::none && interrupt()) {
        }
        return *cursor_;
    }
    const Token& next() {
        const Token& token = peek();
        advance();
        return token;
    }
    void advance() {
        if (cursor_ == element_.name)
            leave_element();
        else
            ++cursor_;
        directive_before_ = false;
        if (++steps_ > next_check_)
            check_budget();
    }
    bool accept(TokenKind kind) {
        if (peek().kind != kind)
            return false;
        advance();
        return true;
    }
    bool peek_is(Word word) {
        const Token& token = peek();
        return token.kind == TokenKind::word && token.index == uint32_t(word);
    }
    bool accept(Word word) {
        if (!peek_is(word))
            return false;
        advance();
        return true;
    }
    void expect(TokenKind kind) {
        if (!accept(kind))
            fail_expected(kind);
    }
    std::string_view spelling(const Token& token) const;
    SourceSpan span(const Token& token) const { return {{program_->file, token.offset}, token.length}; }
    [[noreturn]] void fail(const Token& token, std::string message, std::string hint = {}) const;
    [[noreturn]] void fail_expected(TokenKind kind);
    [[noreturn]] void fail_unexpected(const std::string& expected);
    [[noreturn]] void fail_refused(const Token& token, std::string_view name, const Refused& refused);
    [[noreturn]] void fail_undeclared(const Token& token, std::string_view name, const std::string& expected);
    std::string unclosed_item() const;
    std::string suggestion(std::string_view name) const;
    void warn(const Token& token, std::string message, std::string hint = {});

    // eval_directives.cpp
    bool interrupt();
    void run_directive(const Token& directive);
    void run_if(const Token& directive);
    bool condition(const Token& directive);
    std::pair<double, double> case_values(const Token& directive);
    void run_switch(const Token& directive);
    void run_while(const Token& directive);
    void run_for(const Token& directive);
    void run_end(const Token& directive);
    void leave_loop(const Token& opener);

    // eval_includes.cpp
    void run_include(const Token& directive);
    void enter_text(uint32_t file);
    void include_standard(const std::string& name, const Token& at);
    void leave_frame();
    void run_version();
    void run_message(const Token& directive);

    // eval_macros.cpp
    void run_macro(const Token& directive);
    void call_macro(const Token& name);
    bool names_one_thing(const Token& argument);
    bool leave_macro();

    // eval_declare.cpp
    void predeclare();
    void predeclare(std::string_view name, Value value);
    void declare_from_command_line(const std::string& name, const std::string& text);
    void run_declare(const Token& directive);
    void run_undef();
    static bool value_changes(const Value& before, const Value& after);
    void run_default();
    Symbol declared_name();
    std::vector<uint32_t> declared_element(const Token& name, const Binding* known, const Token& directive);
    Value right_hand_side();
    bool after_value(TokenKind kind);
    Binding* lookup(const Token& name);
    /// What the name under the cursor stands for, subscripts and all, or nullptr. The token stays; advance() goes
    /// behind the subscripts.
    const Value* named_value(const Token& name) {
        if (&name == element_.name)
            return &element_value(name, *element_.value);
        const Binding* binding = lookup(name);
        if (!binding || !std::holds_alternative<ArrayRef>(binding->value))
            return binding ? &binding->value : nullptr;
        return &element_value(name, binding->value);
    }
    /// The value of the next token if that is a name of this kind; the token stays.
    template <class T> const T* identifier() {
        const Token& token = peek();
        const Value* value = token.kind == TokenKind::name ? named_value(token) : nullptr;
        return value ? std::get_if<T>(value) : nullptr;
    }

    // eval_motion.cpp
    void look_at(SourceSpan place, const Token& first, NodeId nodes);
    std::string word_before(const Token& number) const;
    void stop_recording(SourceSpan place, std::string word, std::string reason);
    void collect_nodes();

    // eval_budget.cpp
    void charge(uint64_t bytes);
    void check_budget();
    [[noreturn]] void fail_budget(std::string message, const std::string& advice);
    const Loop* costly_loop() const;
    std::string advice();

    // eval_user_functions.cpp
    class FunctionReader; ///< function_reader.h
    class FunctionCall;
    Value function_value();
    static bool is_callable(const Value* value);
    bool starts_call(const Token& name);
    Terms call_declared(const Token& name);
    Terms call_user_function(const Token& name, UserFunction& function);
    void check_redeclaration(const Token& name, const Value& old, const Value& value) const;

    // eval_splines.cpp
    Value spline();
    bool starts_time();
    void spline_point(Spline& spline);
    void check_spline(const Token& at, const Spline& spline, SplineKind kind) const;
    Terms call_spline(const Spline& spline);
    NodeId spline_nodes(const Spline& spline, SplineKind kind, const Varying& time);

    // eval_arrays.cpp
    Value array();
    void initialize(Array& array, size_t dimension);
    void add_element(const Token& at, Array& array, Value& element, Value value);
    bool stands_for_element(const Token& name) const;
    const Value& element_value(const Token& name, const Value& whole);
    void find_element(const Token& name, const Value& whole);
    void leave_element();
    uint32_t subscript(const Array& array);
    void store_element(const Token& name, Value& whole, const std::vector<uint32_t>& path, Value value);
    double array_function(const Token& word);
    bool name_is_defined();

    // eval_files.cpp
    void run_fopen();
    void run_fclose();
    void run_read();
    void read_values();
    void read_into(DataFile& file);

    // eval_expression.cpp
    Terms expression(); ///< with relations, & | and ?:
    Terms logical();
    Terms relation();
    bool string_relation();
    TokenKind next_operator() {
        return cursor_->directive == Directive::none ? cursor_->kind : next_operator_behind_directive();
    }
    TokenKind next_operator_behind_directive();
    Terms sum();
    Terms product();
    Terms factor();
    Terms name_factor(const Token& name);
    Terms word_factor(const Token& word);

    // eval_terms.cpp
    Terms vector_literal();
    void access(Terms& terms);
    bool starts_expression();
    /// A number that may follow from the time, and one whose value now is all that counts: if it follows from the time,
    /// each frame needs an evaluation of its own.
    Varying moving_number();
    double number() {
        const Token& first = peek();
        const TokenProgram* const program = program_; // a macro may lead to another text
        const Varying value = moving_number();
        if (value.node) [[unlikely]]
            look_at({{program->file, first.offset}, first.length}, first, value.node);
        return value.value;
    }
    Terms vector_of(int count, const char* what);
    Vec3<Varying> moving_vector() { return vector_of(3, "a vector").varying_vector(); }
    Vec3<double> vector();
    bool optional_flag(bool value); ///< on, off, or nothing

    // eval_functions.cpp
    Terms call_function(const Token& word);
    Terms vector_function(const Token& word);
    double random_number();
    void separator();
    Varying checked(const Token& at, const Varying& value);

    // eval_strings.cpp
    bool starts_string();
    std::string string();
    double string_function(const Token& word);

    // eval_color.cpp
    bool starts_color();
    Terms color();
    Vec3<Varying> rgb_color();

    // eval_texture.cpp
    PigmentRef pigment(uint32_t base);
    PigmentRef pigment_items(uint32_t base, TokenKind closing);
    FinishRef finish(uint32_t base);
    void reflection(Moving<Finish>& finish);
    InteriorRef interior(uint32_t base);
    TextureRef texture();
    MaterialValue material();
    bool texture_item(uint32_t& texture);
    std::vector<Layer> single_layer(uint32_t texture);
    uint32_t with_pigment(uint32_t texture);
    uint32_t with_finish(uint32_t texture);
    uint32_t layered(uint32_t below, uint32_t above);

    // eval_pattern.cpp
    bool pattern_kind(PigmentValue& value);
    bool pattern_item(PigmentValue& value);
    void complete_pattern(PigmentValue& value);
    ColorMapRef color_map();
    void expect_color_word();
    void check_rising(const Token& at, std::span<const Moving<ColorStop>> stops) const;

    // eval_pigment_map.cpp
    PigmentMapRef pigment_map();
    bool pigment_map_item(PigmentValue& value, bool own_pattern);
    bool starts_pigment();

    // eval_transform.cpp
    bool transform_item(Transform& result);
    Transform scale_item(const Token& token);
    Transform transform_block();
    Affine<Varying> matrix();

    // eval_objects.cpp
    bool starts_object();
    bool starts_shape(); ///< an object or the name of one
    Shape object();
    void sphere_item(const Token& start);
    void add_to_scene(Shape& shape, const Token& start);
    bool plain_end(Surface& surface);
    Sphere<double> sphere_numbers(PartNodes& nodes);
    void sphere(Shape& shape);
    void literal_sphere(Shape& shape);
    void plane(Shape& shape);
    void union_parts(Shape& shape);
    void object_reference(Shape& shape);
    void object_modifiers(Shape& shape, Word kind);
    bool flag_item(Surface& surface);
    void emit_sphere_run();
    uint32_t literal_texture(uint32_t surface);

    // eval_camera.cpp, eval_lights.cpp, eval_settings.cpp, eval_sky.cpp
    Camera<Varying> camera();
    void aim_camera(Camera<Varying>& camera, const Vec3<Varying>& aim, const CameraFrame& frame, const Token& at);
    void light_source(Shape& shape);
    bool light_kind_item(LightSource& source);
    bool area_light_item(LightSource& source);
    void looks_like(Shape& shape);
    void background();
    Moving<SkySphere> sky_sphere();
    Moving<Fog<double>> fog();
    void global_settings();
    void assumed_gamma();
    Varying encode_working(const Varying& linear);
    bool before_3_7() const { return !has_version_ || version_ < 3.7 - epsilon; }
    void finish_settings();

    // evaluator.cpp
    bool item();
    void recover();
    void note_unused();

    ScriptSources& sources_;
    const EvaluationSettings& settings_;
    Diagnostics& diagnostics_;
    MotionGraph graph_;
    SceneBuilder builder_;
    Scopes scopes_;
    RandomStreams random_;

    TokenProgram* program_ = nullptr;
    const Token* cursor_ = nullptr;
    Element element_;
    size_t run_position_ = 0; ///< spheres already taken from the run under the cursor
    std::vector<Frame> frames_;
    std::vector<Loop> loops_;
    const Token* item_start_ = nullptr;
    size_t item_frames_ = 0;
    bool in_item_ = false;
    uint64_t steps_ = 0;
    uint64_t next_check_ = 0; ///< steps_ when the budget is looked at again
    uint64_t charged_ = 0;    ///< bytes since the budget was looked at
    uint64_t bytes_at_start_ = 0;
    uint64_t byte_limit_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    bool exhausted_ = false;         ///< the budget is
    bool directive_before_ = false;  ///< a directive ran since the last token
    size_t bare_nesting_ = SIZE_MAX; ///< where an expression ends at a directive: see next_operator
    uint64_t changes_ = 0;           ///< of anything that a condition may depend on
    size_t nesting_ = 0;
    size_t includes_ = 0; ///< open ones

    uint32_t default_texture_ = 0;
    double version_ = 3.7;
    bool has_version_ = false; ///< without one the scene reads 3.7 and is rendered as one of before 3.7
    bool has_assumed_gamma_ = false;
    bool has_camera_ = false;
    bool depends_on_time_ = false;
    std::optional<MotionObstacle> obstacle_; ///< the first one
    std::unordered_set<Symbol> time_names_;
    std::unordered_set<Symbol> failed_names_; ///< a mistake stands in their declaration
};

} // namespace proxima
