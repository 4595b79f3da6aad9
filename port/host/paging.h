/*
 * paging.h - a device whose memory holds no volume, tried out: voxels through pages, read as if
 * from a raw file.
 */
#ifndef QVOL_HOST_PAGING_H
#define QVOL_HOST_PAGING_H

#include "json.h"
#include "settings.h"

struct paging {
    qv_pages pages;
    qv_linear file;   /* what would be read of a raw file */
    qv_volume source; /* the voxels */
};

/* Gives a volume pages; it stays in use until paging_free. */
void paging_create(struct paging *paging, qv_volume *volume, const struct settings *settings);

void paging_free(struct paging *paging);

void report_pages(struct json *json, const struct paging *paging);

#endif
