/* Weights of moving least squares as functions of s = distance over radius; 0 from s = 1 on.  (002: sec. 2) */
#pragma once
#include "meshless/galerkin/galerkin.h"

/* Weight and its derivative with respect to s. */
void meshless_weight(enum galerkin_weight kind, double s, double *w, double *dw);
