# Reads labs/stages.json, THE list of lectures and stages. Sets
#   FOS_STAGES                      the stages up to FOS_LECTURE, in order
#   FOS_STAGE_<id>_{LECTURE,FILE}
#   FOS_REFERENCE_SCENES            the scenes of all of them, each once
#   FOS_SHARES                      how grading shares a stage's points out, in percent: checks, scenes
#                                   that nobody has published, relations
# and writes what C++ (fos/stages.inc) and bash (stages.sh) need of it.

set(_file "${CMAKE_SOURCE_DIR}/labs/stages.json")
set_property(DIRECTORY "${CMAKE_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${_file}")
file(READ "${_file}" _json)

# The elements of an array as a list.
function(fos_json_array out)
  set(_list "")
  string(JSON _count LENGTH "${_json}" ${ARGN})
  if(_count GREATER 0)
    math(EXPR _last "${_count} - 1")
    foreach(_i RANGE ${_last})
      string(JSON _element GET "${_json}" ${ARGN} ${_i})
      list(APPEND _list "${_element}")
    endforeach()
  endif()
  set(${out} "${_list}" PARENT_SCOPE)
endfunction()

set(FOS_SHARES "")
set(_sum 0)
foreach(_part IN ITEMS checks scenes relations)
  string(JSON _share GET "${_json}" shares ${_part})
  list(APPEND FOS_SHARES ${_share})
  math(EXPR _sum "${_sum} + ${_share}")
endforeach()
if(NOT _sum EQUAL 100)
  message(FATAL_ERROR "labs/stages.json: the shares are ${_sum} percent together, not 100")
endif()

set(FOS_LECTURES "")
string(JSON _count LENGTH "${_json}" lectures)
math(EXPR _last "${_count} - 1")
foreach(_i RANGE ${_last})
  string(JSON _number GET "${_json}" lectures ${_i} number)
  list(APPEND FOS_LECTURES ${_number})
endforeach()

set(FOS_LECTURE "" CACHE STRING "build the stages up to this lecture; empty: all of them")
string(REGEX REPLACE "^0+" "" _lecture "${FOS_LECTURE}")  # 03 is 3
if(_lecture STREQUAL "")
  list(GET FOS_LECTURES -1 _lecture)
endif()
if(NOT _lecture IN_LIST FOS_LECTURES)
  message(FATAL_ERROR "FOS_LECTURE is ${FOS_LECTURE}; labs/stages.json has: ${FOS_LECTURES}")
endif()

set(FOS_STAGES "")
set(FOS_REFERENCE_SCENES "")
set(_cpp "")
set(_rows "")
set(_bash_lectures "")
set(_bash_files "")
set(_bash_terms "")
string(JSON _count LENGTH "${_json}" stages)
math(EXPR _last "${_count} - 1")
foreach(_i RANGE ${_last})
  string(JSON _id GET "${_json}" stages ${_i} id)
  string(JSON _number GET "${_json}" stages ${_i} lecture)
  string(JSON _en GET "${_json}" stages ${_i} name en)
  string(JSON _el GET "${_json}" stages ${_i} name el)
  string(JSON _points GET "${_json}" stages ${_i} points)
  fos_json_array(_terms stages ${_i} terms)
  fos_json_array(_scenes stages ${_i} scenes)
  if(_number GREATER _lecture)
    continue()
  endif()
  if(NOT _id MATCHES "^[a-z][a-z_0-9]*$" OR NOT _scenes)
    message(FATAL_ERROR "labs/stages.json: stage '${_id}' needs a lower-case id and scenes")
  endif()

  set(_folder "${_number}")
  if(_number LESS 10)
    set(_folder "0${_number}")
  endif()
  list(APPEND FOS_STAGES ${_id})
  set(FOS_STAGE_${_id}_LECTURE ${_number})
  set(FOS_STAGE_${_id}_FILE "lecture${_folder}/${_id}.cpp")
  list(APPEND FOS_REFERENCE_SCENES ${_scenes})

  list(TRANSFORM _terms REPLACE "^(.).*" "\\1" OUTPUT_VARIABLE _letters)
  list(JOIN _letters "" _letters)
  if(NOT _letters)
    set(_letters 1)
  endif()
  list(TRANSFORM _terms REPLACE "(.+)" "\\1_term")
  list(JOIN _terms " | " _bits)
  if(NOT _bits)
    set(_bits 0)
  endif()
  list(TRANSFORM _scenes REPLACE "(.+)" "\"\\1\"")
  list(JOIN _scenes ", " _scenes)
  string(APPEND _cpp "inline constexpr std::string_view scenes_of_${_id}[] = {${_scenes}};\n")
  string(APPEND _rows "    {\"${_id}\", ${_number}, {\"${_en}\", \"${_el}\"}, ${_bits}, "
                      "${_points}, scenes_of_${_id}},\n")
  string(APPEND _bash_lectures " [${_id}]=${_number}")
  string(APPEND _bash_files " [${_id}]=${FOS_STAGE_${_id}_FILE}")
  string(APPEND _bash_terms " [${_id}]=${_letters}")
endforeach()
list(REMOVE_DUPLICATES FOS_REFERENCE_SCENES)

file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/generated/fos/stages.inc" @ONLY CONTENT
"// Made from labs/stages.json.
namespace fos {
@_cpp@inline constexpr Stage stages[] = {
@_rows@};
}  // namespace fos
")
list(JOIN FOS_STAGES " " _bash_stages)
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/stages.sh" @ONLY CONTENT
"# Made from labs/stages.json.
FOS_STAGES=(@_bash_stages@)
declare -A FOS_STAGE_LECTURE=(@_bash_lectures@ )
declare -A FOS_STAGE_FILE=(@_bash_files@ )
declare -A FOS_STAGE_TERMS=(@_bash_terms@ ) # some of a, p, d; or 1
")
