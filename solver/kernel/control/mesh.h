/* The mesh of a run: how each of its internal steps was taken, and what ended it (repeat.h takes
   them again).

   A row (layout.py, MESH) has what a step was asked for, what came of it, and the sides of switches
   in it. A step that is taken back leaves no row: the next one begins no later. */
#ifndef HOLONOM_MESH_H
#define HOLONOM_MESH_H

#include "step.h"

/* The mesh that is recorded, and the one that is repeated, or NULL; no FMU has either. */
#if defined(HOLONOM_STATIC)
static inline holonom_mesh *mesh_of(const context *c) { return (void)c, (holonom_mesh *)NULL; }
static inline const holonom_mesh *repeated_by(const context *c)
{ return (void)c, (const holonom_mesh *)NULL; }
#else
static inline holonom_mesh *mesh_of(const context *c)
{ return c->mesh && !c->mesh->start ? c->mesh : NULL; }
static inline const holonom_mesh *repeated_by(const context *c)
{ return c->mesh && c->mesh->start ? c->mesh : NULL; }
#endif

/* How many numbers a row has, and its sides (n_switches). */
static inline int64_t row_size(const context *c) { return MESH_SIZE + c->m->n_switches; }
static inline const double *sides_of_row(const double *row) { return row + MESH_SIZE; }

/* Number that tells modes of contacts and frictions apart. */
HM_SELDOM static double modes_of(const context *c)
{
    uint32_t code = 0;
    for (int32_t i = 0; i < n_contacts(c->m); i++) code = 31 * code + (is_closed(c, i) ? 2 : 1);
    for (int32_t f = 0; f < n_frictions(c->m); f++)
        code = 31 * code + (uint32_t)friction_mode(c, f) + 1;
    return code;
}

/* Notes what is done to the state ahead of a step, maybe more than once: tries that fail leave it
   so. */
HM_SELDOM static void note_ahead(context *c, int what)
{
    holonom_mesh *x = mesh_of(c);
    x->ahead[what] = x->ahead_of[what] == c->t ? x->ahead[what] + 1.0 : 1.0;
    x->ahead_of[what] = c->t;
}

/* What was done ahead of a step from the state that backups of its start have, and that they bring
   back. */
static inline void keep_ahead(const context *c)
{
    holonom_mesh *x = mesh_of(c);
    if (!x) return;
    memcpy(x->ahead_kept, x->ahead, sizeof x->ahead);
    memcpy(x->ahead_of_kept, x->ahead_of, sizeof x->ahead_of);
}

static inline void put_ahead_back(const context *c)
{
    holonom_mesh *x = mesh_of(c);
    if (!x) return;
    memcpy(x->ahead, x->ahead_kept, sizeof x->ahead);
    memcpy(x->ahead_of, x->ahead_of_kept, sizeof x->ahead_of);
}

/* The row of the last step, whose end is at hand. */
static double *last_row(const context *c)
{ return mesh_of(c)->row + row_size(c) * (mesh_of(c)->count - 1); }

/* Forgets the rows of steps from the present time on, which were taken back. */
HM_SELDOM static void forget_rows(context *c)
{
    while (mesh_of(c)->count && last_row(c)[MESH_TIME] >= c->t) mesh_of(c)->count--;
}

/* Begins the row of an internal step of length h. */
HM_SELDOM static void begin_row(context *c, double h)
{
    holonom_mesh *x = mesh_of(c);
    const double *head = c->s.head;
    forget_rows(c);
    x->is_full |= x->count == x->room;
    if (x->is_full) x->count = x->room - 1;
    double *row = x->row + row_size(c) * x->count;
    memset(row, 0, sizeof(double) * MESH_SIZE);
    row[MESH_TIME] = c->t;
    row[MESH_LENGTH] = h;
    row[MESH_USUAL] = usual_length(c);
    row[MESH_ORDER] = head[S_ORDER_IN_USE];
    row[MESH_EXPLICIT] = head[S_EXPLICIT];
    row[MESH_CAREFUL] = c->step.careful;
    row[MESH_KNOWN] = head[S_KNOWN];
    row[MESH_ANEW] = x->back_at == c->t;
    for (int k = 0; k < HOLONOM_AHEAD; k++)
        row[MESH_LOWERED + k] = x->ahead_of[k] == c->t ? x->ahead[k] : 0.0;
    row[MESH_FUNCTION] = -1.0;
    row[MESH_MODES] = modes_of(c);
    memcpy(row + MESH_SIZE, c->s.side, sizeof(double) * (size_t)c->m->n_switches);
}

/* How the last internal step was taken. */
static int taken_as(const step_result *last)
{
    if (last->method == EXPLICIT) return TAKEN_EXPLICIT;
    return last->method == COMPOSED ? TAKEN_PAIRS : last->finest ? TAKEN_FINEST : TAKEN_COVER;
}

/* Ends the row of a step that was taken so. */
HM_SELDOM static void end_row(context *c, int taken)
{
    holonom_mesh *x = mesh_of(c);
    x->row[row_size(c) * x->count + MESH_TAKEN] = taken;
    x->count++;
}

/* Says what ended the last step: an event function, with the value that is left of it. */
HM_SELDOM static void say_end(context *c, int end, int32_t function, double value)
{
    double *row = last_row(c);
    row[MESH_END] = end;
    row[MESH_FUNCTION] = function;
    row[MESH_VALUE] = value;
}

/* Says that switch k, which has changed at the present time, ended the step before, unless contacts
   or another switch did. */
HM_SELDOM static void say_switch(context *c, int end, int32_t k, double value)
{
    forget_rows(c);
    if (!mesh_of(c)->count || last_row(c)[MESH_END] != END_LENGTH) return;
    say_end(c, end, c->m->n_contacts + c->m->n_frictions + k, value);
    last_row(c)[MESH_SIDE] = end == END_SWITCH ? c->s.side[k] : 0.0;
}

#endif
