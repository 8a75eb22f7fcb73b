/* What a solved step leaves behind: the ledger, the angles' turns, the state (theory 11). */
#ifndef HOLONOM_LEDGER_H
#define HOLONOM_LEDGER_H

#include "elements.h"
#include "motion.h"
#include "sampling.h"
#include "step.h"

static void book(context *c, int account, double amount)
{
    hm_add(c->s.head + account, c->s.head + account + 1, amount); /* high and low part */
}

/* Whether one of the losses in the step, to dampers and frictions, is a gain, beyond round-off of
   what weights take the difference of. */
HM_SELDOM static int gives_energy(const context *c)
{
    const double round_off = 1e-15 * c->s.head[S_ENERGY_REFERENCE];
    int gives = 0;
    for (int32_t j = 0; j < n_composites(c); j++) gives |= !(c->k.loss[j] >= -round_off);
    return gives;
}

/* Account of what row j takes. In stepped mode rows of closed contacts and of frictions that stick
   take energy, too: gaps that close and slips that stop move in the half step. */
static inline int account_of(const context *c, int32_t j, enum row_state state)
{
    const int32_t owner = c->step.changes_contacts ? owner_of(c, j) : -1;
    if (state == ROW_IS_SLIDING || owner >= n_contacts(c->m)) return S_FRICTION;
    return owner < 0 ? S_DEFECT : S_IMPACT;
}

/* Work of elements, what their dampers take (also for each by itself, in loss), and the work of
   drivers: a row of multiplier mu works -mu (its part by quantities) = -mu dphi + mu (its part by
   signals). */
static void book_composites(context *c)
{
    EACH_COMPOSITE(c, j) {
        if (!is_row(c, j)) {
            const element_work work = kind_of(c, j)->step(c, j);
            book(c, S_DISSIPATED, work.lost);
            c->k.loss[j] += work.lost;
            book(c, S_WORK, work.done);
            continue;
        }
        const int32_t row = row_of(c, j);
        const double mu = c->k.mu[row], change = c->k.change[row];
        const enum row_state state = state_of_row(c, j);
        if (state == ROW_IS_OFF) continue;
        book(c, account_of(c, j, state), mu * change);
        if (state == ROW_IS_SLIDING)
            c->k.loss[slip_row(c, owner_of(c, j) - n_contacts(c->m), 0)] += mu * change;
        book(c, S_WORK, mu * (change - c->k.moved[row]));
    }
}

/* Books the step: Delta T = -dPhi'mu - Delta U + work - dissipation + v'R, term by term. */
static void book_step(context *c)
{
    const holonom_model *m = c->m;
    double du[DIM], unused[DIM], defect = 0.0,
                                 residual = 0.0; /* small beside the energy: plain sums in a step */
    EACH_FORM_ROW(c, i) defect += c->k.mu[i] * (c->k.phi[i] - c->k.phi0[i]);
    for IN_ISLAND(c, j, ISLAND_COINCIDENCE) {
        link_of(c, m->coincidence_form[j], c->k.d, du, unused);
        defect += dot(c->k.mu + row_of_coincidence(m, j), du);
    }
    book(c, S_DEFECT, defect);
    for (int32_t k = DIM * c->view.begin[ISLAND_FREE]; k < DIM * c->view.end[ISLAND_FREE]; k++)
        residual += move_of(c)[k] * (c->k.momentum[k] - c->k.handed_on[k]);
    book(c, S_RESIDUAL, residual / c->h);
    for (int32_t k = DIM * c->view.begin[ISLAND_DRIVEN]; k < DIM * c->view.end[ISLAND_DRIVEN];
         k++) /* what moves driven nodes */
        book(c, S_WORK, c->k.d[k] * c->k.momentum[k] / c->h);
    for IN_ISLAND(c, j, ISLAND_LOAD) book(c, S_WORK, load_work(c, j));
    for IN_ISLAND(c, j, ISLAND_MOMENT) book(c, S_WORK, moment_work(c, j));
    for IN_ISLAND(c, j, ISLAND_BODY_MOMENT) book(c, S_WORK, body_moment_work(c, j));
    book_composites(c);
}

/* Counts full turns of angles: one whose sine changes its sign where the cosine is negative leaves
   (-pi, pi]. Sines are kept, so that what is only measured costs one link an angle and step; moved
   are the increments of coordinates, NULL if short. */
static void follow_angle(context *c, int32_t j, const double *moved)
{
    const int32_t *form = c->m->quantity_form + 2 * j;
    double u[DIM], w[DIM], du[DIM] = {0.0}, dw[DIM] = {0.0}, *sine = c->s.sine + j;
    const double before = *sine;
    link_at_state(c, form[1], u, w);
    *sine = dot(u, w);
    if ((before < 0.0) == (*sine < 0.0)) return;
    link_at_state(c, form[0], u, w);
    if (moved) link_of(c, form[0], moved, du, dw);
    const double cosine = dot(u, w);
    EACH(k) u[k] -= du[k], w[k] -= dw[k];
    const double sense = dot(u, w) * *sine - before * cosine;
    if (*sine < 0.0 && sense > 0.0) c->s.turns[j] += 1.0;
    if (before < 0.0 && sense < 0.0) c->s.turns[j] -= 1.0;
}

/* Likewise all. */
static void follow_angles(context *c, const double *moved)
{
    const int32_t *kind = c->m->quantity_kind;
    for (int32_t j = 0; j < c->m->n_quantities; j++)
        if (kind[j] == QUANTITY_ANGLE) follow_angle(c, j, moved);
}

