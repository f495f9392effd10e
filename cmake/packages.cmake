# The libraries behind everything, from the distribution's packages (docs/en/dependencies.md).
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(pegtl REQUIRED PATHS /usr/share/pegtl/cmake)
include(${CMAKE_CURRENT_LIST_DIR}/openimageio.cmake)
