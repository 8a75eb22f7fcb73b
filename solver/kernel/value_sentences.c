/* Which values a variable may take, and what is said of others. */
#include "small.h"

#include "sentences.h"

#include <string.h>

const char *hm_word(const hm_model_file *f, const hm_variable *v, double value)
{
    const char *word = f->text + v->words;
    if (!(value >= 0.0) || v->type != TYPE_STRING) return NULL;
    for (; value >= 1.0 && *word; value--) word += strlen(word) + 1;
    return *word ? word : NULL;
}

const char *hm_formulation_word(const hm_model_file *f, double number)
{
    for (uint32_t k = 0; k < f->header->n_variables; k++)
        if (f->variable[k].kind == KIND_OPTION && f->variable[k].place == S_FORMULATION) return hm_word(f, f->variable + k, number);
    return NULL;
}

double hm_limit_before(const hm_variable *v, double value)
{
    if (v->flags & HAS_MINIMUM && value < v->minimum) return v->minimum;
    if (v->flags & HAS_MAXIMUM && value > v->maximum) return v->maximum;
    return NAN;
}

/* Says "rule, got value". */
static int object(hm_text *text, const char *rule, double value, const char *shown)
{
    if (shown) hm_say(text, "%s, got %s", rule, shown);
    else hm_say(text, "%s, got %r", rule, value);
    return 1;
}

static int objects_to_word(hm_text *text, const hm_model_file *f, const hm_variable *v, double value, const char *shown)
{
    if (value == floor(value) && hm_word(f, v, value)) return 0;
    hm_say(text, "must be one of ");
    for (double k = 0.0; hm_word(f, v, k); k++) hm_say(text, "%s%s", k > 0.0 ? ", " : "", hm_word(f, v, k));
    return object(text, "", value, shown);
}

static int objects_to_setting(hm_text *text, const hm_model_file *f, const hm_variable *v, double value, const char *shown)
{
    const char *unit = f->text + v->unit, *gap = *unit ? " " : "";
    if (v->type == TYPE_STRING) return objects_to_word(text, f, v, value, shown);
    if (v->type == TYPE_BOOLEAN) return value == 0.0 || value == 1.0 ? 0 : object(text, "must be true or false", value, shown);
    if (v->flags & ORDER)
        return value == 0.0 || value == 2.0 || value == 4.0 || value == 6.0 || value == 8.0
                   ? 0
                   : object(text, "must be 2, 4, 6 or 8, or 0 for the one that a tolerance chooses", value, shown);
    const int positive = v->minimum > 0.0, whole = v->flags & WHOLE;
    if ((positive ? value > 0.0 : value >= 0.0) && value <= v->maximum && !(value > 0.0 && value < v->least) &&
        (!whole || value == floor(value)))
        return 0;
    if (v->least > 0.0) hm_say(text, "must be 0 or a number from %6g, some round-off, to %6g", v->least, v->maximum);
    else hm_say(text, "must be a%s number %s 0 and <= %6g", whole ? " whole" : "", positive ? ">" : ">=", v->maximum);
    hm_say(text, "%s%s", gap, unit);
    return object(text, "", value, shown);
}

int hm_objects(hm_text *text, const hm_model_file *f, const hm_variable *v, double value, const char *shown, int moving)
{
    const char *unit = f->text + v->unit, *gap = *unit ? " " : "";
    const size_t begin = text->used;
    hm_say(text, "%s: ", f->text + v->name);
    if (v->causality > CAUSALITY_INPUT) {
        hm_say(text, "is calculated and cannot be set");
        return 1;
    }
    if (v->variability == VARIABILITY_FIXED && moving) {
        hm_say(text, "is a fixed parameter; set it before the first step, or reset first");
        return 1;
    }
    if (v->kind == KIND_OPTION) {
        if (objects_to_setting(text, f, v, value, shown)) return 1;
    } else if (!(fabs(value) < INFINITY)) {
        hm_say(text, "must be a finite number%s%s%s", *unit ? " in" : "", gap, unit);
        return object(text, "", value, shown);
    } else {
        const double limit = hm_limit_before(v, value);
        if (limit == limit && !(v->flags & CLIPS)) {
            hm_say(text, "must be %s %6g%s%s", value < limit ? ">=" : "<=", limit, gap, unit);
            object(text, "", value, shown);
            if (v->causality == CAUSALITY_INPUT)
                hm_say(text, "; with limit = \"clip\" in the scene's [inputs] it is %6g instead", limit);
            return 1;
        }
    }
    text->used = begin;
    text->begin[begin] = 0;
    return 0;
}
