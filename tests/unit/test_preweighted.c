/*
 * Sampling of associated colours against the formulas of tests/SPEC.md, section 70: one sample
 * after the other, each channel by itself, on random rays through volumes of random memory layout.
 */
#include "check.h"
#include "composite.h"
#include "preweighted.h"
#include "random.h"
#include "ray.h"

#include <string.h>

enum { EDGE_MAX = 9, VOXELS = EDGE_MAX * EDGE_MAX * EDGE_MAX, REACH = 300, RAYS = 4000 };

static uint32_t words[VOXELS]; /* aligned */
static qv_context context;

/* ---- Random volumes and rays ------------------------------------------------ */

/* No colour is above the opacity; one voxel of four is clear, one opaque. */
static void random_voxel(uint8_t voxel[4], uint32_t *seed, unsigned opacities)
{
    uint32_t kind = random_below(seed, 4);
    uint32_t opacity = kind == 0 ? 0 : kind == 1 ? opacities : random_below(seed, opacities + 1u);
    for (unsigned c = 0; c < 3; c++)
        voxel[c] = (uint8_t)random_below(seed, opacity + 1u);
    voxel[3] = (uint8_t)opacity;
}

/* Axes in random order, some of them running downwards. */
static void random_layout(qv_volume *volume, uint32_t *seed)
{
    static const unsigned orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                          {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const unsigned *order = orders[random_below(seed, 6)];
    int32_t stride = 4, first = 0;
    for (unsigned i = 0; i < 3; i++) {
        unsigned axis = order[i];
        int32_t size = (int32_t)(1 + random_below(seed, EDGE_MAX));
        volume->size[axis] = (uint16_t)size;
        volume->stride[axis] = stride;
        if (random_below(seed, 2) != 0) {
            volume->stride[axis] = -stride;
            first += (size - 1) * stride;
        }
        stride *= size;
    }
    volume->voxels = (qv_address)words + first;
    volume->voxels_bytes = (uint64_t)stride;
}

static void random_volume(uint32_t *seed)
{
    static const unsigned opacities[] = {1, 3, 20, 255};
    unsigned most = opacities[random_below(seed, 4)];
    qv_volume *volume = &context.scene.volume;
    memset(volume, 0, sizeof *volume);
    volume->storage = QV_STORAGE_ASSOCIATED8;
    random_layout(volume, seed);
    for (unsigned i = 0; i < VOXELS; i++)
        random_voxel((uint8_t *)&words[i], seed, most);
    assert_int_equal(qv_volume_check(volume), QV_OK);
}

static uint64_t random64(uint32_t *seed)
{
    uint64_t high = random_next(seed);
    return high << 32 | random_next(seed);
}

/* Sample 0 lies in the box; some rays run along axes or along faces. REACH samples leave the box
   on one axis at least. */
static qv_ray random_ray(uint32_t *seed)
{
    qv_ray ray = {.first = -REACH};
    for (unsigned axis = 0; axis < 3; axis++) {
        uint64_t size = (uint64_t)context.scene.volume.size[axis] << 32;
        unsigned pace = 33u - random_below(seed, 12); /* below 2 voxels a sample */
        ray.place[axis] = (qv_coord)(random64(seed) % size);
        ray.advance[axis] = (qv_coord)(random64(seed) >> (64u - pace));
        if (random_below(seed, 2) != 0)
            ray.advance[axis] = -ray.advance[axis];
        if (random_below(seed, 5) == 0)
            ray.advance[axis] = 0;
    }
    unsigned far = random_below(seed, 3);
    ray.advance[far] += (ray.advance[far] < 0 ? -1 : 1) * ((qv_coord)1 << 28);
    return ray;
}

/* ---- The specification ------------------------------------------------------ */

typedef struct gathered {
    uint64_t light[3], transmittance;
    uint32_t samples, skipped;
} gathered;

/* The sums at both ends of a cell's rows, of one channel. */
static void ends_of(uint64_t end[2], const int64_t place[3], unsigned channel)
{
    const qv_volume *volume = &context.scene.volume;
    uint32_t y = (uint32_t)((uint64_t)place[1] >> 24) % 256;
    uint32_t z = (uint32_t)((uint64_t)place[2] >> 24) % 256;
    uint32_t both = (y * z + 128) / 256;
    const uint32_t weight[4] = {256 - y - z + both, y - both, z - both, both};
    end[0] = end[1] = 0;
    for (unsigned corner = 0; corner < 8; corner++) {
        qv_address voxel = volume->voxels;
        for (unsigned axis = 0; axis < 3; axis++) {
            int64_t index = (place[axis] + ((int64_t)1 << 32)) / ((int64_t)1 << 32) - 1;
            index += corner >> axis & 1;
            index = index < 0 ? 0 : index >= volume->size[axis] ? volume->size[axis] - 1 : index;
            voxel += index * volume->stride[axis];
        }
        end[corner & 1] += (uint64_t)weight[corner >> 1] * voxel[channel];
    }
}

static uint64_t share_of(uint64_t v)
{
    return v / 65536 + v / 16777216;
}

static void under(gathered *g, const int64_t place[3])
{
    uint64_t end[4][2], x = (uint64_t)place[0] >> 24 & 255;
    uint64_t share = share_of(g->transmittance), high = share * x / 256, low = share - high;
    for (unsigned c = 0; c < 4; c++)
        ends_of(end[c], place, c);
    uint64_t taken = end[3][0] * low + end[3][1] * high;
    g->skipped += taken == 0;
    for (unsigned c = 0; c < 3; c++)
        g->light[c] += end[c][0] * low + end[c][1] * high;
    g->transmittance -= taken;
}

static void over(gathered *g, const int64_t place[3])
{
    uint64_t x = (uint64_t)place[0] >> 24 & 255, sample[4];
    for (unsigned c = 0; c < 4; c++) {
        uint64_t end[2];
        ends_of(end, place, c);
        sample[c] = (end[0] * (256 - x) + end[1] * x) / 256;
    }
    g->skipped += sample[3] == 0;
    for (unsigned c = 0; c < 3; c++)
        g->light[c] = g->light[c] - sample[3] * share_of(g->light[c]) + sample[c] * 65536;
    g->transmittance -= sample[3] * share_of(g->transmittance);
}

/* The points of samples number `from` to `to`, in this order. */
static gathered gather(const qv_ray *ray, int from, int to, int back)
{
    const uint64_t enough = 65536 + (uint64_t)context.scene.termination * 65280;
    gathered g = {{0, 0, 0}, 0xFF010000u, 0, 0};
    for (int k = from; k != to; k += back ? -1 : 1) {
        int64_t place[3];
        int in_box = 1;
        for (unsigned axis = 0; axis < 3; axis++) {
            place[axis] = ray->place[axis] + k * ray->advance[axis];
            in_box &= place[axis] >= 0 && place[axis] < (int64_t)context.scene.volume.size[axis]
                                                            << 32;
            place[axis] += ((int64_t)1 << 23) - ((int64_t)1 << 31);
        }
        if (!in_box)
            continue;
        g.samples++;
        if (back)
            over(&g, place);
        else
            under(&g, place);
        if (!back && g.transmittance <= enough)
            break;
    }
    return g;
}

/* ---- The tests ---------------------------------------------------------------- */

static void check_ray(const qv_sampling *sampling, qv_ray ray, int back)
{
    const int from = back ? REACH - 1 : -REACH, to = back ? -REACH - 1 : REACH;
    qv_light light = {{0, 0, 0}, QV_CLEAR, 0, 0};
    gathered g = gather(&ray, from, to, back);
    sampling->march(&light, &ray, &context);
    uint64_t rest = g.transmittance > 65536 ? g.transmittance - 65536 : 0;
    assert_int_equal(ray.all - ray.samples, g.samples);
    assert_int_equal(light.skipped, g.skipped);
    assert_int_equal(light.transmittance, (rest * 0x80808081u + 0x80000000u) >> 32);
    for (unsigned c = 0; c < 3; c++) {
        assert_int_equal(light.colour[c], (g.light[c] + 1) / 2);
        assert_true(g.light[c] <= 0xFF020000u);
        if (!back) /* never more than the opacity */
            assert_true(g.light[c] <= 0xFF010000u - g.transmittance);
    }
}

static void rays_are_as_specified(void **state)
{
    static const uint16_t terminations[] = {0, 0, QV_TERMINATION_DEFAULT, 20000, 65535};
    uint32_t seed = 1998;
    (void)state;
    for (unsigned i = 0; i < RAYS; i++) {
        if (i % 8 == 0)
            random_volume(&seed);
        context.scene.termination = terminations[random_below(&seed, 5)];
        qv_ray ray = random_ray(&seed);
        check_ray(&qv_preweighted_associated8, ray, 0);
        check_ray(&qv_preweighted_associated8_back_to_front, ray, 1);
    }
}

/* Words must lie at multiples of 4, and what weights colours itself takes none that are. */
static void refused(void **state)
{
    qv_volume volume = {.voxels = (qv_address)words,
                        .voxels_bytes = 4 * 2 * 2 * 2,
                        .stride = {4, 8, 16},
                        .size = {2, 2, 2},
                        .storage = QV_STORAGE_ASSOCIATED8};
    uint32_t coarser;
    (void)state;
    assert_int_equal(qv_volume_check(&volume), QV_OK);
    assert_int_equal(qv_downsample(&coarser, 4, &volume, &qv_filter_box2, &qv_domain_stored, 0, 1),
                     QV_ERROR_STORAGE);
    volume.voxels_bytes++;
    volume.stride[2]++;
    assert_int_equal(qv_volume_check(&volume), QV_ERROR_STRIDE);
    volume.stride[2]--;
    volume.voxels += 2;
    assert_int_equal(qv_volume_check(&volume), QV_ERROR_STRIDE);
    volume.voxels -= 2;
    volume.storage++;
    assert_int_equal(qv_volume_check(&volume), QV_ERROR_STORAGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_are_as_specified),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
