/* The electronic gearbox for programs in C and C++: pulses between the lines of a scale, exact sums of leading axes, curves, engagement.
 *
 * Nothing is allocated and nothing blocks: the caller owns the storage, every call takes a bounded time. Functions return EG_OK or
 * what is wrong. The _init functions and those that compute ratios also fill an eg_error with the value that was refused, unless the
 * pointer is NULL. An object must be used by one context (thread or interrupt) at a time; objects do not share anything.
 *
 * Set-up:  cargo build --release, in crates/electronic-gearbox-c/archive, makes libelectronic_gearbox.a; for a microcontroller add e.g.
 *          --target thumbv7em-none-eabihf. Link it behind your objects: cc main.c libelectronic_gearbox.a
 */
#ifndef ELECTRONIC_GEARBOX_H
#define ELECTRONIC_GEARBOX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- How a call went ---- */

typedef int32_t eg_status;
enum {
    EG_OK = 0,
    EG_BAD_MULTIPLIER = 1,        /* pulses per interval or limit of the period counter */
    EG_BAD_PARAMETER = 2,         /* a number outside its range */
    EG_BAD_REFERENCE = 3,         /* a reference pulse that cannot be */
    EG_COEFFICIENT_TOO_LARGE = 4, /* b beyond a rate multiplier */
    EG_SPUR_GEAR = 5,             /* a spur gear has no lead */
    EG_BAD_GEAR = 6,              /* gear data that describe no gear */
    EG_GEAR_RANGE = 7,            /* a ratio, position or sum beyond the accumulators */
    EG_ENCODER_JUMP = 8,          /* a counter moved too far between two readings */
    EG_BAD_TABLE = 9,             /* a table that cannot be interpolated */
    EG_BUSY = 10,                 /* the coupling is closed */
    EG_NOT_ENGAGED = 11,          /* the coupling is open */
    EG_NULL_POINTER = 12,
    EG_NOT_INITIALISED = 13,      /* storage that no _init function has filled */
    EG_BAD_CHOICE = 14            /* a number that is none of the constants below */
};

/* A text that does not end with 0: printf("%.*s", (int)text.length, text.start). */
typedef struct {
    const char *start;
    size_t length;
} eg_text;

typedef struct {
    eg_status status;
    eg_text name;    /* of the value that was refused; empty if it was none */
    double value;
    eg_text allowed; /* what it may be */
} eg_error;

const char *eg_status_name(eg_status status);    /* e.g. "gear-range" */
const char *eg_status_way_out(eg_status status); /* what helps, in one sentence */

/* ---- Gear data to ratios; for the set-up, not for the loop ---- */

typedef struct {
    double normal_module_mm;          /* > 0 */
    double helix_angle_rad;           /* > 0 right-handed, 0 spur */
    double normal_pressure_angle_rad; /* 0 to pi/2, exclusive */
    int32_t teeth;                    /* < 0 internal */
} eg_gear;

/* Workpiece pulses per pulse of the feed scale. */
typedef struct {
    double exact;
    uint32_t word; /* round(exact 2^18), for eg_rotation_init */
    int32_t hand;  /* +1 or -1, for eg_rotation_init */
} eg_coefficient;

/* Turn of the workpiece: degrees a degree of the worm, a mm of feed, a mm of shift. Negate what your machine counts the other way. */
typedef struct {
    double worm_turn;
    double feed;
    double shift;
} eg_couplings;

/* |numerator| < 2^62, 0 < denominator <= 2^62. */
typedef struct {
    int64_t numerator;
    int64_t denominator;
} eg_ratio;

eg_status eg_gear_coefficient(const eg_gear *gear, uint32_t pulses_per_revolution, double pulses_per_metre, bool reversed,
                              eg_coefficient *coefficient, eg_error *error);
eg_status eg_gear_couplings(const eg_gear *gear, uint32_t worm_starts, double worm_helix_angle_rad, eg_couplings *couplings,
                            eg_error *error);
/* Counts of the workpiece a count of the tool, z_1 N_w/(z_2 N_s), exact and in lowest terms: for rotations without end. Signs may stand
 * at any of the four. */
