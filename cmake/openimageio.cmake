# OpenImageIO, with two of Debian 12's wrinkles ironed out.
set(_level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)  # Imath prints an alarming paragraph about Python
find_package(OpenImageIO REQUIRED)
set(CMAKE_MESSAGE_LOG_LEVEL "${_level}")

# Its config names OpenCV's include folder, which its package does not bring.
foreach(_target OpenImageIO::OpenImageIO OpenImageIO::OpenImageIO_Util)
  foreach(_property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
    get_target_property(_folders ${_target} ${_property})
    if(_folders)
      set(_there "")
      foreach(_folder IN LISTS _folders)
        if(_folder MATCHES "^\\$<" OR EXISTS "${_folder}")
          list(APPEND _there "${_folder}")
        endif()
      endforeach()
      set_target_properties(${_target} PROPERTIES ${_property} "${_there}")
    endif()
  endforeach()
endforeach()
