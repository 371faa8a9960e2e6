/* A realtime component of LinuxCNC's HAL: a workpiece spindle that follows a worm and an axial feed, exactly and in phase.
 *
 * Pins:   electronic-gearbox.enable        bit in    engages, and opens again
 *         electronic-gearbox.worm-counts   s32 in    rawcounts of the worm's encoder
 *         electronic-gearbox.feed-counts   s32 in    rawcounts of the feed slide's scale
 *         electronic-gearbox.gap           float in  where a tooth gap has to be, degrees a pitch; measured when the worm stands at 0
 *         electronic-gearbox.position-fb   float in  the spindle, degrees
 *         electronic-gearbox.position-cmd  float out where it has to be, degrees
 *         electronic-gearbox.coupled       bit out   in phase: the worm may come in
 *         electronic-gearbox.fault         bit out   it does not follow, or a counter was lost: stop the leading axes
 *         electronic-gearbox.state         u32 out   EG_OFF .. EG_FAULT
 * Module parameters: threads, teeth, worm_counts (a revolution), feed_counts (a metre), module_um, helix_mdeg, pressure_mdeg.
 *
 * addf electronic-gearbox.update THREAD, behind the encoders and before the position loop.
 *
 * Build (the archive first, as electronic_gearbox.h describes):
 *   cc -shared -fPIC -O2 -DRTAPI -DUSPACE -D__MODULE__ -I/usr/include/linuxcnc -I../../include \
 *      electronic_gearbox.c libelectronic_gearbox.a -o /usr/lib/linuxcnc/modules/electronic_gearbox.so
 */

#include "electronic_gearbox.h"

#include "rtapi.h"

#include "rtapi_app.h"

#include "hal.h"

MODULE_LICENSE("GPL"); /* as built with LinuxCNC's headers */

static int threads = 1, teeth = 40, worm_counts = 4096, feed_counts = 100000;
RTAPI_MP_INT(threads, "threads of the worm");
RTAPI_MP_INT(teeth, "teeth of the workpiece, negative for an internal gear");
RTAPI_MP_INT(worm_counts, "counts of a revolution of the worm");
RTAPI_MP_INT(feed_counts, "counts of the feed slide a metre");
static int module_um = 2500, helix_mdeg = 0, pressure_mdeg = 20000;
RTAPI_MP_INT(module_um, "normal module in 1/1000 mm");
RTAPI_MP_INT(helix_mdeg, "helix angle in 1/1000 degree, positive: right-handed");
RTAPI_MP_INT(pressure_mdeg, "normal pressure angle in 1/1000 degree");

/* Parts of a revolution in which the sum is kept: 1/10000 degree. */
#define PARTS 3600000
#define RADIANS(mdeg) ((mdeg) / 1000.0 * 3.14159265358979323846 / 180.0)

typedef struct {
    hal_bit_t *enable, *coupled, *fault;
    hal_s32_t *worm_counts, *feed_counts;
    hal_float_t *gap, *position_fb, *position_cmd;
    hal_u32_t *state;
    eg_counter worm, feed;
    eg_gearbox gearbox;
    eg_engagement engagement;
    eg_ratio ratios[2];
    int64_t leading[2]; /* counts in all since the set-up */
    double before;      /* position of the coupling in the last cycle, degrees */
    bool lost, was_enabled, asked;
} component;

static component *all;
static int id;

/* The coupling in degrees. */
static eg_status coupled_position(component *c, double *degrees) {
    int64_t counts;
    uint32_t fraction;
    const eg_status status = eg_gearbox_position(&c->gearbox, &counts, &fraction);
    *degrees = ((double)counts + fraction / 4294967296.0) * 360.0 / PARTS;
    return status;
}

