/*
 * ball.h - the example of every package: a picture of a ball, in text.
 */
#ifndef BALL_H
#define BALL_H

#ifdef __cplusplus
extern "C" {
#endif

/* Draws the ball and shows its picture line by line. Returns 0, or what failed as a negative
   number (a qv_status of qvol.h). */
int ball_draw(void (*show)(const char *line));

#ifdef __cplusplus
}
#endif

#endif /* BALL_H */
