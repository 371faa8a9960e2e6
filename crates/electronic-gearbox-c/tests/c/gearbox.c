/* The C interface from C: what it computes beside arithmetic of this file's own, and what it refuses. Ends with status 0 if all is right;
 * tests/c.rs compiles, links and runs it. */

#include "electronic_gearbox.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                                   \
    do {                                                                   \
        if (!(condition)) {                                                \
            printf("line %d: %s\n", __LINE__, #condition);                 \
            ++failures;                                                    \
        }                                                                  \
    } while (0)

static bool says(eg_text text, const char *wanted) {
    return text.length == strlen(wanted) && memcmp(text.start, wanted, text.length) == 0;
}

static int64_t floor_div(int64_t numerator, int64_t denominator) {
    int64_t quotient = numerator / denominator;
    return quotient - (numerator % denominator != 0 && numerator < 0);
}

/* Two axes against the floor of the exact sum, with reversals. */
static void gearbox(void) {
    eg_ratio ratios[2];
    CHECK(eg_endless_ratio(-3, 36000, 47, 8192, &ratios[0], NULL) == EG_OK);
    CHECK(ratios[0].numerator == -3375 && ratios[0].denominator == 12032);
    ratios[1] = (eg_ratio){ 7, 30 };
    int64_t at[2] = { 5, -9 };
    const int64_t start[2] = { 5, -9 };
    eg_gearbox box;
    CHECK(eg_gearbox_init(&box, 2, ratios, start, 100, NULL) == EG_OK);
    uint32_t draw = 1;
    for (int i = 0; i < 100000; ++i) {
        draw = draw * 1664525u + 1013904223u;
        const int64_t steps[2] = { (int64_t)(draw >> 28) - 3, (int64_t)(draw >> 20 & 15) - 8 };
        at[0] += steps[0];
        at[1] += steps[1];
        CHECK(eg_gearbox_advance(&box, 2, steps) == EG_OK);
        int64_t counts;
        uint32_t fraction;
        CHECK(eg_gearbox_position(&box, &counts, &fraction) == EG_OK);
        /* Over the common denominator. */
        const int64_t sum = -3375 * 30 * (at[0] - start[0]) + 7 * 12032 * (at[1] - start[1]);
        const int64_t exact = 100 + floor_div(sum, 12032 * 30);
        const double rest = (double)(sum - floor_div(sum, 12032 * 30) * 12032 * 30) / (12032 * 30);
        /* The fraction is rounded down, by less than two units: a rest of 0 may show as the count before and almost 1. */
        const double error = (double)(counts - exact) + fraction / 4294967296.0 - rest;
        CHECK(error <= 0.0 && error > -2.0 / 4294967296.0 - 1e-15);
        if (failures > 10) return;
    }

    eg_error error;
    const eg_ratio bad[2] = { { 1, 0 }, { 1, 1 } };
    CHECK(eg_gearbox_init(&box, 2, bad, start, 0, &error) == EG_GEAR_RANGE);
    CHECK(error.status == EG_GEAR_RANGE && error.value == 0.0 && says(error.name, "denominator d"));
    CHECK(eg_gearbox_init(&box, 0, ratios, start, 0, &error) == EG_BAD_PARAMETER && says(error.allowed, "1 to 8"));
    CHECK(eg_gearbox_init(&box, 9, ratios, start, 0, NULL) != EG_OK);
    CHECK(eg_gearbox_init(NULL, 2, ratios, start, 0, NULL) == EG_NULL_POINTER);
    CHECK(eg_gearbox_init(&box, 2, NULL, start, 0, NULL) == EG_NULL_POINTER);
    /* What was refused leaves what was there. */
    CHECK(eg_gearbox_advance(&box, 1, start) == EG_BAD_PARAMETER);
    CHECK(eg_gearbox_advance(&box, 2, NULL) == EG_NULL_POINTER);
    CHECK(eg_gearbox_advance(&box, 2, start) == EG_OK);
    CHECK(eg_gearbox_position(&box, NULL, NULL) == EG_NULL_POINTER);
    eg_gearbox empty;
    memset(&empty, 0, sizeof empty);
    CHECK(eg_gearbox_advance(&empty, 2, start) == EG_NOT_INITIALISED);
    memset(&empty, 0xa5, sizeof empty);
    CHECK(eg_gearbox_advance(&empty, 2, start) == EG_NOT_INITIALISED);
    /* Each number of axes: the sum of as many equal axes. */
    for (size_t axes = 1; axes <= EG_MOST_AXES; ++axes) {
        eg_ratio equal[EG_MOST_AXES];
        int64_t zeros[EG_MOST_AXES] = { 0 }, steps[EG_MOST_AXES];
        for (size_t i = 0; i < axes; ++i) {
            equal[i] = (eg_ratio){ 3, 1 };
            steps[i] = (int64_t)i + 1;
        }
        int64_t counts;
        CHECK(eg_gearbox_init(&box, axes, equal, zeros, 0, NULL) == EG_OK);
        CHECK(eg_gearbox_advance(&box, axes, steps) == EG_OK);
        CHECK(eg_gearbox_position(&box, &counts, NULL) == EG_OK);
        CHECK(counts == (int64_t)(3 * axes * (axes + 1) / 2));
        CHECK(eg_gearbox_advance(&box, axes % EG_MOST_AXES + 1, steps) == EG_BAD_PARAMETER);
    }
}

static void counters(void) {
    eg_counter counter;
    int64_t way, sum = 0;
    CHECK(eg_counter_init(&counter, 16, 65000, 0, NULL) == EG_OK);
    for (int i = 1; i <= 1000; ++i) {
        CHECK(eg_counter_read(&counter, (65000 + 777 * i) & 0xffff, &way) == EG_OK);
        sum += way;
    }
    CHECK(sum == 777000);
    CHECK(eg_counter_read(&counter, (65000 + 777000 + 0x8000) & 0xffff, &way) == EG_ENCODER_JUMP);
    CHECK(eg_counter_read(NULL, 0, &way) == EG_NULL_POINTER);
    eg_error error;
    CHECK(eg_counter_init(&counter, 65, 0, 0, &error) == EG_BAD_PARAMETER);
    CHECK(error.value == 65.0 && says(error.name, "width of the counter") && says(error.allowed, "2 to 64 bits"));
    CHECK(eg_counter_init(&counter, 16, 0, 10, NULL) == EG_OK);
    CHECK(eg_counter_read(&counter, 11, &way) == EG_ENCODER_JUMP);
    CHECK(eg_counter_read(&counter, 1, &way) == EG_OK && way == -10);
}

static void line(void) {
    eg_line line;
    CHECK(eg_line_init(&line, -101, 370, NULL) == EG_OK);
    int64_t at = 0, follower = 0;
    for (int i = 0; i < 100000; ++i) {
        const int32_t pulse = i / 777 % 3 == 2 ? -1 : 1;
        int32_t sent;
        CHECK(eg_line_pulse(&line, pulse, &sent) == EG_OK);
        at += pulse;
        follower += sent;
        CHECK(follower == floor_div(-101 * at, 370));
        if (failures > 10) return;
    }
    int32_t sent;
    CHECK(eg_line_pulse(&line, 0, &sent) == EG_BAD_CHOICE);
    CHECK(eg_line_init(&line, 2, 1, NULL) == EG_GEAR_RANGE);
}

/* The seed's case: intervals of 160 ticks, 16 pulses each; a longer interval pauses, a shorter one has its missing pulses after it. */
static void interpolator(void) {
    eg_interpolator pulses;
    eg_rotation rotation;
    eg_interpolator_status state;
    int32_t pulse, turned;
    uint32_t kind;
    int64_t net = 0, parts = 0;
    int inserted[5] = { 0 };
    const int lines[] = { 100, 260, 420, 660, 740 };
    CHECK(eg_interpolator_init(&pulses, 16, EG_COUNTER_LIMIT, EG_ONE_WAY, NULL) == EG_OK);
    CHECK(eg_rotation_init(&rotation, 131072, EG_BRESENHAM, 1, 16, NULL) == EG_OK);
    int next = 0;
    for (int tick = 1; tick <= 2000; ++tick) {
        const int32_t reference = next < 5 && lines[next] == tick;
        next += reference;
        CHECK(eg_interpolator_tick(&pulses, reference, &pulse, &kind) == EG_OK);
        CHECK((pulse != 0) == (kind != EG_NONE) && (kind == EG_REFERENCE) == (reference == 1));
        if (next > 0 && kind == EG_INTERMEDIATE) inserted[next - 1] += 1;
        net += pulse;
        CHECK(eg_rotation_pulse(&rotation, pulse, &turned) == EG_OK);
        parts += turned;
    }
    /* The first interval has no pace, the second 15 at every 10th tick, the pause of the third adds none, the fourth is cut short. */
    CHECK(inserted[0] == 0 && inserted[1] == 15 - 1 && inserted[2] == 15 && inserted[3] == 5);
    CHECK(net == 5 * 16);
    CHECK(parts == 40);
    int64_t coarse;
    uint32_t fine;
    CHECK(eg_rotation_position(&rotation, &coarse, &fine) == EG_OK && coarse == 2 && fine == 8);
    CHECK(eg_interpolator_status_of(&pulses, &state) == EG_OK);
    CHECK(state.references == 5 && state.too_fast == 0 && state.pending == 0);

    eg_error error;
    CHECK(eg_interpolator_init(&pulses, 257, 100, EG_NO_BACKLASH, &error) == EG_BAD_MULTIPLIER);
    CHECK(error.value == 257.0 && says(error.allowed, "2 to 256"));
    CHECK(eg_interpolator_init(&pulses, 16, 100, 3, NULL) == EG_BAD_CHOICE);
    CHECK(eg_interpolator_tick(&pulses, 2, &pulse, NULL) == EG_BAD_CHOICE);
    CHECK(eg_rotation_init(&rotation, 1 << 18, EG_BINARY, 1, 16, &error) == EG_BAD_PARAMETER && says(error.name, "B"));
    CHECK(eg_rotation_init(&rotation, 1, EG_BINARY, 0, 16, NULL) == EG_BAD_CHOICE);
}

static void gear(void) {
    const double pi = 3.14159265358979323846;
    const eg_gear gear = { 2.5, 20.0 * pi / 180.0, 20.0 * pi / 180.0, 40 };
    eg_coefficient coefficient;
    eg_couplings couplings;
    eg_error error;
    CHECK(eg_gear_coefficient(&gear, 36000, 1e5, false, &coefficient, NULL) == EG_OK);
    const double b = 1000.0 * 36000.0 * sin(20.0 * pi / 180.0) / (pi * 2.5 * 40.0 * 1e5);
    CHECK(fabs(coefficient.exact - b) < 1e-15 && coefficient.word == (uint32_t)lround(b * 262144.0) && coefficient.hand == 1);
    CHECK(eg_gear_coefficient(&gear, 36000, 1e5, true, &coefficient, NULL) == EG_OK && coefficient.hand == -1);
    CHECK(eg_gear_coefficient(&gear, 36000, 1e3, false, &coefficient, &error) == EG_COEFFICIENT_TOO_LARGE && error.value > 1.0);
    CHECK(eg_gear_couplings(&gear, 3, 87.0 * pi / 180.0, &couplings, NULL) == EG_OK);
    CHECK(couplings.worm_turn == -3.0 / 40.0 && fabs(couplings.feed - 360.0 * sin(20.0 * pi / 180.0) / (pi * 100.0)) < 1e-15);
    const eg_gear none = { 2.5, 0.3, 0.3, 0 };
    CHECK(eg_gear_couplings(&none, 3, 1.5, &couplings, &error) == EG_BAD_GEAR && says(error.name, "number of teeth"));
    CHECK(says(error.allowed, "not 0") && strcmp(eg_status_name(error.status), "bad-gear") == 0);
    CHECK(strlen(eg_status_way_out(error.status)) > 10 && strcmp(eg_status_name(99), "unknown-status") == 0);
    eg_ratio ratio;
    CHECK(eg_nearest_ratio(-0.375, &ratio, NULL) == EG_OK && ratio.numerator == -3 && ratio.denominator == 8);
    CHECK(eg_nearest_ratio(NAN, &ratio, NULL) == EG_BAD_PARAMETER);
}

static void curves(void) {
    eg_polynomial polynomial;
    const double coefficients[3] = { 1.0, -2.0, 3.0 };
    double value, slope;
    CHECK(eg_polynomial_init(&polynomial, coefficients, 3, NULL) == EG_OK);
    CHECK(eg_polynomial_value(&polynomial, 2.0, &value, &slope) == EG_OK && value == 9.0 && slope == 10.0);
    CHECK(eg_polynomial_value(&polynomial, INFINITY, &value, NULL) == EG_BAD_PARAMETER);
    CHECK(eg_polynomial_init(&polynomial, coefficients, 9, NULL) == EG_BAD_PARAMETER);

    enum { KNOTS = 73 };
    static double values[KNOTS], slopes[KNOTS], workspace[2 * KNOTS];
    const double turn = 6.28318530717958647692;
    for (int i = 0; i < KNOTS - 1; ++i) values[i] = sin(turn * i / (KNOTS - 1));
    values[KNOTS - 1] = values[0];
    eg_table table;
    CHECK(eg_table_init(&table, 0.0, 5.0, values, slopes, KNOTS, EG_PERIODIC, workspace, NULL) == EG_OK);
    for (double x = -720.0; x < 720.0; x += 1.7) {
        CHECK(eg_table_value(&table, x, &value, &slope) == EG_OK);
        CHECK(fabs(value - sin(turn * x / 360.0)) < 2e-7 && fabs(slope - turn / 360.0 * cos(turn * x / 360.0)) < 2e-6);
    }
    eg_error error;
    CHECK(eg_table_init(&table, 0.0, -5.0, values, slopes, KNOTS, EG_PERIODIC, workspace, &error) == EG_BAD_TABLE);
    CHECK(error.value == -5.0 && says(error.name, "distance of knots"));
    CHECK(eg_table_init(&table, 0.0, 5.0, values, slopes, KNOTS, 2, workspace, NULL) == EG_BAD_CHOICE);
    CHECK(eg_table_init(&table, 0.0, 5.0, values, NULL, KNOTS, EG_NATURAL, workspace, NULL) == EG_NULL_POINTER);
    CHECK(eg_table_init(&table, 0.0, 5.0, values, slopes, (size_t)-1, EG_NATURAL, workspace, NULL) == EG_BAD_PARAMETER);
}

/* A leading axis of constant speed: the follower ends in phase, and no step of it is faster than the limits allow. */
static void engagement(void) {
    const eg_engagement_settings settings = { 90.0, 1800.0, 0.01, 0.1, 0.05, 0.001 };
    const double step = 1e-3, speed = -450.0, pitch = 9.0;
    eg_engagement engagement;
    eg_engagement_output output;
    CHECK(eg_engagement_init(&engagement, &settings, NULL) == EG_OK);
    eg_motion coupled = { 0.0, speed, 0.0 };
    CHECK(eg_engagement_synchronise(&engagement, 0.0, 4.0, pitch) == EG_NOT_ENGAGED);
    CHECK(eg_engagement_engage(&engagement, &coupled) == EG_OK);
    CHECK(eg_engagement_engage(&engagement, &coupled) == EG_BUSY);
    double offset = 0.0, before = 0.0;
    bool told = false;
    int cycles = 0;
    for (; cycles < 3000; ++cycles) {
        coupled.position = speed * step * (cycles + 1);
        CHECK(eg_engagement_update(&engagement, step, &coupled, 0.0, &output) == EG_OK);
        CHECK(output.follows && !output.stop_leading_axes);
        offset = output.offset.position;
        const double way = speed * step + offset - before;
        CHECK(fabs(way) <= (fabs(speed) + settings.phase_speed) * step + 1e-9);
        before = offset;
        if (output.state == EG_SYNCHRONISING && !told) {
            /* The gap lies where the coupling would be from 1.25 degrees. */
            CHECK(eg_engagement_synchronise(&engagement, coupled.position + offset, coupled.position + 1.25, pitch) == EG_OK);
            told = true;
        }
        if (output.state == EG_COUPLED) break;
    }
    CHECK(output.state == EG_COUPLED && output.window == EG_NO_WINDOW);
    const double off = fmod(fmod(offset - 1.25, pitch) + pitch, pitch);
    CHECK(fmin(off, pitch - off) < 1e-9);
    /* Outside the coarse window for longer than allowed: the leading axes have to stop. */
    for (int i = 0; i < 60; ++i) {
        coupled.position += speed * step;
        CHECK(eg_engagement_update(&engagement, step, &coupled, 0.2, &output) == EG_OK);
    }
    CHECK(output.state == EG_FAULT && output.stop_leading_axes);
    CHECK(eg_engagement_switch_off(&engagement) == EG_OK);
    coupled.speed = 0.0;
    CHECK(eg_engagement_update(&engagement, step, &coupled, 0.0, &output) == EG_OK);
    CHECK(output.state == EG_OFF && !output.follows);
    eg_error error;
    const eg_engagement_settings bad = { -1.0, 1800.0, 0.01, 0.1, 0.05, 0.001 };
    CHECK(eg_engagement_init(&engagement, &bad, &error) == EG_BAD_PARAMETER && error.value == -1.0);
    CHECK(eg_engagement_update(&engagement, 0.0, &coupled, 0.0, &output) == EG_BAD_PARAMETER);
    CHECK(eg_engagement_update(&engagement, step, NULL, 0.0, &output) == EG_NULL_POINTER);
}

int main(void) {
    gearbox();
    counters();
    line();
    interpolator();
    gear();
    curves();
    engagement();
    printf("%d failures\n", failures);
    return failures != 0;
}
