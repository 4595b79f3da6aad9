/*
 * report_export.h - what was written and how to read it again, as JSON.
 */
#ifndef QVOL_HOST_REPORT_EXPORT_H
#define QVOL_HOST_REPORT_EXPORT_H

#include "export.h"

void report_export(output *out, const struct export *export);

#endif
