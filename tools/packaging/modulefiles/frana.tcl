#%Module1.0
# Module of an installation of frana, for Environment Modules (and Lmod). cmake --install copies it to
# PREFIX/share/modulefiles/frana/VERSION. There it finds the installation from its own place, so that the tree may be
# moved; copied elsewhere, it takes what FRANA_PREFIX says.
proc ModulesHelp {} {
    puts stderr "frana computes how a solid breaks in a flow, on one core or many:
    frana check scene.yaml
    mpiexec -n 8 frana run scene.yaml --out runs/scene
Load the MPI with which it was built first. man frana; the documentation is in \$FRANA_ROOT/share/doc/frana."
}
module-whatis "fracture of solids in a flow, by peridynamics and direct simulation"

if {[info exists env(FRANA_PREFIX)]} {
    set prefix $env(FRANA_PREFIX)
} elseif {![regexp {^(.*)/share/modulefiles/frana/[^/]*$} $ModulesCurrentModulefile all prefix]} {
    puts stderr "frana: this module file is not in PREFIX/share/modulefiles/frana, and FRANA_PREFIX is not set"
    break
}
conflict frana
setenv FRANA_ROOT $prefix
prepend-path PATH $prefix/bin
prepend-path MANPATH $prefix/share/man
# ranks share the cores: threads of OpenBLAS would compete with them
setenv OPENBLAS_NUM_THREADS 1
