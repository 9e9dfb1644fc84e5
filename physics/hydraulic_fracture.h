/* Similarity solutions of a crack that a fluid drives through an elastic solid without leak-off and without confining
 * stress, injected at a constant rate. They are the ends of a range: of all work done on the crack, the solid's
 * toughness takes nearly all (toughness regime), or the fluid's viscosity does (viscosity regime).
 *
 * With E' = E/(1 - nu^2), K' = 4 sqrt(2/pi) K_IC and mu' = 12 mu.  (Detournay 2004; Savitski and Detournay 2002) */
#pragma once

/* The two wings of a straight crack in plane strain (Khristianovic, Geertsma and de Klerk: KGD), injected at the middle
 * of its length 2 l; a circular crack in space (penny), injected at its centre. */
enum physics_hydraulic_shape { PHYSICS_KGD, PHYSICS_PENNY };
enum physics_hydraulic_regime { PHYSICS_TOUGHNESS, PHYSICS_VISCOSITY };

struct physics_hydraulic_fracture {
    enum physics_hydraulic_shape shape;
    double modulus;   /* E', Pa (physics_crack_tip_modulus) */
    double toughness; /* K_IC, Pa m^1/2: not used in the viscosity regime */
    double viscosity; /* mu, Pa s: not used in the toughness regime */
    double rate;      /* Q0 into the whole crack: m3/s; KGD m2/s, per thickness of the plate */
};

struct physics_hydraulic_state {
    double length;        /* l: half the length of a KGD crack, the radius of a penny, m */
    double opening;       /* at the well, m */
    double pressure_well; /* net, at the well, Pa; INFINITY of a penny in the viscosity regime: it rises as -ln r */
    double pressure_half; /* net, at the distance l/2 from the well, Pa; in the toughness regime it is uniform */
};

/* At t s after the begin of injection, t > 0. The numbers of the toughness regime follow from Sneddon's crack
 * (tests/physics/pressurised_crack.h) at K_I = K_IC and the volume Q0 t. Those of the viscosity regime were computed
 * for frana (docs/sources.md). */
struct physics_hydraulic_state physics_hydraulic_fracture_at(const struct physics_hydraulic_fracture *in,
                                                             enum physics_hydraulic_regime regime, double t);

/* The dimensionless toughness, which tells the regime:
 *     KGD    K'/(mu' E'^3 Q0)^(1/4)                     the same at all times
 *     penny  K' (t^2/(mu'^5 Q0^3 E'^13))^(1/18)         from viscosity to toughness as time passes
 * Viscosity rules below about 1, toughness above about 4 (KGD) and 3.5 (penny).  (Detournay 2004; Savitski and
 * Detournay 2002) */
double physics_hydraulic_fracture_number(const struct physics_hydraulic_fracture *in, double t);
/* The time at which that number is 1, s: sqrt(mu'^5 E'^13 Q0^3/K'^18) of a penny. INFINITY of a KGD crack, whose number
 * does not change. */
double physics_hydraulic_fracture_transition(const struct physics_hydraulic_fracture *in);
/* The time at which a crack has that length, s, and the speed of its tip at a time, m/s. */
double physics_hydraulic_fracture_reached(const struct physics_hydraulic_fracture *in,
                                          enum physics_hydraulic_regime regime, double length);
double physics_hydraulic_fracture_speed(const struct physics_hydraulic_fracture *in,
                                        enum physics_hydraulic_regime regime, double t);
/* The lag between the fluid's front and a tip that runs at a speed V through a solid without toughness under the
 * confining stress sigma0: 0.3598 mu' V E'^2/sigma0^3, m. With toughness the lag is shorter.  (Garagash and Detournay
 * 2000) */
double physics_hydraulic_fracture_lag(const struct physics_hydraulic_fracture *in, double speed, double stress);
