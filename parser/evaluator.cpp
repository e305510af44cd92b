// SPDX-License-Identifier: Apache-2.0
// The evaluator's main loop: items one after the other, and how it goes on after a mistake.
#include "parser/evaluator.h"
#include "parser/memory.h"

#include <fmt/format.h>

namespace proxima {

Evaluator::Evaluator(ScriptSources& sources, const EvaluationSettings& settings, Diagnostics& diagnostics)
    : sources_(sources), settings_(settings), diagnostics_(diagnostics), builder_(graph_) {
    if (settings.record_motion)
        graph_.start();
    PigmentValue black;
    const Layer layer{builder_.add_pigment(black), builder_.add_finish(Finish{})};
    default_texture_ = builder_.add_texture({&layer, 1});
    byte_limit_ = settings.budget.bytes > 0 ? settings.budget.bytes : machine_bytes() / 4 * 3;
    bytes_at_start_ = resident_bytes();
    predeclare();
}

SceneProgram Evaluator::run() {
    const MotionGraph::Recording recording(graph_);
    program_ = sources_.program(0, diagnostics_);
    if (!program_)
        return {};
    cursor_ = program_->tokens.data();
    if (program_->literal_spheres > 0)
        builder_.reserve_spheres(program_->literal_spheres + program_->literal_spheres / 64 + 64);
    size_t mistakes = 0; // the same one in a macro too, which is shown once
    for (bool more = true; more;) {
        try {
            in_item_ = false;
            while (item()) {
            }
            more = false;
        } catch (const SceneError& error) {
            if (!error.diagnostic.message.empty())
                diagnostics_.report(error.diagnostic);
            more = !exhausted_ && diagnostics_.error_count() < 200 && ++mistakes < 1000;
            if (more)
                recover();
        }
    }
    if (!diagnostics_.has_errors())
        note_unused();
    finish_settings();
    SceneProgram program = builder_.finish_program();
    if (builder_.motion_failed() && !obstacle_)
        obstacle_.emplace().reason = "what moves is too much, or too long an expression, for motion programs";
    program.obstacle = std::move(obstacle_);
    return program;
}

/// Evaluates one item of the scene. False at the end.
bool Evaluator::item() {
    in_item_ = false;
    item_start_ = cursor_;
    if (graph_.is_crowded())
        collect_nodes();
    const Token& token = peek();
    in_item_ = true;
    item_start_ = cursor_;
    item_frames_ = frames_.size();
    if (token.kind == TokenKind::end_of_text)
        return false;
    if (token.kind == TokenKind::sphere_run) {
        emit_sphere_run();
    } else if (accept(Word::sphere)) {
        sphere_item(token);
    } else if (starts_shape()) {
        Shape shape = object();
        add_to_scene(shape, token);
    } else if (accept(Word::camera)) {
        builder_.set_camera(camera());
        if (has_camera_)
            warn(token, "this camera replaces the one before it");
        has_camera_ = true;
    } else if (accept(Word::background)) {
        background();
    } else if (accept(Word::sky_sphere)) {
        builder_.set_sky(sky_sphere());
    } else if (accept(Word::fog)) {
        builder_.add_fog(fog());
    } else if (accept(Word::global_settings)) {
        global_settings();
    } else {
        fail_unexpected("an object, a light, the camera, a setting or a directive");
    }
    return true;
}

/// Goes to the end of the item that holds the mistake: behind the brace that closes it, or to what looks like the next
/// item. Loops around it end after this round.
void Evaluator::recover() {
    nesting_ = 0;
    bare_nesting_ = SIZE_MAX;
    run_position_ = 0;
    element_ = {};
    while (in_item_ && frames_.size() > item_frames_)
        leave_frame();
    for (Loop& loop : loops_)
        loop.stopped = true;
    const Token* const first = program_->tokens.data();
    const Token* const start = item_start_ >= first && item_start_ <= cursor_ ? item_start_ : cursor_;
    const Token* target = nullptr;
    for (const Token* token = start; token < cursor_ && !target; ++token) {
        if (token->kind != TokenKind::left_brace || token->target == Token::no_target)
            continue;
        const Token* closing = first + token->target;
        if (closing >= cursor_)
            target = closing + 1;
        token = closing;
    }
    if (!target) {
        const bool at_end_of_item = cursor_->kind == TokenKind::right_brace || cursor_->kind == TokenKind::semicolon;
        const bool at_next_item = cursor_->kind == TokenKind::directive && cursor_ != start;
        if (cursor_->kind != TokenKind::end_of_text && !at_next_item)
            ++cursor_;
        for (target = cursor_; !at_end_of_item && target->kind != TokenKind::end_of_text &&
                               target->kind != TokenKind::directive && target->kind != TokenKind::sphere_run;
             ++target) {
            if (target->kind == TokenKind::semicolon || target->kind == TokenKind::right_brace) {
                ++target;
                break;
            }
            if (target->kind == TokenKind::word && target->index <= uint32_t(Word::global_settings))
                break;
            if (target->kind == TokenKind::left_brace && target->target != Token::no_target)
                target = first + target->target;
        }
    }
    cursor_ = target;
    // Leave the loops that the jump left.
    while (!loops_.empty() && (frames_.empty() || loops_.size() > frames_.back().loops) &&
           cursor_ > first + loops_.back().opener->index)
        loops_.pop_back();
}

void Evaluator::note_unused() {
    for (Symbol symbol = 0; symbol < scopes_.bindings().size(); ++symbol)
        for (const Binding& binding : scopes_.bindings()[symbol])
            if (!binding.used && !binding.predeclared)
                diagnostics_.note(binding.declared,
                                  fmt::format("'{}' is declared and not used", sources_.symbols.name(symbol)));
}

} // namespace proxima
