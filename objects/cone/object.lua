return {
  mesh = "cone.obj",
  unit = "U",
  frame = "file",
  summary = "Upright cone, base radius 1.1U, height 3.6U",
}
