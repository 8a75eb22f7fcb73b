/* What is said of a start that fails. */
#include "small.h"

#include "sentences.h"

/* Why a mechanism has no start, as far as the core tells. */
static const char *about_start(int32_t status, int seeks_equilibrium)
{
    if (status == HOLONOM_STOPPED) return "it was interrupted; start again";
    if (status == HOLONOM_NEWTON_DIVERGED && seeks_equilibrium)
        return "no static equilibrium was found from the drawn configuration; look for a part that "
               "nothing holds, or draw it closer "
               "to where it comes to rest";
    if (status == HOLONOM_SINGULAR_TANGENT)
        return "its equations have no unique solution as drawn; look for a part that nothing holds "
               "against its constraints, or use "
               "a smaller solver.penalty";
    if (status == HOLONOM_NOT_FINITE)
        return "a number of it is not finite; look at the expressions of positions, forces and "
               "drivers at the start";
    return hm_about_step(status);
}

int hm_say_failed_start(hm_text *text, const hm_model_file *f, const double *numbers,
                        const hm_state *s, const hm_start *start)
{
    const double *head = s->head;
    const int32_t status = start->status;
    const int is_closed = head[S_ASSEMBLE] != 0.0;
    int problems = 0;
    if (!status || status == HOLONOM_AT_DEAD_CENTRE
        || (status == HOLONOM_UZAWA_DIVERGED && is_closed))
        problems = hm_contradicted_rows(text, f, numbers, s, start->phi, start->rate);
    if (problems || !status) return problems;
    if (status == HOLONOM_AT_DEAD_CENTRE) {
        hm_say_dead_centre(text, f, numbers, s, start->lacking);
        return 1;
    }
    const size_t begin = text->used;
    if (status >= HOLONOM_CONTACT_UNDECIDED || status == HOLONOM_NOT_FINITE)
        hm_say_fault(text, f, numbers, head, status);
    hm_say(text, "%s%s", text->used > begin ? "" : "the mechanism cannot be assembled: ",
           about_start(status, head[S_EQUILIBRIUM] != 0.0));
    return 1;
}

#include "small.h"
