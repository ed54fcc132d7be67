# mapwright_embed_check_pages(TEMPLATE OUTPUT): writes every page docs/checks/CODE.md into a source
# file, so that `mapwright validate --explain CODE` needs no files beside the program.
function(mapwright_embed_check_pages template output)
  file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/checks/[A-Z][0-9]*.md)
  set(MAPWRIGHT_CHECK_PAGES "")
  foreach(page IN LISTS pages)
    get_filename_component(id ${page} NAME_WE)
    file(READ ${page} text)
    string(APPEND MAPWRIGHT_CHECK_PAGES "    {\"${id}\", R\"page(${text})page\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page})
  endforeach()
  configure_file(${template} ${output} @ONLY)
endfunction()