eg_status eg_endless_ratio(int64_t tool_starts, int64_t workpiece_counts, int64_t workpiece_teeth, int64_t tool_counts,
                           eg_ratio *ratio, eg_error *error);
/* The next fraction over a power of two, off by less than 2^-61: for axes of finite travel, as a lead. |value| < 2^61. */
eg_status eg_nearest_ratio(double value, eg_ratio *ratio, eg_error *error);

/* ---- Counters of 2 to 64 bits that wrap ---- */

typedef struct {
    uint64_t storage[4];
} eg_counter;

/* largest_step: greatest way between two readings that the axis can make, 0 for half the range of the counter. */
eg_status eg_counter_init(eg_counter *counter, uint32_t bits, uint64_t first, uint32_t largest_step, eg_error *error);
/* The signed way since the reading before. After EG_ENCODER_JUMP the way is lost, the next reading starts from this one. */
eg_status eg_counter_read(eg_counter *counter, uint64_t value, int64_t *way);

/* ---- Leading axes, summed exactly: y = y_0 + sum ratio_i (x_i - x_i0) ---- */

#define EG_MOST_AXES 8

typedef struct {
    uint64_t storage[64];
} eg_gearbox;

/* Closed at these positions of the leading axes, with the follower where it stands: no jump. */
eg_status eg_gearbox_init(eg_gearbox *gearbox, size_t axes, const eg_ratio *ratios, const int64_t *leading, int64_t follower,
                          eg_error *error);
/* The leading axes move by `steps` counts; `axes` as at the set-up. After an error nothing has moved. */
eg_status eg_gearbox_advance(eg_gearbox *gearbox, size_t axes, const int64_t *steps);
/* Where the follower has to be: counts, rounded down, and the rest in counts/2^32 (NULL if it is of no use). */
eg_status eg_gearbox_position(eg_gearbox *gearbox, int64_t *counts, uint32_t *fraction);

/* One leading axis that moves pulse by pulse, |numerator| <= denominator: for step generators. */
typedef struct {
    uint64_t storage[8];
} eg_line;

eg_status eg_line_init(eg_line *line, int64_t numerator, int64_t denominator, eg_error *error);
/* One pulse, +1 or -1; the follower's pulse, +1, -1, or 0 for none. */
eg_status eg_line_pulse(eg_line *line, int32_t pulse, int32_t *sent);

/* ---- Pulses between the lines of a scale ---- */

enum {
    EG_NO_BACKLASH = 0, /* both directions show the same position; for machines */
    EG_ONE_WAY = 1,     /* for work in one direction */
    EG_LITERAL = 2      /* loses pulses at quick reversals; only to show that */
};
enum { EG_NONE = 0, EG_REFERENCE = 1, EG_INTERMEDIATE = 2, EG_CORRECTION = 3 };
#define EG_COUNTER_LIMIT 16777215u /* of a period counter of 24 bits */

typedef struct {
    uint64_t storage[16];
} eg_interpolator;

typedef struct {
    uint64_t references;
    uint64_t overruns;              /* alarm: stop the feed when it grows */
    uint64_t too_fast;              /* alarm: stop the feed when it grows */
    uint64_t overruns_at_reversals; /* no alarm */
    uint64_t short_reversals;       /* no alarm */
    int64_t pending;                /* corrections still to be sent, with their sign */
    uint32_t inserted;              /* intermediate pulses of the running interval */
    uint32_t spacing;               /* their distance in ticks, 0 while it is not known */
} eg_interpolator_status;

eg_status eg_interpolator_init(eg_interpolator *interpolator, uint32_t pulses_per_interval, uint32_t counter_limit, uint32_t mode,
                               eg_error *error);
/* One tick of the clock with the reference pulse in it, +1, -1 or 0; the pulse that goes out, and its origin (NULL if of no use). */
eg_status eg_interpolator_tick(eg_interpolator *interpolator, int32_t reference, int32_t *pulse, uint32_t *kind);
eg_status eg_interpolator_status_of(eg_interpolator *interpolator, eg_interpolator_status *answer);

/* ---- Rate multipliers, hand switch, split into whole workpiece pulses and their rest ---- */

