/* Motion: `motion.h` says what of. */
#include "motion.h"

#include <stdlib.h>
#include <string.h>

#include "vectors.h"

#define ROBOT_WORK 20.0   /* units of work that a robot takes in a step, */
#define OBJECT_WORK 150.0 /* and the object */

/* -- wind and water ------------------------------------------------------------------------------ */

/* Move a wrench about midship, of a force that acts `arm` forward of it, to the origin. */
static void at_origin(const Afloat *hull, double surge, double sway, double arm, double *wrench) {
    wrench[0] = surge;
    wrench[1] = sway;
    wrench[2] = (hull->midship_x + arm) * sway - hull->midship_y * surge;
}

/* The wrench of air that moves at (x, y) over the object, by Blendermann's formulas. */
static void wind_wrench(const Afloat *hull, double x, double y, double *wrench) {
    double speed = sqrt(x * x + y * y);
    if (speed == 0.0) {
        memset(wrench, 0, 3 * sizeof *wrench);
        return;
    }
    double c = -x / speed, s = y / speed, bearing = atan2(fabs(y), -x); /* comes from there */
    double along = (c >= 0.0 ? hull->bow : hull->stern) * hull->frontal, twice = 2.0 * s * c;
    double excess = 1.0 - 0.5 * hull->cross * (1.0 - along / hull->lateral) * twice * twice;
    double pressure = hull->air * speed * speed / excess;
    double arm = hull->air_x - 0.18 * (bearing - 0.5 * PI) * hull->length;
    at_origin(hull, -pressure * along * c, pressure * hull->lateral * s, arm, wrench);
}

/* What water exerts on an object that moves at (u, v) at midship and turns at r, beyond what it does
 * on one that does not turn: the strips' cross-flow drag, added up along the length. Force abeam and
 * moment about midship. */
static void turning_drag(const Afloat *hull, double v, double r, double *force, double *moment) {
    double L = hull->length, k = hull->abeam / L, end = 0.5 * L * fabs(r);
    if (end <= fabs(v)) { /* all strips drift to the same side */
        double cube = L * L * L / 12.0;
        *force = -k * copysign(r * r * cube, v);
        *moment = -k * 2.0 * fabs(v) * r * cube;
    } else {
        double a = v / end, square = a * a; /* the strips' speeds are end (a + t), t from -1 to 1 */
        *force = -k * L * end * end * a * (1.0 - fabs(a) + square / 3.0);
        *moment = -k * 0.25 * L * L * end * end * (0.5 + square - square * square / 6.0);
        *moment = copysign(*moment, -r);
    }
}

/* The wrench of water on an object that moves at (u, v) at midship relative to it and turns at r, by
 * the formulas of DNV-ST-0111 and the drag of turning. */
static void water_wrench(const Afloat *hull, double u, double v, double r, double *wrench) {
    double speed = sqrt(u * u + v * v), bearing = atan2(fabs(v), u), force, moment;
    double shift = smaller(0.25, larger(-0.2, 0.4 * (1.0 - 2.0 * bearing / PI)));
    double arm = hull->water_x + shift * hull->length;
    at_origin(hull, -hull->ahead * speed * u, -hull->abeam * speed * v, arm, wrench);
    turning_drag(hull, v, r, &force, &moment);
    wrench[1] += force;
    wrench[2] += moment + hull->midship_x * force;
}

/* -- robots -------------------------------------------------------------------------------------- */

typedef struct {
    double force, angle, c, s; /* the angle's cosine and sine */
} Thrust;

/* The forces of all robots at some instant: a wrench of those that turn with the object; of the others
 * the force and its moments x f_y - y f_x and x f_x + y f_y as if the heading were 0. */
typedef struct {
    double hull[3], earth[4];
} Push;

/* What is left of a way to go after a time: at most `rate` is gone in a second, and slower as the end
 * comes near. `fade` is exp(-time / lag), or 0. */
static double left_of(double way, double lag, double rate, double time, double fade) {
    double ramp = lag > 0.0 ? lag * rate : 0.0; /* the way from which on it is slower */
    double on_ramp = (fabs(way) - ramp) / rate;
    if (fabs(way) <= ramp)
        return way * fade;
    if (time <= on_ramp && rate < AT_ONCE)
        return way - copysign(rate * time, way);
    return lag > 0.0 ? copysign(ramp * exp((on_ramp - time) / lag), way) : 0.0;
}

static const double NO_FADE[2] = {1.0, 1.0}; /* after no time */

static double fade_of(double time, double lag) { return lag > 0.0 ? exp(-time / lag) : 0.0; }

