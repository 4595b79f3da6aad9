/*
 * Adafruit_GFX.h - what port/display/adafruit_gfx.cpp needs of Adafruit GFX.
 */
#ifndef ADAFRUIT_GFX_H
#define ADAFRUIT_GFX_H

#include <stdint.h>

class Adafruit_GFX
{
  public:
    Adafruit_GFX(uint16_t *panel, int16_t width, int16_t height)
        : panel_(panel), width_(width), height_(height)
    {
    }
    int16_t width() const
    {
        return width_;
    }
    int16_t height() const
    {
        return height_;
    }
    void drawRGBBitmap(int16_t x, int16_t y, uint16_t *bitmap, int16_t w, int16_t h)
    {
        for (int16_t row = 0; row < h; row++)
            for (int16_t column = 0; column < w; column++)
                panel_[(y + row) * width_ + x + column] = bitmap[row * w + column];
    }

  private:
    uint16_t *panel_;
    int16_t width_, height_;
};

#endif /* ADAFRUIT_GFX_H */