/* Quaternion of spatial body j from its directors, of the sign next to the last one (-q is the same
   rotation). */
static void follow_orientation(context *c, int32_t j)
{
#if DIM == 3
    const double *d = c->s.q + 3 * c->m->body_node[j]; /* d[3 i + k]: component k of director i */
    double *last = c->s.quaternion + 4 * j, p[4];
    const double trace = d[0] + d[4] + d[8];
    const int largest = d[0] >= d[4] && d[0] >= d[8] ? 0 : d[4] >= d[8] ? 1 : 2;
    if (trace >= d[4 * largest]) {
        p[0] = 1.0 + trace;
        EACH(k) p[1 + k] = d[3 * ((k + 1) % 3) + (k + 2) % 3] - d[3 * ((k + 2) % 3) + (k + 1) % 3];
    } else {
        const int i = largest, k = (i + 1) % 3, l = (i + 2) % 3;
        p[0] = d[3 * k + l] - d[3 * l + k];
        p[1 + i] = 1.0 + 2.0 * d[4 * i] - trace;
        p[1 + k] = d[3 * k + i] + d[3 * i + k];
        p[1 + l] = d[3 * l + i] + d[3 * i + l];
    }
    double size2 = 0.0, along = 0.0;
    for (int i = 0; i < 4; i++) size2 += p[i] * p[i];
    for (int i = 0; i < 4; i++) along += p[i] * last[i];
    if (along == 0.0) along = p[0] != 0.0 ? p[0] : 1.0;
    for (int i = 0; i < 4; i++) last[i] = p[i] / (along < 0.0 ? -sqrt(size2) : sqrt(size2));
#else
    (void)c, (void)j;
#endif
}

/* Angles and orientations that are measured follow a state that has changed by less than pi. */
static void follow_turns(context *c)
{
    follow_angles(c, NULL);
    for (int32_t j = 0; j < n_bodies(c->m); j++) follow_orientation(c, j);
}

static double momentum_norm2(const context *c)
{
    double sum = 0.0;
    for IN_ISLAND(c, a, ISLAND_FREE) {
        const double *p = c->k.momentum + DIM * a;
        if (!is_director(c, a)) sum += dot(p, p) / c->number[c->m->node_mass_at + a];
        else if (first_of_unknown(c, a) == a) sum += turning_norm2(c, a, p, -1);
    }
    return sum;
}

/* Speed of what is handed on to the next half steps (hand_on), in the mass norm, over that of the
   reference energy. */
#define HANDED_ON 1e-14

/* Takes the solved step of the islands at hand over into the state. */
static void accept_island(context *c, int parity)
{
    const holonom_model *m = c->m;
    const hm_state *s = &c->s;
    const int handed = momentum_norm2(c) <= HANDED_ON * HANDED_ON * s->head[S_ENERGY_REFERENCE];
    book_step(c);
    EACH_COORDINATE(c, k) {
        hm_add(s->q + k, s->q_low + k, c->k.d[k]);
        /* Divided one by one: the rounding error of 2/h, the same in all steps, would add half its
           square of the change of velocity to the energy, always with one sign. */
        hm_add(s->v + k, s->v_low + k, 2.0 * c->k.w[k] / c->h);
        s->imbalance_before[k] = s->imbalance[k];
        s->imbalance[k] = handed ? c->k.momentum[k] : 0.0;
    }
    for (int32_t j = c->view.begin[ISLAND_BODY]; HM_BODIES && j < c->view.end[ISLAND_BODY]; j++)
        follow_orientation(c, j);
    if (!is_telling(c)) return;
    const int kept = n_kept(c);
    const double per_step2 = 2.0 / (c->h * c->h);
    const history a = accelerations_so_far(c, parity), mu = multipliers_so_far(c, parity),
                  turn = turning_so_far(c, parity);
    EACH_COORDINATE(c, k) remember(kept, &a, per_step2 * c->k.w[k], k);
    const double *next = c->view.scalars[I_DEPENDENT] == ROWS_ARE_DEPENDENT ? c->k.lambda : c->k.mu;
    EACH_ROW(c, i) remember(kept, &mu, next[i], i);
    EACH_TURN(c, b)
        for (int k = 0; k < TURNING; k++)
            remember(kept, &turn, turning_of_step(c, m->body_node[b], k), TURNING * b + k);
    const int32_t first = DIM * m->n_free;
    for (int32_t k = DIM * c->view.begin[ISLAND_DRIVEN]; k < DIM * c->view.end[ISLAND_DRIVEN]; k++)
        s->driven[parity][k - first] = c->k.momentum[k] / c->h;
}

/* Takes the solved step over into the state. */
static void accept_step(context *c, int parity)
{
    const int32_t parts = n_apart(c);
    select_all_islands(c);
    if (c->m->n_sampled && !reads_the_step(c))
        judge_sampling(c, parity); /* else what follows it would count as seldom, too */
    for (int32_t part = 0; part < parts; part++) {
        if (!is_chosen(c, part)) continue;
        select_part(c, part, parts);
        accept_island(c, parity);
    }
    c->step.rows_known = c->step.halves == 2
                         && (!is_unilateral(c->m) || (!c->step.changes_contacts && are_all_off(c)));
    select_all_islands(c);
    if (is_telling(c)) remember_length(c);
    memcpy(c->s.signal, c->k.signal1, sizeof(double) * (size_t)c->m->n_signals);
    follow_angles(c, c->k.d);
    c->s.head[S_SUBSTEPS] += 1.0;
    c->t += c->h;
}

#endif
