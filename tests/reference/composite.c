#include "reference.h"

void ref_under(double light[4], const double sample[4])
{
    const double transmittance = 1 - light[3];
    for (int channel = 0; channel < 4; channel++) {
        light[channel] += transmittance * sample[channel];
    }
}

void ref_over(double light[4], const double sample[4])
{
    const double transmittance = 1 - sample[3];
    for (int channel = 0; channel < 4; channel++) {
        light[channel] = transmittance * light[channel] + sample[channel];
    }
}
