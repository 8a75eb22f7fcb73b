/* Inputs, sensors, laws and signals at their times. */
#ifndef HOLONOM_INPUTS_SIGNALS_H
#define HOLONOM_INPUTS_SIGNALS_H

#include "energy.h"
#include "ledger.h"
#include "sensors.h"
#include "sides.h"

/* Time at part `part` of a step of length h from t, but inside of it, where laws may jump at its
   ends. */
static double inside_of_step(double t, double h, double part)
{
    const double margin = fmax(1e-12 * h, 4.5e-16 * fabs(t));
    return fmin(fmax(t + part * h, t + margin), t + h - margin);
}

/* Inputs as they are at time t: held, or on their line or cubic from the value at the beginning of
   the communication step. */
static void load_inputs(const context *c, double t)
{
    const holonom_model *m = c->m;
    const hm_state *s = &c->s;
    const double past = t - c->laws.start;
    for (int32_t i = 0; i < m->n_inputs; i++) {
        const double moved =
            past * (s->inputs_slope[i] + past * (s->inputs_bend[i] + past * s->inputs_third[i]));
        c->number[m->input_at + i] =
            m->input_course[i] == INPUT_HELD ? s->inputs[i] : s->inputs_before[i] + moved;
    }
    memcpy(c->number + m->parameter_at, c->s.parameters, sizeof(double) * (size_t)m->n_parameters);
    for (int32_t k = 0; k < n_switches(c); k++) c->number[m->switch_table[5 * k + 1]] = s->side[k];
    memcpy(c->number + m->held_at, s->held, sizeof(double) * (size_t)m->n_held);
}

/* Whether an input is on the move, or was in the last step. */
static int move_inputs(const context *c)
{
    const hm_state *s = &c->s;
    for (int32_t i = 0; i < c->m->n_inputs; i++)
        if (c->m->input_course[i] != INPUT_HELD
            && (s->inputs_slope[i] != 0.0 || s->inputs_bend[i] != 0.0 || s->inputs_third[i] != 0.0))
            return 1;
    return 0;
}

static double stored_by_chosen(context *c)
{
    double sum = 0.0;
    EACH_CHOSEN(c, island) sum += stored_energy(c);
    return sum;
}

/* Sets inputs, parameters and time among the numbers and runs the tape of the laws. If it writes
   springs, their stored energy jumps, which is work on the mechanism: that of the islands which are
   chosen is booked. */
static void set_laws(context *c, double t, int booked)
{
    const holonom_model *m = c->m;
    const double before =
        booked && m->variable_potential && m->n_tape_laws ? stored_by_chosen(c) : 0.0;
    load_inputs(c, t);
    c->number[m->time_at] = t;
    if (!m->n_tape_laws) return;
    hm_run_tape(m, c->number, 1);
    if (n_motion_switches(c)) watch_switches(c, t);
    if (booked && m->variable_potential) book(c, S_WORK, stored_by_chosen(c) - before);
}

/* Looks at switches at a state within a step, on the path of the step. A spring of the time has
   another energy here than in the half step before, which counts as work like any jump of it. */
HM_SELDOM static void watch_kinks(context *c)
{
    sense(c, 0.0, 0);
    set_laws(c, c->t, 1);
}

/* Signals at time t (n_signals, overwritten). */
static void signals_at(const context *c, double t, double *signal)
{
    const holonom_model *m = c->m;
    const double law_time = c->number[m->time_at];
    if (!m->n_signals) return;
    load_inputs(c, t);
    c->number[m->time_at] = t;
    hm_run_tape(m, c->number, 2);
    c->number[m->time_at] = law_time;
    memcpy(signal, c->number + m->signal_at, sizeof(double) * (size_t)m->n_signals);
}

/* Lets time and inputs move among the numbers at time t, where a segment of the tape reads them. */
HM_SELDOM static void load_jets(const context *c, double t, int32_t segment)
{
    const holonom_model *m = c->m;
    const hm_state *s = &c->s;
    const double past = t - c->laws.start;
    load_inputs(c, t);
    c->number[m->time_at] = t;
    hm_stop_jets(m, segment, c->k.jet);
    c->k.jet[2 * m->time_at] = 1.0;
    c->k.jet[2 * m->time_at + 1] = 0.0;
    for (int32_t i = 0; i < m->n_inputs; i++) {
        double *jet = c->k.jet + 2 * (m->input_at + i);
        const double moves = m->input_course[i] != INPUT_HELD;
        jet[0] = moves
                 * (s->inputs_slope[i]
                    + past * (2.0 * s->inputs_bend[i] + 3.0 * past * s->inputs_third[i]));
        jet[1] = moves * (2.0 * s->inputs_bend[i] + 6.0 * past * s->inputs_third[i]);
    }
}

/* Runs the jets of signals at time t; returns how many operations are in doubt, see hm_run_jets. */
HM_SELDOM static int32_t run_signal_jets(const context *c, double t)
{
    const double law_time = c->number[c->m->time_at];
    load_jets(c, t, 2);
    memset(c->k.jet + 2 * c->m->signal_at, 0,
           sizeof(double) * (size_t)(2 * c->m->n_signals)); /* constant ones are not run */
    const int32_t doubts = hm_run_jets(c->m, c->number, 2, c->k.jet);
    c->number[c->m->time_at] = law_time;
    return doubts;
}

