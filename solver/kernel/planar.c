/* The kernel for mechanisms in the plane: two coordinates a node. */
#define DIM 2
#define NAME(function) function##_planar

#include "forms.inc.h"
#include "composite.inc.h"
#include "registers.inc.h"
#include "beta.inc.h"
#include "function.inc.h"
#include "laws.inc.h"
#include "tangent.inc.h"
#include "predict.inc.h"
#include "step.inc.h"
#include "ledger.inc.h"
#include "energy.inc.h"
#include "clock.inc.h"
#include "start.inc.h"
#include "composition.inc.h"
#include "interval.inc.h"
#include "control.inc.h"
#include "advance.inc.h"
#include "seek.inc.h"
#include "measure.inc.h"
