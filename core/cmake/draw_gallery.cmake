# cmake -DCOMMAND=preshape -DSOURCE=tree -P draw_gallery.cmake: writes docs/gallery.md and the pictures that it shows.
set(page ${SOURCE}/docs/gallery.md)
execute_process(COMMAND ${COMMAND} run ${SOURCE}/scripts/studies/gallery.lua OUTPUT_FILE ${page}.part COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${page}.part ${page})
file(MAKE_DIRECTORY ${SOURCE}/docs/gallery)
file(STRINGS ${page} rows REGEX "gallery/[a-z_0-9]+\\.png")
foreach(row IN LISTS rows)
  string(REGEX MATCH "^\\| ([a-z_0-9]+) \\| ([^ ]+) \\| ([0-9.]+) " _ "${row}")
  set(object ${CMAKE_MATCH_1})
  set(task ${CMAKE_MATCH_2})
  # A hundredth below what the page says, which is rounded: nothing but the best serves.
  string(REPLACE "." "" hundredths ${CMAKE_MATCH_3})
  math(EXPR hundredths "${hundredths} - 1")
  string(REGEX REPLACE "(..)$" ".\\1" threshold ${hundredths})
  message(STATUS "${object}, ${task}, ${threshold}")
  execute_process(COMMAND ${COMMAND} run ${SOURCE}/scripts/scenarios/demo.lua --quiet --memory :memory:
    --set object=${object} --set task=${task} --set thresholds.estimation=${threshold} --set learning.policy=learn
    --set explorer=exhaustive --set simulator=kinematic
    --picture ${SOURCE}/docs/gallery/${object}.png --picture-size 1200x500 --picture-palette
    RESULT_VARIABLE code OUTPUT_VARIABLE report)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${object} was not drawn with its best preshape (exit code ${code}):\n${report}")
  endif()
endforeach()
