-- Module of an installation of frana, for Lmod. cmake --install copies it to
-- PREFIX/share/modulefiles/frana/VERSION.lua. There it finds the installation from its own place, so that the tree may be
-- moved; copied elsewhere, it takes what FRANA_PREFIX says.
help([[frana computes how a solid breaks in a flow, on one core or many:
    frana check scene.yaml
    mpiexec -n 8 frana run scene.yaml --out runs/scene
Load the MPI with which it was built first. man frana; the documentation is in $FRANA_ROOT/share/doc/frana.]])
whatis("Name: frana")
whatis("Version: " .. myModuleVersion())
whatis("Description: fracture of solids in a flow, by peridynamics and direct simulation")

local prefix = os.getenv("FRANA_PREFIX") or myFileName():match("^(.*)/share/modulefiles/frana/[^/]*$")
if not prefix then
    LmodError("frana: this module file is not in PREFIX/share/modulefiles/frana, and FRANA_PREFIX is not set")
end
conflict("frana")
setenv("FRANA_ROOT", prefix)
prepend_path("PATH", pathJoin(prefix, "bin"))
prepend_path("MANPATH", pathJoin(prefix, "share/man"))
-- ranks share the cores: threads of OpenBLAS would compete with them
setenv("OPENBLAS_NUM_THREADS", "1")
