return {
  mesh = "sphere.obj",
  unit = "U",
  frame = "file",
  summary = "Ball of diameter 2.4U",
}
