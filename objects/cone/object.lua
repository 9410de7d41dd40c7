return {
  mesh = "cone.obj",
  unit = "U",
  frame = "file",
  summary = "Upright cone, base radius 1.3U, height 3U",
}
