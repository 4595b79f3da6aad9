/*
 * planet.c - the volume of port/avr/firmware_planet.c. Integers only, so that every machine
 * makes the same.
 *
 * Lengths are in 1/16 of a voxel, the origin is the centre of the volume; directions and
 * shares have 10 fraction bits.
 */
#include "planet_make.h"
#include "fx_dither.h"

#include <stdbool.h>

enum { SIZE = PLANET_SIZE, VOXEL = 16, ONE = 1024, FULL = 65535 };

/* The palette: clear, fog, planet, ring. */
enum {
    FOG = 1,
    FOG_DENSITIES = 31,
    FOG_HUES = 2,
    PARTS = 4, /* shares of a voxel that a surface fills */
    SHADES = 16,
    BANDS = 2,
    PLANET = 64,
    RING = PLANET + BANDS * SHADES * PARTS
};

enum {
    PLANET_RADIUS = 135,
    BAND = 44, /* width of the planet's stripes */
    RING_INNER = 170,
    GAP_INNER = 203,
    GAP_OUTER = 214,
    RING_OUTER = 246,
    RING_HALF = 9,     /* of its thickness */
    RING_BRIGHT = 850, /* of ONE, and what its grooves add */
    RING_GROOVE = 60,
    GROOVES = 3,
    AMBIENT = 150,     /* of ONE */
    SHADOW = 3,        /* divides the light where the ring's shadow falls on the planet */
    FOG_CELL = 8,      /* voxels from one value of noise to the next */
    FOG_LEAST = 270,   /* noise below it is clear */
    FOG_MOST = 720,    /* and from here on it is densest */
    FOG_OPACITY = 1100 /* of the densest for a slice, of 65535 */
};

typedef struct {
    int32_t x, y, z;
} vector;

static const vector light = {-560, -660, 540};
static const vector axis = {250, -400, 895}; /* of the planet; the ring lies across it */

static const uint8_t fog_colours[FOG_HUES][3] = {{70, 150, 255}, {235, 90, 240}};
static const uint8_t band_colours[BANDS][3] = {{255, 205, 130}, {225, 140, 80}};
static const uint8_t ring_colour[3] = {250, 225, 190};

