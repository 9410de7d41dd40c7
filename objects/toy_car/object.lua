return {
  mesh = "toy_car.obj",
  unit = "U",
  frame = "file",
  summary = "Toy car with four wheels, bonnet towards +X, roof towards +Y",
}
