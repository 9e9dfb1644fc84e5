// The permeability of an image of voxels by Palabos (lattice Boltzmann, D3Q19, multiple relaxation times, bounce-back),
// for a comparison. All sides are periodic.
// usage: palabos NX NY NZ IMAGE.raw AXIS N CHANGE    N: lattice nodes a voxel; it ends when k changes by less than
// CHANGE within a hundred steps. Prints k in squares of a voxel, steps and seconds. In the image 0 is pore.
#include "palabos3D.h"
#include "palabos3D.hh"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <vector>

using namespace plb;
typedef double T;
#define DESCRIPTOR descriptors::ForcedMRTD3Q19Descriptor

static std::vector<char> image;
static plint size[3], finer;

struct IsSolid : public DomainFunctional3D {
    bool operator()(plint x, plint y, plint z) const {
        const plint at[3] = {x, y, z};
        plint i[3];
        for (int c = 0; c < 3; c++) i[c] = ((at[c] % (finer * size[c]) + finer * size[c]) % (finer * size[c])) / finer;
        return image[(i[2] * size[1] + i[1]) * size[0] + i[0]] != 0;
    }
    IsSolid *clone() const { return new IsSolid(*this); }
};

int main(int argc, char **argv) {
    plbInit(&argc, &argv);
    for (int c = 0; c < 3; c++) size[c] = atoi(argv[1 + c]);
    const int axis = atoi(argv[5]);
    finer = atoi(argv[6]);
    const T change = atof(argv[7]), force = 1e-6, omega = 1, viscosity = (1 / omega - 0.5) / 3;
    image.resize(size[0] * size[1] * size[2]);
    std::ifstream(argv[4], std::ios::binary).read(&image[0], image.size());
    const plint n[3] = {finer * size[0], finer * size[1], finer * size[2]};
    MultiBlockLattice3D<T, DESCRIPTOR> lattice(n[0], n[1], n[2],
                                               new GuoExternalForceMRTdynamics<T, DESCRIPTOR>(omega));
    lattice.toggleInternalStatistics(false);
    lattice.periodicity().toggleAll(true);
    defineDynamics(lattice, lattice.getBoundingBox(), new IsSolid, new BounceBack<T, DESCRIPTOR>(1));
    initializeAtEquilibrium(lattice, lattice.getBoundingBox(), (T)1, Array<T, 3>((T)0, (T)0, (T)0));
    Array<T, DESCRIPTOR<T>::d> f((T)0, (T)0, (T)0);
    f[axis] = force;
    setExternalVector(lattice, lattice.getBoundingBox(), DESCRIPTOR<T>::ExternalField::forceBeginsAt, f);
    lattice.initialize();
    global::timer("all").start();
    T k = 0, before = 1;
    long steps = 0;
    while (steps < 200000 && !(std::fabs(k - before) < change * std::fabs(k))) {
        for (int s = 0; s < 100; s++, steps++) lattice.collideAndStream();
        before = k;
        std::unique_ptr<MultiScalarField3D<T> > u(computeVelocityComponent(lattice, lattice.getBoundingBox(), axis));
        k = computeAverage(*u, lattice.getBoundingBox()) * viscosity / force / (finer * finer);
    }
    pcout << "k " << k << " voxel2, " << steps << " steps, " << global::timer("all").getTime() << " s" << std::endl;
}
