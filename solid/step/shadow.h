/* The energy that short waves hold beyond what velocity Verlet's sums have, found from the present state alone.
 *
 * In a substep dt a linear mode of frequency omega keeps the sum K + U - dt^2/8 sum of m a^2, which e_integrator makes.
 * What a body whose bonds are not linear keeps, is the energy of the scheme's modified equation (Hairer et al. 2003).
 * In a mode this is larger than the sum, by a constant factor that rises with omega:
 *
 *     f(x) = asin(x)/(x sqrt(1 - x^2)) = 1 + 2/3 x^2 + ... ,    x = omega dt/2
 *
 * So where energy goes from long waves to short ones, the sum falls by what this function rises. With H for the second
 * derivative of the potential over the mass, at the present displacements, it is
 *
 *     sum of m/2 v.(f(X) - 1) v + m/2 a.(((1 - X) f(X) - 1)/H + dt^2/4) a ,    X = dt^2/4 H
 *                                                           = dt^2/12 (v.U''v + sum of m a^2) + ... */
#pragma once
struct solid;

/* J, of the whole solid. a: by bonds, loads and body forces. f(H) by two steps of Lanczos's iteration from v and one
 * from a; takes five sweeps, which leave no trace. Collective. */
double solid_shadow_waves(struct solid *s, double dt);
