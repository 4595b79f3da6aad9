#include "reference.h"

/* Puts the scene's background, given unweighted, behind the light. */
static void add_background(double light[4], const uint8_t background[4])
{
    const double opacity = background[3] / 255.0;
    double associated[4] = {0, 0, 0, opacity};
    for (int channel = 0; channel < 3; channel++) {
        associated[channel] = background[channel] / 255.0 * opacity;
    }
    ref_under(light, associated);
}

static void march(ref_pixel *pixel, const qv_scene *scene, ref_mode mode, const ref_ray *ray,
                  bool rounded)
{
    double light[4] = {0, 0, 0, 0}, point[3], sample[4];
    for (int64_t j = 0; j < ray->count; j++) {
        ref_point(point, ray, j);
        if (rounded) {
            ref_round_point(point);
        }
        ref_reconstruct(sample, &scene->volume, mode, point);
        ref_under(light, sample);
    }
    pixel->opacity = light[3];
    pixel->samples = ray->count;
    add_background(light, scene->background);
    for (int channel = 0; channel < 4; channel++) {
        pixel->rgba[channel] = light[channel];
    }
}

void ref_render(ref_pixel *pixel, const qv_scene *scene, ref_mode mode, int32_t x, int32_t y)
{
    ref_ray ray;
    ref_stored_ray(&ray, scene, x, y);
    march(pixel, scene, mode, &ray, true);
}

void ref_render_ideal(ref_pixel *pixel, const qv_scene *scene, const ref_view *view, ref_mode mode,
                      int32_t x, int32_t y)
{
    ref_ray ray;
    ref_ideal_ray(&ray, scene, view, x, y);
    march(pixel, scene, mode, &ray, false);
}
