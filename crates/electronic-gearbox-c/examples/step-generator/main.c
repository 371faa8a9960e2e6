/* The step generator on a board that is simulated: 30 kHz, a spindle that comes up to 300 1/min, a feed axis that goes to and fro with a
 * ramp. Motors count the bits of the port. Ends with status 0 if the gear axis was never more than a step from the exact place.
 *
 *   cc -I../../include main.c step_generator.c libelectronic_gearbox.a -lm && ./a.out
 */

#include "step_generator.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define TICKS_PER_SECOND 30000
#define SECONDS 20

int main(void) {
    const double pi = 3.14159265358979323846;
    const double lead = pi * 2.5 * 40.0 / sin(20.0 * pi / 180.0);
    const gearing g = { 3, 40, 2400, 51200, 51200.0 / lead, 400.0 };
    if (step_generator_start(&g, 65500)) return 2;

    double spindle = 0.0, feed = 0.0, speed = 0.0;
    int64_t feed_steps = 0, feed_motor = 0, gear_motor = 0;
    double largest = 0.0;
    int64_t most_behind = 0;
    for (int64_t tick = 1; tick <= (int64_t)TICKS_PER_SECOND * SECONDS; ++tick) {
        const double time = (double)tick / TICKS_PER_SECOND;
        /* The spindle, counts; up to speed in 2 s. */
        spindle += 12000.0 * fmin(time / 2.0, 1.0) / TICKS_PER_SECOND;
        const int64_t counts = (int64_t)floor(spindle);
        /* The feed, steps: 5 mm/s, turned every 4 s, 50 mm/s^2. */
        const double wanted = fmod(time, 8.0) < 4.0 ? 2000.0 : -2000.0;
        const double ramp = 20000.0 / TICKS_PER_SECOND;
        speed += fmax(-ramp, fmin(ramp, wanted - speed));
        feed += speed / TICKS_PER_SECOND;
        const int64_t due = (int64_t)floor(feed);
        const int8_t step = (int8_t)((due > feed_steps) - (due < feed_steps));
        feed_steps += step;

        const port out = step_generator_tick((uint16_t)((uint64_t)counts + 65500), step);
        if (out.step & FEED_BIT) feed_motor += out.direction & FEED_BIT ? -1 : 1;
        if (out.step & GEAR_BIT) gear_motor += out.direction & GEAR_BIT ? -1 : 1;

        /* By another way: the exact place of both axes as a floating number, from the counts in all. */
        const double exact = -3.0 / 40.0 * 51200.0 * (double)counts / 2400.0 + 51200.0 / lead * (double)feed_motor / 400.0;
        largest = fmax(largest, fabs((double)gear_motor + 0.5 - exact));
        const int64_t behind = llabs(step_generator_behind());
        if (behind > most_behind) most_behind = behind;
        if (step_generator_alarm()) return 3;
    }
    printf("spindle %.0f counts, feed %lld steps, gear %lld steps; at most %.3f steps from the exact place, %lld behind\n", floor(spindle),
           (long long)feed_motor, (long long)gear_motor, largest, (long long)most_behind);
    return largest < 1.51 && most_behind <= 1 ? 0 : 1;
}