static int32_t dot(vector a, vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* floor(sqrt(n)) for n < 2^20. */
static int32_t root(int32_t n)
{
    int32_t r = 0;
    for (int32_t bit = 1 << 9; bit != 0; bit >>= 1)
        if ((r + bit) * (r + bit) <= n)
            r += bit;
    return r;
}

static int32_t clamp(int32_t v, int32_t low, int32_t high)
{
    return v < low ? low : v > high ? high : v;
}

/* ---- Noise ------------------------------------------------------------------ */

/* 0 .. ONE - 1, at random. */
static int32_t lattice(int32_t x, int32_t y, int32_t z, uint32_t seed)
{
    uint32_t cell = (uint32_t)(x + 64 * y + 4096 * z) * 2u + 1u;
    return (int32_t)(fx_hash(cell + (seed << 20)) >> 22);
}

static int32_t mix(int32_t a, int32_t b, int32_t share)
{
    return a + (b - a) * share / ONE;
}

/* 3 t^2 - 2 t^3 of the place between two values. */
static int32_t smooth(int32_t place, int32_t cell)
{
    int32_t t = place * ONE / cell;
    return t * t / ONE * (3 * ONE - 2 * t) / ONE;
}

/* 0 .. ONE - 1: values on a lattice, interpolated. */
static int32_t noise(vector at, int32_t cell, uint32_t seed)
{
    int32_t x = at.x / cell, y = at.y / cell, z = at.z / cell;
    int32_t along_x = smooth(at.x % cell, cell), along_y = smooth(at.y % cell, cell);
    int32_t plane[2];
    for (int32_t k = 0; k < 2; k++) {
        int32_t near = mix(lattice(x, y, z + k, seed), lattice(x + 1, y, z + k, seed), along_x);
        int32_t far =
            mix(lattice(x, y + 1, z + k, seed), lattice(x + 1, y + 1, z + k, seed), along_x);
        plane[k] = mix(near, far, along_y);
    }
    return mix(plane[0], plane[1], smooth(at.z % cell, cell));
}

static int32_t fog(vector at)
{
    int32_t dense = (2 * noise(at, FOG_CELL, 1) + noise(at, FOG_CELL / 2, 2)) / 3;
    int32_t density =
        clamp((dense - FOG_LEAST) * FOG_DENSITIES / (FOG_MOST - FOG_LEAST), 0, FOG_DENSITIES);
    int32_t hue = noise(at, 2 * FOG_CELL, 3) * FOG_HUES / ONE;
    return density == 0 ? 0 : FOG + hue * FOG_DENSITIES + density - 1;
}

/* ---- Surfaces --------------------------------------------------------------- */

/* Whether a point of the ring's plane, so far from the centre, belongs to the ring. */
static bool in_ring(int32_t radius)
{
    return (radius >= RING_INNER && radius < GAP_INNER) ||
           (radius >= GAP_OUTER && radius < RING_OUTER);
}

/* The shade of a surface, 0 .. SHADES - 1. */
static int32_t shade(int32_t cosine)
{
    int32_t bright = AMBIENT + (ONE - AMBIENT) * clamp(cosine, 0, ONE) / ONE;
    return clamp(bright * SHADES / ONE, 0, SHADES - 1);
}

/* The ring's shadow falls where the way to the light crosses it. */
static bool shadowed_by_ring(vector p)
{
    int32_t height = dot(p, axis) / ONE, rise = dot(light, axis) / ONE;
    if (height * rise >= 0)
        return false;
    int32_t way = -height * ONE / rise;
    vector q = {p.x + light.x * way / ONE, p.y + light.y * way / ONE, p.z + light.z * way / ONE};
    return in_ring(root(dot(q, q)));
}

static bool shadowed_by_planet(vector p)
{
    int32_t along = dot(p, light) / ONE;
    return along < 0 && dot(p, p) - along * along < PLANET_RADIUS * PLANET_RADIUS;
}

/* How much of a voxel lies within, in PARTS, for the distance inside a surface. */
static int32_t filled(int32_t inside)
{
    return clamp((inside + VOXEL / 2) * PARTS / VOXEL, 0, PARTS);
}

/* The palette's index of a surface whose entries begin at `first`. */
static int32_t surface(int32_t first, int32_t shade_of_it, int32_t part)
{
    return first + shade_of_it * PARTS + part - 1;
}

static int32_t planet(vector p, int32_t radius, int32_t part)
{
    int32_t cosine = dot(p, light) / (radius != 0 ? radius : 1);
    int32_t latitude = dot(p, axis) / ONE + PLANET_RADIUS;
    int32_t band = latitude / BAND % BANDS;
    if (shadowed_by_ring(p))
        cosine /= SHADOW;
    return surface(PLANET + band * SHADES * PARTS, shade(cosine), part);
}

static int32_t ring(vector p, int32_t radius, int32_t part)
{
    int32_t cosine = RING_BRIGHT + radius % GROOVES * RING_GROOVE;
    return surface(RING, shade(shadowed_by_planet(p) ? 0 : cosine), part);
}

/* Of a voxel's centre, along one axis. */
static int32_t from_centre(int32_t index)
{
    return (2 * index + 1 - SIZE) * VOXEL / 2;
}

static int32_t voxel(vector at)
{
    vector p = {from_centre(at.x), from_centre(at.y), from_centre(at.z)};
    int32_t radius = root(dot(p, p));
    int32_t part = filled(PLANET_RADIUS - radius);
    if (part > 0)
        return planet(p, radius, part);
    int32_t height = dot(p, axis) / ONE;
    part = filled(RING_HALF - (height < 0 ? -height : height));
    if (part > 0 && in_ring(root(dot(p, p) - height * height)))
        return ring(p, radius, part);
    return fog(at);
}

/* ---- The palette ------------------------------------------------------------ */

static void set(uint16_t entry[4], const uint8_t colour[3], int32_t bright, int32_t opacity)
{
    for (unsigned c = 0; c < 3; c++)
        entry[c] = (uint16_t)(colour[c] * 257 * bright / ONE);
    entry[3] = (uint16_t)opacity;
}

static void surface_entries(uint16_t entry[][4], const uint8_t colour[3])
{
    for (int32_t i = 0; i < SHADES * PARTS; i++) {
        int32_t bright = (i / PARTS + 1) * ONE / SHADES;
        set(entry[i], colour, bright, FULL * (i % PARTS + 1) / PARTS);
    }
}

void planet_make_palette(uint16_t entry[QV_PALETTE_ENTRIES][4])
{
    static const uint8_t black[3] = {0, 0, 0};
    for (int32_t i = 0; i < PLANET; i++)
        set(entry[i], black, ONE, 0);
    for (int32_t i = 0; i < FOG_HUES * FOG_DENSITIES; i++) {
        int32_t density = i % FOG_DENSITIES + 1; /* opacity by its square: wisps */
        set(entry[FOG + i], fog_colours[i / FOG_DENSITIES], ONE,
            density * density * FOG_OPACITY / (FOG_DENSITIES * FOG_DENSITIES));
    }
    for (int32_t band = 0; band < BANDS; band++)
        surface_entries(entry + PLANET + band * SHADES * PARTS, band_colours[band]);
    surface_entries(entry + RING, ring_colour);
}

void planet_make_voxels(uint8_t voxels[PLANET_SIZE][PLANET_SIZE][PLANET_SIZE])
{
    vector at;
    for (at.z = 0; at.z < SIZE; at.z++)
        for (at.y = 0; at.y < SIZE; at.y++)
            for (at.x = 0; at.x < SIZE; at.x++)
                voxels[at.z][at.y][at.x] = (uint8_t)voxel(at);
}
