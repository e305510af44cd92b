// SPDX-License-Identifier: Apache-2.0
// What the motion programs of a script say about a time is what the script says itself at that time, bit for bit. The
// one exception, a turn by an angle that is 0 only at that time, may change the signs of zeros; random scripts do not
// meet it.
#include "tests/parser/evaluate.h"
#include "tests/parser/random_script.h"
#include "tests/parser/scene_numbers.h"

#include <cstdlib>
#include <ostream>

using namespace proxima;
using namespace proxima::testing;

namespace {

EvaluationSettings settings_at(const MotionTime& time, bool record) {
    EvaluationSettings settings;
    settings.time.clock = time.clock;
    settings.time.frame_number = time.frame_number;
    settings.time.clock_delta = time.clock_delta;
    settings.record_motion = record;
    settings.budget.steps = 1'000'000;
    return settings;
}

uint64_t first_seed() {
    const char* given = std::getenv("PROXIMA_TEST_SEED");
    return given ? std::strtoull(given, nullptr, 10) : 20'260'101;
}

size_t cases() {
    const char* given = std::getenv("PROXIMA_TEST_CASES");
    return given ? std::strtoull(given, nullptr, 10) : 2000;
}

struct Tally {
    size_t moved = 0;     ///< scenes that programs said
    size_t splines = 0;   ///< of them, those whose programs look splines up
    size_t left = 0;      ///< that were left to the script, which had something to say
    size_t mistaken = 0;  ///< in which the script finds a mistake at the other time
    size_t refused = 0;   ///< in which the script finds one now
    size_t obstacles = 0; ///< that had to be evaluated for every frame
};

std::ostream& operator<<(std::ostream& out, const Tally& tally) {
    return out << tally.moved << " moved (" << tally.splines << " with splines), " << tally.left
               << " left to the script, " << tally.mistaken << " mistakes, " << tally.obstacles
               << " looked at the time, " << tally.refused << " refused";
}

void compare_ways(const std::string& text, uint64_t seed, Tally& tally) {
    CAPTURE(seed);
    const MotionTime now{0.25, 3, 0.125}, then{0.625, 6, 0.125};
    Evaluated recorded = evaluate(text, settings_at(now, true));
    if (recorded.diagnostics.has_errors()) {
        ++tally.refused;
        return;
    }
    INFO(text);
    const Evaluated still = evaluate(text, settings_at(now, false));
    CHECK(likeness(numbers_of(recorded.scene), numbers_of(still.scene)) == Likeness::bits);
    const Evaluated direct = evaluate(text, settings_at(then, false));
    if (recorded.scene.obstacle) {
        CHECK(recorded.scene.motion.empty());
        ++tally.obstacles;
        return;
    }
    const bool moved = move(recorded.scene, then);
    if (direct.diagnostics.has_errors()) { // in something that reaches the picture, or not: then programs do not see it
        ++tally.mistaken;
    } else if (moved) {
        const Likeness found = likeness(numbers_of(recorded.scene), numbers_of(direct.scene));
        CHECK_MESSAGE(found == Likeness::bits, text);
        ++tally.moved;
        tally.splines += !recorded.scene.motion.splines.empty();
    } else {
        ++tally.left;
    }
}

} // namespace

TEST_CASE("motion: a random expression says the same by its program and by the script") {
    Tally tally;
    const uint64_t first = first_seed();
    MESSAGE("first seed " << first << " (PROXIMA_TEST_SEED)");
    for (uint64_t seed = first; seed < first + 2 * cases(); ++seed) {
        RandomScript script(seed);
        compare_ways(script.declarations() + "sphere { " + script.vector(3) + ", abs(" + script.number(5) + ")+0.1 }",
                     seed, tally);
    }
    MESSAGE(tally);
    CHECK(tally.obstacles < cases() / 50); // too long for a program
    CHECK(tally.moved > cases());
    CHECK(tally.refused < cases() / 50); // or its texts are not what they are meant to be
}

TEST_CASE("motion: a random script says the same by its programs and evaluated again") {
    Tally tally;
    const uint64_t first = first_seed();
    MESSAGE("first seed " << first << " (PROXIMA_TEST_SEED)");
    for (uint64_t seed = first; seed < first + cases(); ++seed)
        compare_ways(RandomScript(seed).scene(seed % 4 == 0), seed, tally);
    MESSAGE(tally);
    CHECK(tally.moved > cases() / 5);
    CHECK(tally.splines > cases() / 5);
    CHECK(tally.obstacles > 0);
    CHECK(tally.refused < cases() / 50);
}
