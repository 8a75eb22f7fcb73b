/* Which values a variable may take, and what is said of others. */
#include "small.h"

#include "sentences.h"

/* Word number `value` of an option, or NULL. */
static const char *word_of(const hm_model_file *f, const hm_variable *v, double value)
{
    const char *word = f->text + v->words;
    if (!(value >= 0.0)) return NULL;
    for (; value >= 1.0 && *word; value--) word += strlen(word) + 1;
    return *word ? word : NULL;
}

const char *hm_word(const hm_model_file *f, const hm_variable *v, double value)
{
    return v->type == TYPE_STRING ? word_of(f, v, value) : NULL;
}

double hm_limit_before(const hm_variable *v, double value)
{
    if (v->flags & HAS_MINIMUM && value < v->minimum) return v->minimum;
    if (v->flags & HAS_MAXIMUM && value > v->maximum) return v->maximum;
    return NAN;
}

void hm_say_value(hm_text *text, double value, const char *shown)
{
    if (shown) hm_say(text, "%s", shown);
    else hm_say(text, "%r", value);
}

static void say_rule(hm_text *text, const hm_model_file *f, const hm_variable *option)
{
    hm_say(text, "must be %s", option->type == TYPE_STRING ? "one of " : "");
    for (double k = 0.0; word_of(f, option, k); k++)
        hm_say(text, "%s%s", k > 0.0 ? ", " : "", word_of(f, option, k));
}

static int is_allowed(const hm_model_file *f, const hm_variable *v, double value)
{
    if (v->type == TYPE_STRING) return value == floor(value) && hm_word(f, v, value);
    if (v->type == TYPE_BOOLEAN) return value == 0.0 || value == 1.0;
    if ((v->flags & WHOLE && value != floor(value))
        || (v->flags & EVEN && value != 2.0 * floor(0.5 * value)))
        return 0;
    return value >= v->minimum && value <= v->maximum && !(value > 0.0 && value < v->least);
}

int hm_objects(hm_text *text, const hm_model_file *f, const hm_variable *v, double value,
               const char *shown, int moving)
{
    const char *unit = f->text + v->unit;
    const size_t begin = text->used;
    const double limit = hm_limit_before(v, value);
    hm_say(text, "%s: ", f->text + v->name);
    if (v->causality > CAUSALITY_INPUT) {
        hm_say(text, "is calculated and cannot be set");
        return 1;
    }
    if (v->variability == VARIABILITY_FIXED && moving) {
        hm_say(text, "is a fixed parameter; set it before the first step, or reset first");
        return 1;
    }
    if (v->kind == KIND_OPTION ? is_allowed(f, v, value)
                               : fabs(value) < INFINITY && (limit != limit || v->flags & CLIPS)) {
        hm_take_back(text, begin);
        return 0;
    }
    if (v->kind == KIND_OPTION) say_rule(text, f, v);
    else if (!(fabs(value) < INFINITY))
        hm_say(text, "must be a finite number%s%u", *unit ? " in" : "", unit);
    else hm_say(text, "must be %s %6g%u", value < limit ? ">=" : "<=", limit, unit);
    hm_say(text, ", got ");
    hm_say_value(text, value, shown);
    if (v->causality == CAUSALITY_INPUT && fabs(value) < INFINITY)
        hm_say(text, "; with limit = \"clip\" in the scene's [inputs] it is %6g instead", limit);
    return 1;
}

#include "small.h"