enum { LATER_TIMES = 20 };
#define FIRST_LATER 0.125   /* [s]; each later time is half as far as the one before */
#define LIMIT_IS_KNOWN 1e-7 /* error of a limit, over what it is of and changes by in a second */

/* The limit at time t from above of the rate (order 1) or the second derivative (2) of signal b, by
   Neville's extrapolation from later times as far as round-off lets it converge (Ridders 1982); NaN
   if it does not. So begins sqrt(2 - 2 cos t), which is 2 sin(t/2), though its jet at 0 is 0/0. It
   is one in powers of the time or, for formulas such as sqrt(t^7), of its root. */
HM_SELDOM static double limit_in_powers(const context *c, double t, int32_t b, int order,
                                        int of_root)
{
    const int32_t place = c->m->signal_at + b;
    const double *jet = c->k.jet + 2 * (int64_t)place;
    double power[LATER_TIMES], column[LATER_TIMES], best = NAN, least = INFINITY, size = 0.0;
    for (int k = 0; k < LATER_TIMES; k++) {
        const double later = (t + FIRST_LATER / (1 << k)) - t;
        if (!(later > 0.0)) break; /* t is too large for it */
        run_signal_jets(c, t + later);
        power[k] = of_root ? sqrt(later) : later;
        double found = jet[order - 1];
        const double size_here = fabs(found) + fabs(order == 1 ? c->number[place] : jet[0]);
        for (int j = 0; j <= k; j++) {
            const double before =
                column[j]; /* found from j + 1 times, the last of them the one before */
            column[j] = found;
            if (j == k) break;
            const double next = found + (found - before) * power[k] / (power[k - j - 1] - power[k]);
            const double error = fmax(fabs(next - found), fabs(next - before));
            if (error < least) best = next, least = error, size = size_here;
            found = next;
        }
    }
    return least <= LIMIT_IS_KNOWN * size ? best : NAN;
}

static double limit_of_jet(const context *c, double t, int32_t b, int order)
{
    const double limit = limit_in_powers(c, t, b, order, 0);
    return limit == limit ? limit : limit_in_powers(c, t, b, order, 1);
}

/* Rates and second derivatives of the signals at time t (n_signals each, overwritten), as they are
   just after it: see jets.c. They are infinite where those of a formula such as sqrt(t) are, and
   NaN where they have no limit. */
HM_SELDOM static void signal_jets_at(const context *c, double t, double *rate, double *bend)
{
    const holonom_model *m = c->m;
    if (!m->n_signals) return;
    const int32_t doubts = run_signal_jets(c, t);
    for (int32_t b = 0; b < m->n_signals; b++) {
        rate[b] = c->k.jet[2 * (m->signal_at + b)];
        bend[b] = c->k.jet[2 * (m->signal_at + b) + 1];
    }
    const int moves =
        doubts && run_signal_jets(c, t + FIRST_LATER / (1 << (LATER_TIMES - 1))) != doubts;
    for (int32_t b = 0; b < m->n_signals; b++) {
        if (moves || rate[b] != rate[b]) rate[b] = limit_of_jet(c, t, b, 1);
        if (moves || bend[b] != bend[b]) bend[b] = limit_of_jet(c, t, b, 2);
    }
}

static void signal_rates_at(const context *c, double t, double *rate)
{ signal_jets_at(c, t, rate, c->k.signal_bend); }

/* Values (signal1), rates and second derivatives of the signals at part `part` of a step of length
   h from t, of its inside: they may have kinks and jumps at its ends. */
HM_SELDOM static void follow_signals(const context *c, double t, double h, double part)
{
    const double time = inside_of_step(t, h, part), past = t + part * h - time;
    signals_at(c, time, c->k.signal1);
    signal_jets_at(c, time, c->k.signal_rate, c->k.signal_bend);
    for (int32_t b = 0; b < c->m->n_signals && past != 0.0; b++) {
        c->k.signal1[b] += past * (c->k.signal_rate[b] + 0.5 * past * c->k.signal_bend[b]);
        c->k.signal_rate[b] += past * c->k.signal_bend[b];
    }
}

/* Sets the state's signals, and driven nodes, whose island is the last one, to signal1 and
   signal_rate. */
HM_SELDOM static void place_driven(context *c)
{
    const int32_t first = DIM * c->m->n_free;
    memcpy(c->s.signal, c->k.signal1, sizeof(double) * (size_t)c->m->n_signals);
    if (!is_chosen(c, c->m->n_islands - 1)) return;
    for (int32_t k = first; k < DIM * c->n_moving; k++) {
        c->s.q[k] = c->k.signal1[k - first];
        c->s.v[k] = c->k.signal_rate[k - first];
        c->s.q_low[k] = c->s.v_low[k] = 0.0;
    }
}

/* Lets driven nodes and signals be where they are now, with their rates: half steps leave rates
   that are right to the order. */
HM_SELDOM static void follow_drivers(context *c)
{
    signals_at(c, c->t, c->k.signal1);
    signal_rates_at(c, c->t, c->k.signal_rate);
    place_driven(c);
}

#endif
