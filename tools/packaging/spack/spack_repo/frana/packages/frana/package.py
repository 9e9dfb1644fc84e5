# The recipe builds from the checkout that it is in (docs/containers.md).
import os

from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *

_checkout = os.path.realpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), *[".."] * 7))


class Frana(CMakePackage):
    """Fracture of solids in a flow: bond-based peridynamics, direct numerical simulation of the
    incompressible Navier-Stokes equations, and an immersed-boundary method that couples them."""

    homepage = "file://" + os.path.join(_checkout, "README.md")
    git = "file://" + _checkout

    license("MIT")

    version("main", branch="main")
    version("1.0.0", tag="v1.0.0")

    variant("shared", default=False, description="Build a shared library for each part")
    variant("plots", default=True, description="Let frana post draw curves, by gnuplot")

    depends_on("c", type="build")
    depends_on("cmake@3.20:", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("git", type="build")  # the program's version names its commit

    depends_on("mpi@3:")
    depends_on("hdf5@1.10:+mpi")
    depends_on("fftw@3.3:")
    depends_on("openblas threads=none")  # has LAPACKE; frana's threads are its own
    depends_on("libyaml")
    depends_on("cairo@1.16: +fc+ft+pdf+png+svg")
    depends_on("libtiff@4.5:")
    depends_on("zlib-api")
    depends_on("cmocka@1.1:", type="test")
    depends_on("gnuplot+cairo", type="run", when="+plots")

    def cmake_args(self):
        return [
            # Spack's wrapper of the compiler sets -march to the target of the spec
            self.define("FRANA_ARCH", ""),
            self.define("BUILD_TESTING", self.run_tests),
            self.define_from_variant("BUILD_SHARED_LIBS", "shared"),
            self.define("HDF5_ROOT", self.spec["hdf5"].prefix),
            self.define("FFTW_ROOT", self.spec["fftw"].prefix),
            self.define("LAPACKE_ROOT", self.spec["openblas"].prefix),
        ]

    def check(self):
        with working_dir(self.build_directory):
            ctest("--output-on-failure", "-L", "smoke")

    @run_after("install")
    @on_package_attributes(run_tests=True)
    def check_install(self):
        frana = Executable(self.prefix.bin.frana)
        frana("check", join_path(self.prefix.share, "frana", "cases", "channel", "scene.yaml"))
