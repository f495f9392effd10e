# fos_add_stage(ID): the programs lab_ID and, where it is there, solution_ID, each from one file; and
# the same at the other precisions, lab_ID_float and so on, which are built when asked for.
#
# A file that comes or goes later, say solutions that are unpacked after the labs, is noticed.
file(GLOB _ CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/labs/*/*.cpp" "${CMAKE_SOURCE_DIR}/solutions/*/*.cpp")
function(fos_add_stage id)
  foreach(kind IN ITEMS lab solution)
    set(source "${CMAKE_SOURCE_DIR}/${kind}s/${FOS_STAGE_${id}_FILE}")
    if(EXISTS "${source}")
      foreach(precision IN LISTS FOS_PRECISIONS)
        fos_add_stage_program(${kind}_${id} "${source}" ${precision})
      endforeach()
    endif()
  endforeach()
endfunction()

# A stage program from one source file that defines trace_ray.
function(fos_add_stage_program name source precision)
  fos_suffix(suffix ${precision})
  set(target ${name}${suffix})
  add_executable(${target} "${source}" $<TARGET_OBJECTS:fos_stage_main${suffix}>)
  target_link_libraries(${target} PRIVATE fos_options fos_stage_options fos_common${suffix})
  target_precompile_headers(${target} REUSE_FROM fos_stage_main${suffix})
  if(NOT precision STREQUAL "double")
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
endfunction()
