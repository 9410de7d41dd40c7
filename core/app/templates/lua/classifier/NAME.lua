-- Question: which preshape does @NAME@ recall for a pivoting task on the cube that it was taught?
return preshape.scenario {
  title = "@NAME@ recalls a cube",
  object = "cube",
  task = "T1_2",
  classifier = "@NAME@",
  memory = ":memory:",
  seed = 1,
}
