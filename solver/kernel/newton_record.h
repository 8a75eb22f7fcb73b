/* What Newton's iteration of a step has seen so far. */
#ifndef HOLONOM_NEWTON_RECORD_H
#define HOLONOM_NEWTON_RECORD_H

#include "context.h"

typedef struct newton_record {
    double theta, eta, size; /* contraction; in the mass norm, the last increment and d [kg^1/2 m]               */
    double target, floor;    /* tolerance and round-off of increments                                          */
    double energy, noise;    /* reference energy, and kinetic energy of the round-off of positions [J]          */
    int factorised, stiffened;
    int taken_over;          /* factors are those of the half step before                                           */
    int increments;      /* of the step                                                                            */
    int updates;         /* Uzawa updates of the step                                                             */
} newton_record;

#endif
