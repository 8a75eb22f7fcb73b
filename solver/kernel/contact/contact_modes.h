/* Modes from the present state alone: which contacts are closed, and which frictions stick.

   Where changes one by one find none, the solver of contact_solver.h does. */
#ifndef HOLONOM_CONTACT_MODES_H
#define HOLONOM_CONTACT_MODES_H

#include "contact_split.h"

enum { MOST_TURNS = 100 };

/* Momentum += factor times the gradient of contact i's gap, with the friction that a normal force
   of 1 brings about while it slides. */
static int32_t add_push(const context *c, int32_t i, double factor)
{
    const int32_t f = c->m->contact_friction[i];
    double along[3];
    int32_t status = add_row_gradient(c, c->m->contact_row[i], factor);
    if (f < 0 || !(slip_at_state(c, f, along) > speed_tolerance(c) || is_smooth(c, f)))
        return status;
    for (int k = 0; k < n_slips(c, f) && !status; k++)
        status = add_row_gradient(c, slip_row(c, f, k),
                                  -factor * c->number[c->m->sliding_at + f] * along[k]);
    return status;
}

/* Finds all modes at once: accelerations of contacts at rest, with forces for impulses, obey what
   contact_solver.h solves. Those slide and part that do so with these accelerations. With `begun`,
   frictions that have been let slide go on, along their way. With `pushes` only contacts that push
   are closed: one that neither pushes nor parts is held by others, to the digits that W has. */
static int32_t find_modes_by_law(context *c, int begun, int pushes)
{
    const holonom_model *m = c->m;
    const int64_t n = DIM * c->n_moving;
    hit x;
    map_hit(c, &x);
    int32_t *slides = (int32_t *)(void *)c->k.rest; /* of each contact; then the ways of rows */
    double *way = c->k.rest + m->n_hit_rows;
    memset(way, 0, sizeof(double) * (size_t)m->n_hit_rows);
    evaluate_state(c);
    for (int32_t i = 0; i < m->n_contacts; i++) {
        const int32_t f = m->contact_friction[i],
                      has_begun = begun && f >= 0 && friction_mode(c, f) == FRICTION_SLIDES;
        double along[3];
        for (int k = 0; f >= 0 && k < n_slips(c, f); k++)
            along[k] = friction_of(c, f)[F_ALONG_1 + k];
        open_contact(c, i);
        if (!is_at_rest(c, i)) continue;
        const int moves = f >= 0 && (is_smooth(c, f) || slip_of(c, f, NULL) > speed_tolerance(c));
        if (!add_to_hit(c, &x, i, 0.0)) return HOLONOM_CONTACT_UNDECIDED;
        const int32_t k = x.law.contacts - 1;
        slides[k] = 0;
        if (moves) { /* its friction follows from its normal force: add_push adds it */
            x.law.rows = x.law.first[k] + 1;
            x.tangents[k] = 0;
            x.coefficient[k] = 0.0;
        } else if (has_begun) {
            slides[k] = 1;
            for (int32_t a = 0; a < x.tangents[k]; a++) way[x.first[k] + 1 + a] = along[a];
        } else if (f >= 0)
            x.coefficient[k] =
                c->number[m->static_at + f] * (c->event.gives_way ? 1.0 - WELL_INSIDE : 1.0);
    }
    const int32_t rows = x.law.rows;
    int32_t status = evaluate_forces(c);
    for (int32_t r = 0; r < rows && !status; r++) x.before[r] = second_rate_of_row(c, x.row[r]);
    stand_still(c);
    if (!status) status = factorise_at_state(c);
    for (int32_t k = 0; k < x.law.contacts && !status; k++)
        for (int32_t r = x.law.first[k]; r <= x.law.first[k] + x.law.tangents[k] && !status; r++) {
            memset(c->k.momentum, 0, sizeof(double) * (size_t)n);
            status = r == x.law.first[k] ? add_push(c, x.contact[k], -1.0)
                                         : add_row_gradient(c, x.row[r], -1.0);
            velocities_of_impulses(c, c->k.hit_reach + n * r);
        }
    if (!status) status = fill_matrix(c, rows, x.row, x.W);
    if (status) return status;
    contact_problem law = {.contacts = x.law.contacts,
                           .rows = rows,
                           .first = x.first,
                           .tangents = x.tangents,
                           .coefficient = x.coefficient,
                           .slides = slides,
                           .way = way,
                           .W = x.W,
                           .b = x.before,
                           .p = x.law.impulse,
                           .rate = x.law.compression,
                           .scratch = c->k.hit_scratch};
    if (hm_solve_contacts(&law, LEAST_WORK)) return HOLONOM_CONTACT_UNDECIDED;
    evaluate_state(c);
    double largest = 0.0;
    for (int32_t r = 0; r < rows; r++) largest = fmax(largest, fabs(law.b[r]));
    for (int32_t k = 0; k < law.contacts; k++) {
        const int32_t i = x.contact[k], f = m->contact_friction[i], t = x.first[k] + 1,
                      slips = x.tangents[k];
        if (law.rate[t - 1] > FITS * largest || (pushes && !(law.p[t - 1] > 0.0))) continue;
        close_contact(c, i);
        if (f < 0 || slips == 0 || friction_mode(c, f) == FRICTION_OFF) continue;
        const double slip = hm_length(slips, law.rate + t);
        double along[3] = {0.0, 0.0, 0.0};
        for (int32_t a = 0; a < slips; a++)
            along[a] = slides[k] ? way[t + a] : slip > 0.0 ? law.rate[t + a] / slip : 0.0;
        if (slides[k] || slip > FITS * largest) let_slide(c, f, along);
        else let_stick(c, f);
    }
    return HOLONOM_OK;
}

