/* The mechanics and the step, as one unit, so that small functions vanish in their callers. */
#include "advance.h"
#include "initialise.h"
#include "rates.h"
