#include "step_generator.h"

#include "electronic_gearbox.h"

static eg_counter spindle;
static eg_gearbox gearbox;
static int64_t stepped; /* where the motor is */
static int64_t behind;
static bool alarm;

int32_t step_generator_start(const gearing *g, uint16_t spindle_timer) {
    eg_ratio ratios[2];
    const int64_t zeros[2] = { 0, 0 };
    eg_status status = eg_endless_ratio(-g->threads, g->gear_steps, g->teeth, g->spindle_counts, &ratios[0], 0);
    if (!status) status = eg_nearest_ratio(g->gear_steps_per_mm / g->feed_steps_per_mm, &ratios[1], 0);
    if (!status) status = eg_gearbox_init(&gearbox, 2, ratios, zeros, 0, 0);
    if (!status) status = eg_counter_init(&spindle, 16, spindle_timer, 0, 0);
    stepped = behind = 0;
    alarm = false;
    return status;
}

port step_generator_tick(uint16_t spindle_timer, int8_t feed_step) {
    port out = { 0, 0 };
    int64_t ways[2] = { 0, feed_step }, wanted = stepped;
    if (eg_counter_read(&spindle, spindle_timer, &ways[0]) || eg_gearbox_advance(&gearbox, 2, ways) ||
        eg_gearbox_position(&gearbox, &wanted, 0)) {
        alarm = true; /* a step that may be wrong is not sent */
        return out;
    }
    if (feed_step) {
        out.step |= FEED_BIT;
        if (feed_step < 0) out.direction |= FEED_BIT;
    }
    behind = wanted - stepped;
    if (behind) {
        /* One step a tick: what is left comes in the next ones. */
        out.step |= GEAR_BIT;
        if (behind < 0) out.direction |= GEAR_BIT;
        stepped += behind < 0 ? -1 : 1;
        behind = wanted - stepped;
    }
    return out;
}

int64_t step_generator_behind(void) {
    return behind;
}

bool step_generator_alarm(void) {
    return alarm;
}
