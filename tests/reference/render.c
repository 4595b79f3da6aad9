#include "reference.h"

#include <math.h>

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

/* Samples that know no length. */
static void march_samples(ref_pixel *pixel, const qv_scene *scene, ref_mode mode,
                          const ref_ray *ray, bool rounded)
{
    double point[3], sample[4];
    for (int64_t j = 0; j < ray->count; j++) {
        ref_point(point, ray, (double)j);
        if (rounded) {
            ref_round_point(point);
        }
        ref_reconstruct(sample, &scene->volume, mode, point);
        ref_under(pixel->rgba, sample);
    }
    pixel->samples = ray->count;
}

/* Reconstructs in one level, at a point of the volume's voxel coordinates. */
static void sample_level(double sample[4], const qv_scene *scene, ref_mode mode,
                         const double point[3], int number, bool rounded)
{
    qv_volume level;
    double place[3];
    ref_pyramid_level(&level, scene, number);
    for (int axis = 0; axis < 3; axis++) {
        place[axis] = ldexp(point[axis], -number);
    }
    if (rounded) {
        ref_round_point(place);
    }
    ref_reconstruct(sample, &level, mode, place);
}

/* Reconstructs in a level and blends with the next coarser one. */
static void sample_between(double sample[4], const qv_scene *scene, ref_mode mode,
                           const double point[3], int finer, double share, bool rounded)
{
    sample_level(sample, scene, mode, point, finer, rounded);
    if (share > 0) {
        double coarser[4];
        sample_level(coarser, scene, mode, point, finer + 1, rounded);
        for (int channel = 0; channel < 4; channel++) {
            sample[channel] += share * (coarser[channel] - sample[channel]);
        }
    }
}

/* Puts a piece, sampled at its middle and weighed by its length, behind the light. */
static void add_piece(double light[4], const qv_scene *scene, ref_mode mode, const ref_ray *ray,
                      const ref_piece *piece, const ref_span *span, bool rounded)
{
    const double middle = (piece->begin + piece->end) / 2;
    const double length = (piece->end - piece->begin) * (scene->camera.step / 65536.0);
    const double share = ref_share(span, ref_grid(ray, middle));
    double point[3], sample[4];
    ref_point(point, ray, middle);
    sample_between(sample, scene, mode, point, span->level, share, rounded);
    ref_weigh(sample, &scene->volume, mode, length);
    ref_under(light, sample);
}

static void march_pieces(ref_pixel *pixel, const qv_scene *scene, ref_mode mode, const ref_ray *ray,
                         bool rounded)
{
    qv_scene of = *scene;
    ref_piece piece = ref_first_piece(ray);
    ref_span span;
    if (of.volume.unit_distance == 0) {
        of.volume.unit_distance = scene->camera.step;
    }
    ref_span_at(&span, &of, ref_grid(ray, piece.end));
    for (pixel->samples = 0; ref_next_piece(&piece, ray, ldexp(1, span.level), span.end);
         pixel->samples++) {
        add_piece(pixel->rgba, &of, mode, ray, &piece, &span, rounded);
        ref_span_at(&span, &of, ref_grid(ray, piece.end));
    }
}

static void march(ref_pixel *pixel, const qv_scene *scene, ref_mode mode, const ref_ray *ray,
                  bool rounded)
{
    for (int channel = 0; channel < 4; channel++) {
        pixel->rgba[channel] = 0;
    }
    if (ref_is_by_length(mode)) {
        march_pieces(pixel, scene, mode, ray, rounded);
    } else {
        march_samples(pixel, scene, mode, ray, rounded);
    }
    pixel->opacity = pixel->rgba[3];
    add_background(pixel->rgba, scene->background);
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
