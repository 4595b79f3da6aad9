// Draws a ball and prints it, at 115200 baud.
#include <Arduino.h>
#include <qvol.h>
#include "ball.h"

static void show(const char *line)
{
    Serial.println(line);
}

void setup()
{
    Serial.begin(115200);
    if (ball_draw(show) != QV_OK)
        Serial.println("qvol failed");
    Serial.flush();
}

void loop()
{
}
