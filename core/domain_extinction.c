#include "qvol.h"

#include "fx_log.h"

/* Extinction is Q8.24. Opacities of 8 bits widen to 16 exactly, so they need no table of
   their own. */
QV_DESCRIPTOR qv_domain qv_domain_extinction = {fx_extinction_of_unorm16, fx_opacity16, 1};
