add_compile_options(-Wall -Wextra -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla -Wpointer-arith
  -Wswitch-enum -Werror=switch -Werror=switch-enum # a kind that a switch forgets does not compile
  -fno-math-errno -fno-trapping-math -ffp-contract=fast)
if(FRANA_ARCH)
  add_compile_options(-march=${FRANA_ARCH})
endif()
set(CMAKE_C_FLAGS_RELEASE "-O3")
set(CMAKE_C_FLAGS_DEBUG "-O1 ${FRANA_DEBUG_INFO} -DFRANA_DEBUG")
if(FRANA_WERROR)
  add_compile_options(-Werror)
endif()
if(FRANA_SANITIZE)
  # An address that overflows, is null or is beyond its object is found by ASan when it is used; to look for it earlier
  # makes clang take five times as long for unrolled kernels.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=pointer-overflow,null,object-size
    -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options(-Wno-psabi)
endif()
if(FRANA_MPI STREQUAL mpich AND CMAKE_C_COMPILER_ID STREQUAL GNU)
  add_compile_options(-Wno-stringop-overflow) # MPICH's MPI_STATUSES_IGNORE is the address 1
endif()
add_compile_definitions(_GNU_SOURCE)
