#include "fx_log.h"

#include "fx_log8_table.h"

fx_extinction fx_extinction_of_unorm8(fx_unorm8 opacity)
{
    return fx_table32(&log8_extinction[opacity]);
}