/* The force some time after an order (force, angle). */
static Thrust later(const Driver *driver, Thrust now, const double *order, double time,
                    const double *fade) {
    int following = (int)driver->following;
    if (following == FREE) {
        double x = order[0] * cos(order[1]), y = order[0] * sin(order[1]);
        double dx = x - now.force * now.c, dy = y - now.force * now.s, way = sqrt(dx * dx + dy * dy);
        if (way > 0.0) {
            double part = left_of(way, driver->lag, driver->rate, time, fade[0]) / way;
            x -= part * dx;
            y -= part * dy;
            now.force = sqrt(x * x + y * y);
        }
        if (way > 0.0 && now.force > 0.0) {
            now.angle = atan2(y, x);
            now.c = x / now.force;
            now.s = y / now.force;
        }
        return now;
    }
    now.force = order[0] - left_of(order[0] - now.force, driver->lag, driver->rate, time, fade[0]);
    double way = following == FIXED ? 0.0 : order[1] - now.angle;
    if (following == AROUND)
        way = remainder(way, 2.0 * PI);
    if (way != 0.0) {
        now.angle = order[1] - left_of(way, driver->turn_lag, driver->turn_rate, time, fade[1]);
        now.c = cos(now.angle);
        now.s = sin(now.angle);
    }
    return now;
}

static void add_thrust(Push *push, const Driver *driver, const Thrust *thrust) {
    double force = driver->efficiency * thrust->force, x = force * thrust->c, y = force * thrust->s;
    if (driver->keeps == 0.0) {
        push->hull[0] += x;
        push->hull[1] += y;
        push->hull[2] += driver->x * y - driver->y * x;
        return;
    }
    double e = driver->c * x - driver->s * y, f = driver->s * x + driver->c * y;
    push->earth[0] += e;
    push->earth[1] += f;
    push->earth[2] += driver->x * f - driver->y * e;
    push->earth[3] += driver->x * e + driver->y * f;
}

/* The wrench of all robots at a heading, in the object's frame. */
static void push_wrench(const Push *push, double c, double s, double *wrench) {
    const double *earth = push->earth;
    wrench[0] = push->hull[0] + c * earth[0] + s * earth[1];
    wrench[1] = push->hull[1] - s * earth[0] + c * earth[1];
    wrench[2] = push->hull[2] + c * earth[2] - s * earth[3];
}

/* The force of a robot in a state. */
static Thrust thrust_of(const double *state, int n, int i) {
    double angle = state[BODY + n + i];
    return (Thrust){state[BODY + i], angle, cos(angle), sin(angle)};
}

/* -- the object ---------------------------------------------------------------------------------- */

typedef struct {
    const Afloat *hull;
    const double *stream, *load;
} Sea;

/* What wind and water exert on an object, at a heading of cosine c and sine s. */
static void sea_wrenches(const Sea *sea, double c, double s, const double *speed, double *wind,
                         double *water) {
    const Afloat *hull = sea->hull;
    const double *flow = sea->stream;
    double u = speed[0] - hull->midship_y * speed[2], v = speed[1] + hull->midship_x * speed[2];
    double x = flow[0] - flow[2], y = flow[1] - flow[3]; /* of the air, relative to the water */
    wind_wrench(hull, c * x + s * y - u, c * y - s * x - v, wind);
    water_wrench(hull, u, v, speed[2], water);
}

/* The rate of change of pose and velocity, (6,): M nu' = wrenches - C(nu) nu. */
static void rate_of(const Sea *sea, const Push *push, const double *body, double *rate) {
    const Afloat *hull = sea->hull;
    const double *speed = body + 3;
    double u = speed[0], v = speed[1], r = speed[2], c = cos(body[2]), s = sin(body[2]);
    double ground[3] = {u + c * sea->stream[2] + s * sea->stream[3],
                        v - s * sea->stream[2] + c * sea->stream[3], r};
    double sum[3], wind[3], water[3];
    push_wrench(push, c, s, sum);
    sea_wrenches(sea, c, s, speed, wind, water);
    for (int k = 0; k < 3; k++)
        sum[k] += sea->load[k] + wind[k] + water[k] - dot(hull->damping + 3 * k, ground);
    double m = hull->mass;
    double x = hull->added[1] * (v + hull->added_x * r) * r;  /* of the water that goes along, but for */
    double y = -hull->added[0] * (u - hull->added_y * r) * r; /* Munk's moment: see docs/simulation.md */
    sum[0] += m * (v + hull->x * r) * r + x;
    sum[1] += -m * (u - hull->y * r) * r + y;
    sum[2] += -m * (hull->x * u + hull->y * v) * r + hull->added_x * y - hull->added_y * x;
    rate[0] = c * ground[0] - s * ground[1];
    rate[1] = s * ground[0] + c * ground[1];
    rate[2] = r;
    for (int k = 0; k < 3; k++)
        rate[3 + k] = dot(hull->inverse + 3 * k, sum);
}