enum { EG_BRESENHAM = 0, EG_BINARY = 1 };

typedef struct {
    uint64_t storage[12];
} eg_rotation;

eg_status eg_rotation_init(eg_rotation *rotation, uint32_t word, uint32_t rule, int32_t hand, uint32_t parts, eg_error *error);
/* One pulse of the interpolator, +1, -1 or 0; by how many parts 1/P it turns the workpiece. */
eg_status eg_rotation_pulse(eg_rotation *rotation, int32_t pulse, int32_t *turned);
/* Whole workpiece pulses, rounded down, and the rest in parts, 0 to P - 1. */
eg_status eg_rotation_position(eg_rotation *rotation, int64_t *coarse, uint32_t *fine);

/* ---- Couplings by a polynomial or a table ---- */

typedef struct {
    uint64_t storage[10];
} eg_polynomial;

/* 1 to 8 coefficients, from c_0 upwards. */
eg_status eg_polynomial_init(eg_polynomial *polynomial, const double *coefficients, size_t count, eg_error *error);
/* Value and derivative (NULL if it is of no use). */
eg_status eg_polynomial_value(eg_polynomial *polynomial, double x, double *value, double *derivative);

enum { EG_NATURAL = 0, EG_PERIODIC = 1 };

typedef struct {
    uint64_t storage[10];
} eg_table;

/* A cubic spline through values at start + i spacing. `values` and `slopes` (room for `count` numbers each, filled here) have to stay
 * as they are for as long as the table is used; `workspace` is room for 2 count numbers during this call. EG_NATURAL holds the end
 * values beyond the ends, EG_PERIODIC repeats and needs the last value equal to the first. */
eg_status eg_table_init(eg_table *table, double start, double spacing, const double *values, double *slopes, size_t count,
                        uint32_t ends, double *workspace, eg_error *error);
eg_status eg_table_value(eg_table *table, double x, double *value, double *derivative);

/* ---- Engagement: up to speed, into the gap, watched, and out again ---- */

enum { EG_OFF = 0, EG_RAMPING = 1, EG_SYNCHRONISING = 2, EG_COUPLED = 3, EG_LEAVING = 4, EG_FAULT = 5 };
enum { EG_NO_WINDOW = 0, EG_FINE = 1, EG_COARSE = 2, EG_OUTSIDE = 3 };

typedef struct {
    uint64_t storage[40];
} eg_engagement;

/* In the follower's unit (degrees or counts, one for all) and seconds. */
typedef struct {
    double phase_speed;      /* greatest speed of the phase move, on top of the coupling */
    double acceleration;     /* greatest acceleration of ramps and phase move */
    double fine_window;      /* following error up to which the coupling counts as exact */
    double coarse_window;    /* greatest following error allowed */
    double fault_time;       /* how long it may be outside */
    double standstill_speed; /* of the coupling, up to which the leading axes count as standing */
} eg_engagement_settings;

typedef struct {
    double position;
    double speed;
    double acceleration;
} eg_motion;

typedef struct {
    eg_motion offset;       /* to be added to the gearbox's position and its rates */
    uint32_t state;         /* EG_OFF .. EG_FAULT */
    uint32_t window;        /* EG_NO_WINDOW .. EG_OUTSIDE */
    bool follows;           /* false: the coupling is open, the follower is free */
    bool stop_leading_axes; /* the leading axes have to stop, each by its own ramp */
} eg_engagement_output;

eg_status eg_engagement_init(eg_engagement *engagement, const eg_engagement_settings *settings, eg_error *error);
/* Begins to bring the follower, which stands, up to the coupling's speed. */
eg_status eg_engagement_engage(eg_engagement *engagement, const eg_motion *coupled);
/* Where the follower is, where it would have to be at that moment, give or take multiples of the pitch. */
eg_status eg_engagement_synchronise(eg_engagement *engagement, double position, double target, double pitch);
eg_status eg_engagement_switch_off(eg_engagement *engagement);
/* One cycle of `step` seconds. */
eg_status eg_engagement_update(eg_engagement *engagement, double step, const eg_motion *coupled, double following_error,
                               eg_engagement_output *output);

#ifdef __cplusplus
}
#endif

#endif
