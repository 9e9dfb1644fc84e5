frana_test(coupling/test_medium_kernels.c ROOM coupling RANKS 1)
frana_test(coupling/test_medium.c ROOM coupling RANKS 1 2 3 4)
frana_test(coupling/test_medium_flow.c ROOM coupling RANKS 1 2 3 4)
