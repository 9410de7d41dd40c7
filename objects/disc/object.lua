return {
  mesh = "disc.obj",
  unit = "U",
  frame = "file",
  summary = "Flat disc facing Z, radius 2U, thickness 0.5U",
}
