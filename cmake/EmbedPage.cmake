# mapwright_embed_page(FOLDER TEMPLATE OUTPUT): writes the files of the HTML report's page into a
# source file, so that the program needs none beside it, with the hashes by which the page's Content
# Security Policy lets its own script and style run and no other.

# The Content Security Policy's name for a text: 'sha256-' and the hash in base 64.
function(mapwright_policy_hash text result)
  set(alphabet "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
  string(SHA256 hexadecimal "${text}")
  string(APPEND hexadecimal "00")  # 32 bytes and one more are eleven groups of three
  set(base64 "")
  foreach(start RANGE 0 60 6)
    string(SUBSTRING ${hexadecimal} ${start} 6 group)
    foreach(shift 18 12 6 0)
      math(EXPR digit "(0x${group} >> ${shift}) & 63")
      string(SUBSTRING ${alphabet} ${digit} 1 character)
      string(APPEND base64 ${character})
    endforeach()
  endforeach()
  string(REGEX REPLACE ".$" "=" base64 ${base64})  # of the byte that was added
  set(${result} "'sha256-${base64}'" PARENT_SCOPE)
endfunction()

function(mapwright_embed_page folder template output)
  set(scripts dom palette view scene ground painter pins map_view input table inspector layers main)
  file(READ ${folder}/style.css MAPWRIGHT_PAGE_STYLE)
  file(READ ${folder}/theme.js MAPWRIGHT_PAGE_THEME)
  file(READ ${folder}/body.html MAPWRIGHT_PAGE_BODY)
  set(MAPWRIGHT_PAGE_SCRIPT "(() => {\n'use strict';\n")
  foreach(script IN LISTS scripts)
    file(READ ${folder}/${script}.js text)
    string(APPEND MAPWRIGHT_PAGE_SCRIPT "${text}")
  endforeach()
  string(APPEND MAPWRIGHT_PAGE_SCRIPT "})();\n")
  mapwright_policy_hash("${MAPWRIGHT_PAGE_STYLE}" MAPWRIGHT_PAGE_STYLE_HASH)
  mapwright_policy_hash("${MAPWRIGHT_PAGE_THEME}" MAPWRIGHT_PAGE_THEME_HASH)
  mapwright_policy_hash("${MAPWRIGHT_PAGE_SCRIPT}" MAPWRIGHT_PAGE_SCRIPT_HASH)
  configure_file(${template} ${output} @ONLY)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
endfunction()
