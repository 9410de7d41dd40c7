return {
  mesh = "cube.obj",
  unit = "U",
  frame = "file",
  summary = "Cube of side 2U, the pretraining object",
}