/* Part of its cone by which a friction that slides may miss it. */
#define OFF_THE_CONE 1e-3

/* Whether frictions that slide have the forces of their cones. With a friction that is strong
   beyond all digits the equations lose them, and any choice would do. */
static int cones_hold(const context *c, double none)
{
    EACH_FRICTION(c, f) {
        if (friction_mode(c, f) != FRICTION_SLIDES || is_smooth(c, f)) continue;
        const double limit = cone(c, f, 1, normal_force(c, f, c->k.event_mu)),
                     force = friction_force(c, f, c->k.event_mu, NULL);
        if (!(fabs(force - limit) <= OFF_THE_CONE * fmax(force, fabs(limit)) + none)) return 0;
    }
    return 1;
}

/* Likewise, where parts that hold something twice give way (hold_together). Forces of rows that
   depend on each other nearly differ from those of the law: if its modes are those at hand, they
   are not to be judged by these forces, unless contacts that do not push open. */
HM_SELDOM static int32_t give_way_by_law(context *c, int begun)
{
    const size_t modes = sizeof(double) * (size_t)c->s.n_modes;
    for (int pushes = 0; pushes < 2; pushes++) {
        memcpy(c->k.rest_modes, c->s.contacts, modes);
        const int32_t status = find_modes_by_law(c, begun, pushes);
        if (status || memcmp(c->k.rest_modes, c->s.contacts, modes) != 0) return status;
    }
    return HOLONOM_CONTACT_UNDECIDED;
}

/* Changes modes one at a time until they agree with the forces, or with others that hold the
   same. */
static int32_t agree_with_forces(context *c)
{
    const int most = 20 + 8 * (c->m->n_contacts + c->m->n_frictions);
    int together = 0; /* whether frictions were let slide that may hold when others do */
    for (int change = 0, turns = 0, turned = 0; change < most; change += !turned) {
        const int again = turned;
        turned = 0;
        forget_shares(c);
        int32_t status = evaluate_forces(c);
        const double none = force_tolerance(c);
        if (status) return status;
        enum togetherness how = HOLD;
        if (is_beyond(c, none) && (status = hold_together(c, &how, NULL))) return status;
        if (how == GIVE_WAY && (status = give_way_by_law(c, together))) return status;
        together |= how >= GIVE_WAY;
        if (how >= GIVE_WAY
            || (how == NOT_TOGETHER
                && (tear_loose(c) || open_worst(c, none) || slide_worst(c, none))))
            continue;
        if (turn_back(c) || close_worst(c) || (together && !c->event.gives_way && hold_still(c)))
            continue;
        if (turns++ == MOST_TURNS || !turn_beginning_slips(c, again))
            return cones_hold(c, none) ? HOLONOM_OK : HOLONOM_CONTACT_UNDECIDED;
        turned = 1;
    }
    return HOLONOM_CONTACT_UNDECIDED;
}

/* Lets what sticks share forces where the multipliers of half steps to come are outside the
   cones. */
static int32_t share_means(context *c)
{
    enum togetherness how;
    double load;
    forget_shares(c);
    memcpy(c->k.event_mu, c->s.mean, sizeof(double) * (size_t)c->m->n_rows);
    return is_beyond(c, CONE_MARGIN * largest_normal(c, c->s.mean)) ? hold_together(c, &how, &load)
                                                                    : HOLONOM_OK;
}

/* Decides from the present state which contacts are closed and which frictions stick. */
static int32_t settle_modes(context *c)
{
    guess_modes(c);
    int32_t status = agree_with_forces(c);
    if (status == HOLONOM_CONTACT_UNDECIDED) {
        status = find_modes_by_law(c, 0, 0);
        if (!status) status = agree_with_forces(c);
    }
    if (!status) status = start_with_modes(c);
    if (!status) status = share_means(c);
    c->event.gives_way = 0;
    return status;
}

#endif
