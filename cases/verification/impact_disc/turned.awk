# The sites of the small disc, turned by ANGLE degrees about its axis: awk -v angle=ANGLE -f turned.awk
BEGIN {
  h = 5e-4; a = angle * atan2(0, -1) / 180
  for (k = 0; k <= 5; k++)
    for (i = -24; i <= 24; i++)
      for (j = -24; j <= 24; j++)
        if (i * i + j * j <= 576)
          printf "%.12g %.12g %.12g %.12g\n", 0.015 + h * (i * cos(a) - j * sin(a)),
            0.015 + h * (i * sin(a) + j * cos(a)), 0.0125 + h * k, h * h * h
}
