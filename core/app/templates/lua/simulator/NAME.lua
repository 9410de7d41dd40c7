-- Question: is @NAME@ among the simulators that this preshape finds, and what does it promise?
local found
for _, component in ipairs(preshape.components("simulator")) do
  if component.name == "@NAME@" then
    found = component
  end
end
assert(found, "@NAME@ is not found; is @NAME@.plugin.lua beside this script?")
print(found.summary)
return { simulator = found.name, capabilities = found.capabilities }
