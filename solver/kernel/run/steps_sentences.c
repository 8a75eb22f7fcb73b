/* Which steps the settings choose, in words. */
#include "small.h"

#include "sentences.h"

/* Says how equal steps of an order above 2 are taken, and what makes it so. */
static void say_methods(hm_text *text, const hm_model_file *f, const double *numbers,
                        const holonom_methods *methods)
{
    const holonom_model *m = &f->model;
    const double others = methods->losses - 1.0;
    if (!methods->covered) {
        hm_say(text, ", by symmetric compositions");
        return;
    }
    hm_say(text, ", by weighted covers%s ", methods->composed ? " where" : ", since");
    if (!hm_say_composite(text, f, numbers, methods->first)) hm_say(text, "a damper");
    if (others > 0.0) hm_say(text, " and %6g other%s take", others, others > 1.0 ? "s" : "");
    else hm_say(text, " takes");
    hm_say(text, " energy out");
    if (methods->composed)
        hm_say(text, "%s, elsewhere by symmetric compositions",
               HM_CONTACTS && m->n_contacts + m->n_frictions ? " or parts touch or rub" : "");
    else if (m->n_islands > 1 && m->sensing) hm_say(text, " and formulas read the motion");
}

void hm_say_steps(hm_text *text, const hm_model_file *f, const double *numbers, const double *head,
                  const holonom_methods *methods, int is_explicit)
{
    const double tolerance = hm_tolerance(head), order = head[S_ORDER];
    const int is_stepped = head[S_CONTACT_MODE] != 0.0;
    hm_say(text, "conserving steps");
    if (!(tolerance > 0.0) || order > 0.0)
        hm_say(text, " of order %6g", order > 0.0 && !is_stepped ? order : 2.0);
    if (is_explicit) hm_say(text, ", and explicit ones where they are possible");
    if (tolerance > 0.0) hm_say(text, ", chosen for a relative error of the run of %6g", tolerance);
    else {
        hm_say(text, ", of at most %6g s", hm_step_size(head));
        if (order > 2.0 && !is_stepped) say_methods(text, f, numbers, methods);
    }
    if (is_stepped && head[S_TOLERANCE] > 0.0)
        hm_say(text, ": contact_mode stepped takes equal steps, whatever the tolerance");
}

#include "small.h"
