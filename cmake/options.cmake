# How everything of ours is compiled: the target fos_options.
option(FOS_WERROR "Treat warnings as errors (our CI does; a student's compiler may be newer)" OFF)
option(FOS_SANITIZE "Address and undefined-behaviour sanitizers" OFF)
option(FOS_FUZZ "The fuzzer of the scene reader (clang++ only)" OFF)

add_library(fos_options INTERFACE)
target_compile_features(fos_options INTERFACE cxx_std_20)
target_compile_options(fos_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)  # labs/… in messages, wherever the tree lies
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 sees an overlap in every `"text" + string` (its bug 105651).
  target_compile_options(fos_options INTERFACE -Wno-restrict)
endif()
if(FOS_WERROR)
  target_compile_options(fos_options INTERFACE -Werror)
endif()
if(FOS_SANITIZE)
  target_compile_options(fos_options INTERFACE -fsanitize=address,undefined
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(fos_options INTERFACE -fsanitize=address,undefined)
endif()
if(FOS_FUZZ)
  target_compile_options(fos_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined
    -fno-sanitize-recover=all)
  target_link_options(fos_options INTERFACE -fsanitize=address,undefined)
endif()

# What differs for a stage: a parameter that it does not use yet is no mistake, N in `ambient`, all of
# them in a stub; and a function that ends without its return is one, for it would run on into the next.
add_library(fos_stage_options INTERFACE)
target_compile_options(fos_stage_options INTERFACE -Wno-unused-parameter -Werror=return-type)
