return {
  mesh = "torus.obj",
  unit = "U",
  frame = "file",
  summary = "Lying torus, major radius 1.5U, minor radius 0.5U",
}
