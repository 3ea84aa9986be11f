# Compiler and linker habits shared by every target.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

find_program(MOLD_PROGRAM mold)
find_program(LLD_PROGRAM ld.lld)
if(MOLD_PROGRAM)
    add_link_options(-fuse-ld=mold)
elseif(LLD_PROGRAM)
    add_link_options(-fuse-ld=lld)
endif()
# g++ drops --as-needed under -fsanitize and clang++ never passes it; without it Qt 5 can enter through VTK or OpenCV.
add_link_options(-Wl,--as-needed)

# Release keeps -O2: the engine's own assertions (base/assert.h) do not depend on NDEBUG.
# No fused multiply-add: the same seed gives the same bytes on any x86-64.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
add_compile_options(-Wall -Wextra -Wno-unused-parameter -ffp-contract=off)
add_compile_definitions(QT_NO_CAST_FROM_BYTEARRAY QT_NO_FOREACH)
