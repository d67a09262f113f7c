# cmake -DFRAME=… -DSTYLE=… -DSCRIPTS=…;… -DOUTPUT=… -P embed_page.cmake: the files as string literals in a C++ source.
function(literal variable)
  set(text)
  foreach(file IN LISTS ARGN)
    file(READ ${file} part)
    string(APPEND text "${part}")
  endforeach()
  string(FIND "${text}" ")page\"" end)
  if(NOT end EQUAL -1)
    message(FATAL_ERROR "what ends a literal stands in one of ${ARGN}")
  endif()
  set(${variable} "R\"page(${text})page\"" PARENT_SCOPE)
endfunction()

literal(frame ${FRAME})
literal(style ${STYLE})
literal(script ${SCRIPTS})
file(WRITE ${OUTPUT} "#include \"report/page.hpp\"\n\nnamespace alignability::detail {\n\n"
  "const std::string_view kPageFrame = ${frame};\n"
  "const std::string_view kPageStyle = ${style};\n"
  "const std::string_view kPageScript = ${script};\n\n"
  "}  // namespace alignability::detail\n")
