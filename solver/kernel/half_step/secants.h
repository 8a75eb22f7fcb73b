/* Increments of Newton's iteration where laws read the step (sensors.h), of which the factors know
   nothing.

   A plain increment is g(x) = -A^-1 F(x). Each one that is taken, p, shows by how much it changes
   g, q. Combinations of such pairs bring g near 0, in as many increments as laws read different
   things (Anderson 1965; Walker and Ni, SIAM J. Numer. Anal. 49 (2011) 1715-1735): with the q
   orthonormal in the mass norm the increment is g - sum <q_j, g> (q_j + p_j). Pairs serve the next
   half steps of the same length, too, until laws or contacts change or a step is taken back: what
   tries have shown is not known where a mesh is repeated. */
#ifndef HOLONOM_SECANTS_H
#define HOLONOM_SECANTS_H

#include "newton_record.h"
#include "tangent.h"

enum { MOST_SECANTS = 12 };
#define SHOWN_BEFORE                                                                               \
    1e-6 /* part of a change that other pairs do not show already: less tells nothing new */
#define OF_OTHER_LAWS                                                                              \
    0.1 /* part of an increment that pairs which show its change do not explain: laws have changed \
         */
#define READ_ENOUGH                                                                                \
    1e-9 /* increment over the step below which laws stay as they were read last: Newton's         \
            iteration ends with them */
#define READ_OF_TOLERANCE                                                                          \
    1e-3 /* of a tolerance, likewise: what laws miss has one sign, and adds up over half steps */

/* Increment over the step below which laws need not be read again. */
static inline double read_enough(const context *c)
{
    const double tolerance = hm_tolerance(c->s.head);
    return tolerance > 0.0 ? fmin(READ_ENOUGH, READ_OF_TOLERANCE * tolerance) : READ_ENOUGH;
}

/* Product of increments x and y (end_pivot each) of all islands in the mass norm. */
HM_SELDOM static double product_of_increments(const context *c, const double *x, const double *y)
{
    double sum = 0.0;
    for (int32_t a = c->view.begin[ISLAND_FREE]; a < c->view.end[ISLAND_FREE];
         a = next_unknown(c, a)) {
        const double mass = c->number[c->m->node_mass_at + a] * (is_director(c, a) ? DIM - 1 : 1);
        for (int32_t i = c->factors.lu->node_position[a], k = 0; k < unknown_size(c, a); k++)
            sum += mass * x[i + k] * y[i + k];
    }
    return sum;
}

static inline void add_multiple(int32_t n, double factor, const double *x, double *y)
{
    for (int32_t i = 0; i < n; i++) y[i] += factor * x[i];
}

/* Forgets pairs: they may span all increments, so that none of other laws would be learned. */
HM_SELDOM static void forget_secants(context *c) { c->secants.count = c->secants.has_last = 0; }

/* Keeps what the last increment has changed in g, of which there were others before. */
HM_SELDOM static void learn_secant(context *c, const double *g)
{
    const int32_t n = end_pivot(c);
    double *kept = c->k.secants, *last = kept + 2 * MOST_SECANTS * n;
    double *p = kept + 2 * n * (c->secants.count % MOST_SECANTS), *q = p + n;
    const int32_t known = c->secants.count < MOST_SECANTS ? c->secants.count : MOST_SECANTS;
    double *dp = last + n, *dq = last; /* the increment, and g before it */
    for (int32_t i = 0; i < n; i++) dq[i] = g[i] - dq[i];
    const double size = sqrt(product_of_increments(c, dq, dq)),
                 way = sqrt(product_of_increments(c, dp, dp));
    for (int32_t j = 0; j < known; j++) {
        const double *own = kept + 2 * n * j;
        const double part = product_of_increments(c, own + n, dq);
        add_multiple(n, -part, own + n, dq);
        add_multiple(n, -part, own, dp);
    }
    const double left = sqrt(product_of_increments(c, dq, dq));
    if (!(left > SHOWN_BEFORE * size)) {
        if (sqrt(product_of_increments(c, dp, dp)) > OF_OTHER_LAWS * way) forget_secants(c);
        return;
    }
    for (int32_t i = 0; i < n; i++) p[i] = dp[i] / left, q[i] = dq[i] / left;
    c->secants.count++;
}

/* Lets the increment at hand, in rhs, follow what laws do. */
HM_SELDOM static void follow_laws(context *c)
{
    const int32_t n = end_pivot(c);
    double *kept = c->k.secants, *last = kept + 2 * MOST_SECANTS * n, *g = c->k.rhs;
    if (c->secants.h != c->h || c->secants.lu != c->factors.lu)
        forget_secants(c);
    c->secants.h = c->h;
    c->secants.lu = c->factors.lu;
    if (c->secants.has_last) learn_secant(c, g);
    memcpy(last, g, sizeof(double) * (size_t)n);
    for (int32_t j = 0; j < c->secants.count && j < MOST_SECANTS; j++) {
        const double *p = kept + 2 * n * j, *q = p + n;
        const double part = product_of_increments(c, q, g);
        add_multiple(n, -part, q, g);
        add_multiple(n, -part, p, g);
    }
    memcpy(last + n, g, sizeof(double) * (size_t)n);
    c->secants.has_last = 1;
}

#endif
