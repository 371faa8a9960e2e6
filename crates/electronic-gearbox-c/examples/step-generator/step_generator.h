/* A step generator in the manner of grbl: one timer interrupt at a fixed rate puts step and direction bits on a port. The gear axis
 * follows the spindle's encoder and the steps of the feed axis through the electronic gearbox. */
#ifndef STEP_GENERATOR_H
#define STEP_GENERATOR_H

#include <stdbool.h>
#include <stdint.h>

enum { FEED_BIT = 1, GEAR_BIT = 2 };

/* What the interrupt leaves on the port. */
typedef struct {
    uint8_t step;      /* bits of the axes that step in this tick */
    uint8_t direction; /* bits of the axes that go backwards */
} port;

typedef struct {
    int64_t threads, teeth;
    int64_t spindle_counts;   /* a revolution of the spindle */
    int64_t gear_steps;       /* a revolution of the gear axis */
    double gear_steps_per_mm; /* of feed: gear_steps / lead, negative for a left-hand gear */
    double feed_steps_per_mm;
} gearing;

/* Returns 0, or the eg_status that says why not. */
int32_t step_generator_start(const gearing *g, uint16_t spindle_timer);
/* The interrupt: the spindle's timer as it stands, the feed step that the planner wants in this tick (+1, -1, 0). */
port step_generator_tick(uint16_t spindle_timer, int8_t feed_step);
/* Steps that the gear axis is behind: more than one or two means that the spindle is too fast for the interrupt. */
int64_t step_generator_behind(void);
/* Whether a counter was lost or the sum left its range: the feed has to stop. */
bool step_generator_alarm(void);

#endif