static void update(void *arg, long period) {
    component *c = arg;
    const double step = period * 1e-9;
    int64_t ways[2] = { 0, 0 };
    if (eg_counter_read(&c->worm, (uint32_t)*c->worm_counts, &ways[0]) != EG_OK ||
        eg_counter_read(&c->feed, (uint32_t)*c->feed_counts, &ways[1]) != EG_OK) {
        c->lost = true;
    }
    c->leading[0] += ways[0];
    c->leading[1] += ways[1];
    eg_engagement_output output = { { 0.0, 0.0, 0.0 }, EG_OFF, EG_NO_WINDOW, false, false };
    double degrees = 0.0;
    if (eg_gearbox_advance(&c->gearbox, 2, ways) != EG_OK || coupled_position(c, &degrees) != EG_OK) c->lost = true;
    eg_motion motion = { degrees, (degrees - c->before) / step, 0.0 };
    if (*c->enable && !c->was_enabled) {
        /* The sum goes on from where the spindle stands; a lost counter is forgiven by engaging anew. */
        const int64_t stands = (int64_t)(*c->position_fb / 360.0 * PARTS);
        c->lost = eg_gearbox_init(&c->gearbox, 2, c->ratios, c->leading, stands, NULL) != EG_OK ||
                  coupled_position(c, &degrees) != EG_OK;
        motion.position = degrees;
        if (eg_engagement_engage(&c->engagement, &motion) != EG_OK) c->lost = true;
        c->asked = false;
    }
    if (!*c->enable && c->was_enabled) eg_engagement_switch_off(&c->engagement);
    c->was_enabled = *c->enable;
    const double error = *c->position_cmd - *c->position_fb;
    if (eg_engagement_update(&c->engagement, step, &motion, error, &output) != EG_OK) c->lost = true;
    if (output.follows) *c->position_cmd = motion.position + output.offset.position;
    if (output.state == EG_SYNCHRONISING && !c->asked) {
        /* The gap now: where it is with the worm at 0, and what worm and feed have turned it since. */
        const double turned = (double)c->leading[0] * c->ratios[0].numerator / c->ratios[0].denominator +
                              (double)c->leading[1] * c->ratios[1].numerator / c->ratios[1].denominator;
        const double target = *c->gap + turned * 360.0 / PARTS;
        c->asked = eg_engagement_synchronise(&c->engagement, *c->position_cmd, target, 360.0 / (teeth < 0 ? -teeth : teeth)) == EG_OK;
    }
    c->before = degrees;
    *c->state = output.state;
    *c->coupled = output.state == EG_COUPLED;
    *c->fault = output.stop_leading_axes || c->lost;
}

static int say(const char *what, const eg_error *error) {
    rtapi_print_msg(RTAPI_MSG_ERR, "electronic_gearbox: %s: %s: %s\n", what, eg_status_name(error->status),
                    eg_status_way_out(error->status));
    return -1;
}

static int set_up(component *c) {
    eg_error error;
    eg_couplings couplings;
    const eg_gear gear = { module_um / 1000.0, RADIANS(helix_mdeg), RADIANS(pressure_mdeg), teeth };
    const eg_engagement_settings settings = { 90.0, 3600.0, 0.01, 0.1, 0.05, 0.001 };
    if (eg_endless_ratio(-threads, PARTS, teeth, worm_counts, &c->ratios[0], &error)) return say("threads, teeth, worm_counts", &error);
    if (eg_gear_couplings(&gear, 1, 1.5, &couplings, &error)) return say("module_um, helix_mdeg, pressure_mdeg", &error);
    if (eg_nearest_ratio(couplings.feed / 360.0 * PARTS * 1000.0 / feed_counts, &c->ratios[1], &error)) return say("feed_counts", &error);
    if (eg_gearbox_init(&c->gearbox, 2, c->ratios, c->leading, 0, &error)) return say("ratios", &error);
    if (eg_counter_init(&c->worm, 32, 0, 0, &error) || eg_counter_init(&c->feed, 32, 0, 0, &error)) return say("counters", &error);
    if (eg_engagement_init(&c->engagement, &settings, &error)) return say("engagement", &error);
    return 0;
}

#define PIN(kind, direction, pin, name) \
    if (hal_pin_##kind##_newf(direction, &all->pin, id, "electronic-gearbox." name)) goto failed

int rtapi_app_main(void) {
    id = hal_init("electronic_gearbox");
    if (id < 0) return id;
    all = hal_malloc(sizeof *all); /* zeros */
    if (!all || set_up(all)) goto failed;
    PIN(bit, HAL_IN, enable, "enable");
    PIN(s32, HAL_IN, worm_counts, "worm-counts");
    PIN(s32, HAL_IN, feed_counts, "feed-counts");
    PIN(float, HAL_IN, gap, "gap");
    PIN(float, HAL_IN, position_fb, "position-fb");
    PIN(float, HAL_OUT, position_cmd, "position-cmd");
    PIN(bit, HAL_OUT, coupled, "coupled");
    PIN(bit, HAL_OUT, fault, "fault");
    PIN(u32, HAL_OUT, state, "state");
    if (hal_export_funct("electronic-gearbox.update", update, all, 1, 0, id)) goto failed;
    hal_ready(id);
    return 0;
failed:
    hal_exit(id);
    return -1;
}

void rtapi_app_exit(void) {
    hal_exit(id);
}
