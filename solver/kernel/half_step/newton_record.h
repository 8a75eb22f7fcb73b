/* What Newton's iteration of a step has seen so far. */
#ifndef HOLONOM_NEWTON_RECORD_H
#define HOLONOM_NEWTON_RECORD_H

#include "context.h"

/* Of the factors at hand: whether there are any, served an earlier increment too, are those of the
   half step before, and whether they are lean ones that contract too little. */
typedef struct factor_use {
    int made, kept, taken_over, slow;
} factor_use;

typedef struct newton_record {
    double contraction; /* of the increments */
    double contraction_above_round_off; /* likewise, of the last ones that are larger */
    double predicted_contraction; /* that earlier steps tell of the factors at hand, or 1 */
    double eta, previous;    /* the last increment and the one before it, in the mass norm
                                [kg^1/2 m] */
    double first;            /* the first one with the factors at hand */
    double first_increment;  /* the first one of the step */
    double size;             /* of d, likewise */
    double target, floor;    /* tolerance and round-off of increments */
    double energy, noise;    /* reference energy, and kinetic energy of the round-off of positions
                                [J] */
    int iteration;           /* number of the increment since the multipliers were held, from 0 */
    factor_use factors;
    int updated_multipliers; /* whether an early update of them followed the last increment */
    int missed;              /* whether what dependent rows cannot meet together was accepted */
    int penalty_raises;      /* so far */
    int increments, updates; /* Newton increments and Uzawa updates of the step */
} newton_record;

/* Whether the increment is no good: a long first one of lean factors, whose stiffness was missing,
   tells nothing. */
static inline int is_misled(const newton_record *r) { return r->factors.slow && r->iteration == 0; }

#endif
