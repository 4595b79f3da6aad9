/*
 * golden_device.h - a device's program for one set of golden scenes.
 */
#ifndef GOLDEN_DEVICE_H
#define GOLDEN_DEVICE_H

#include "scenes.h"

/* Renders the scenes of a set and tells their checksums. */
void golden_run(const golden_set *set);

#endif /* GOLDEN_DEVICE_H */
