/* The methods and orders of a step, and what each costs and errs: from these a tolerance chooses
   (control.h). */
#ifndef HOLONOM_METHOD_TABLE_H
#define HOLONOM_METHOD_TABLE_H

#include "context.h"

/* A step of order p. */
typedef struct method {
    enum method_kind kind;
    int order;         /* p */
    double lower;      /* r */
    double rate,
        mean; /* omega h over e^(1/(r+1)), and error over (omega h)^(p+1): means over mechanisms */
    double round_off;  /* of the difference: the norm of the weights times that of a solved step */
    double fastest;    /* largest omega h at which Newton's iteration still converges well */
    double solutions;  /* half steps in it, or stages */
} method;

/* The rates of explicit ones are of a spring that swings; their errors are 1.8 times that of a step
   of one, |b A^p 1 - 1/(p+1)!| by the tableau, 1.4e-4 and 6.4e-8: other motions err by more. */
static const method METHODS[] = {{COMPOSED, 2, 2.0, 1.0, 1.1e-2, 1e-13, 1.0, 2.0},
                                 {COVERED, 4, 2.0, 4.9, 2.4e-3, 1e-14, 1.0, 6.0},
                                 {COVERED, 6, 4.0, 5.9, 3e-5, 1e-14, 1.5, 12.0},
                                 {COVERED, 8, 6.0, 6.2, 7e-7, 1e-14, 2.0, 20.0},
                                 {EXPLICIT, 5, 4.0, 5.3, 2.5e-4, 1e-14, 2.0, 6.0},
                                 {EXPLICIT, 8, 7.0, 6.2, 1.1e-7, 1e-14, 4.0, 12.0}};
enum { N_METHODS = sizeof METHODS / sizeof *METHODS };

/* Steps of an order that are explicit, or not; of half steps where only these have the order. */
static const method *method_of(int order, int is_explicit)
{
    const method *found = METHODS;
    for (const method *x = METHODS; x < METHODS + N_METHODS; x++)
        if (x->order == order && (x->kind != EXPLICIT || is_explicit)) found = x;
    return found;
}

#endif