/* One step of the object, the robots' forces at its beginning, middle and end being known. */
static void advance_body(const Sea *sea, const Push *push, double step, double *body) {
    double rate[4][BODY], at[BODY];
    rate_of(sea, push, body, rate[0]);
    for (int k = 1; k < 4; k++) {
        double part = k < 3 ? 0.5 * step : step;
        for (int j = 0; j < BODY; j++)
            at[j] = body[j] + part * rate[k - 1][j];
        rate_of(sea, push + (k < 3 ? 1 : 2), at, rate[k]);
    }
    for (int j = 0; j < BODY; j++)
        body[j] += step / 6.0 * (rate[0][j] + 2.0 * (rate[1][j] + rate[2][j]) + rate[3][j]);
}

/* -- runs ---------------------------------------------------------------------------------------- */

typedef struct {
    double half[2], whole[2]; /* exp(-time / lag) of force and angle, half a step and a step on */
} Fades;

/* One run; `thrust` and `fades` are (n,). */
static Status advance_run(const Sea *sea, const Driver *driver, int n, double *state,
                          const double *order, double step, long steps, Thrust *thrust,
                          const Fades *fades, Work *work) {
    Push push[3] = {{{0.0}, {0.0}}};
    for (int i = 0; i < n; i++) {
        thrust[i] = thrust_of(state, n, i);
        if (driver[i].lag == 0.0 && driver[i].rate >= AT_ONCE) /* its order holds from now on */
            thrust[i] = later(driver + i, thrust[i], order + 2 * i, 0.0, NO_FADE);
        add_thrust(push + 2, driver + i, thrust + i);
    }
    for (long k = 0; k < steps; k++) {
        push[0] = push[2];
        memset(push + 1, 0, 2 * sizeof *push);
        for (int i = 0; i < n; i++) {
            Thrust middle =
                later(driver + i, thrust[i], order + 2 * i, 0.5 * step, fades[i].half);
            add_thrust(push + 1, driver + i, &middle);
            thrust[i] = later(driver + i, thrust[i], order + 2 * i, step, fades[i].whole);
            add_thrust(push + 2, driver + i, thrust + i);
        }
        advance_body(sea, push, step, state);
        if (spend(work, OBJECT_WORK + ROBOT_WORK * n) == INTERRUPTED)
            return INTERRUPTED;
    }
    for (int i = 0; i < n; i++) {
        state[BODY + i] = thrust[i].force;
        state[BODY + n + i] = thrust[i].angle;
    }
    return SOLVED;
}

Status motion_advance(const Afloat *hull, const Driver *driver, int n, int runs, double *state,
                      const double *order, const double *stream, const double *load, double step,
                      long steps, Work *work) {
    Thrust *thrust = malloc(((size_t)n + 1) * sizeof *thrust);
    Fades *fades = malloc(((size_t)n + 1) * sizeof *fades);
    Status status = thrust && fades ? SOLVED : NO_MEMORY;
    for (int i = 0; i < n && status == SOLVED; i++)
        fades[i] = (Fades){
            {fade_of(0.5 * step, driver[i].lag), fade_of(0.5 * step, driver[i].turn_lag)},
            {fade_of(step, driver[i].lag), fade_of(step, driver[i].turn_lag)}};
    for (ptrdiff_t k = 0; k < runs && status == SOLVED; k++) {
        Sea sea = {hull, stream + STREAM * k, load + 3 * k};
        status = advance_run(&sea, driver, n, state + (BODY + 2 * n) * k, order + 2 * n * k, step,
                             steps, thrust, fades, work);
    }
    free(thrust);
    free(fades);
    return status;
}

void motion_exerted(const Afloat *hull, const Driver *driver, int n, int runs, const double *state,
                    const double *stream, double *row) {
    for (; runs > 0; runs--, state += BODY + 2 * n, stream += STREAM, row += EXERTED) {
        Sea sea = {hull, stream, NULL};
        double c = cos(state[2]), s = sin(state[2]);
        Push push = {{0.0}, {0.0}};
        for (int i = 0; i < n; i++) {
            Thrust thrust = thrust_of(state, n, i);
            add_thrust(&push, driver + i, &thrust);
        }
        push_wrench(&push, c, s, row);
        sea_wrenches(&sea, c, s, state + 3, row + 3, row + 6);
    }
}
