-- Question: what does the agent know before it has met any object but a cube?
-- The pretraining set: two stations on each of the twelve planes of a 2U cube, each with its own resultant wrench as the
-- task. The stations are the middles of the symbols RwdL and FwdL, so a recalled symbol names the taught station exactly.
return preshape.scenario {
  title = "Pretraining on the cube",
  object = "cube",
  stations = { -0.25, 0.25 },
  pretrain = "none",
  memory = "default",
  seed = 1,
}
