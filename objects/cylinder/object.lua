return {
  mesh = "cylinder.obj",
  unit = "U",
  frame = "file",
  summary = "Upright cylinder, radius 1U, height 4U",
}
