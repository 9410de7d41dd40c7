-- Question: how much more of the task space is served when the search may go beyond the thesis's twelve planes, rules and
-- middles, and what does it cost?
--
-- The best grasp of every shipped object for the 24 sample tasks, searched in several ways; prints Markdown. Run:
--
--     preshape run scripts/studies/explorers.lua > docs/explorers.md

local THRESHOLD = 3.0

local free = { virtual_fingers = "any" }
local free_and_aside = { virtual_fingers = "any", transverse_offsets = { 0, -0.5, 0.5 } }
local sampled = { directions = 60, rolls = 8 }

--- The second explorer is asked when the first finds nothing that serves: with a budget of one station it adds nothing.
local alone = { "beam", budget = 1 }

local searches = {
  { "`beam`, the default", { proof = alone } },
  { "`hill_climb`", { explorer = "hill_climb", proof = alone } },
  { "`exhaustive`", { explorer = "exhaustive", proof = alone } },
  { "`exhaustive`, any finger count", { explorer = "exhaustive", proof = alone, analysis = free } },
  { "`exhaustive`, any finger count, offsets -0.5, 0, 0.5", { explorer = "exhaustive", proof = alone, analysis = free_and_aside } },
  { "`beam`, 480 sampled planes, budget 2000", { explorer = { "beam", budget = 2000 }, proof = alone, planes = sampled } },
  { "`exhaustive`, 480 sampled planes", { explorer = { "exhaustive", budget = 200000 }, proof = alone, planes = sampled } },
}

print("# Searches compared")
print()
print("Made by `preshape run scripts/studies/explorers.lua > docs/explorers.md`: the best grasp of every shipped object for the 24")
print(string.format("sample tasks. *Stations*: evaluated for one task; *TFVADI*: of the best grasp, mean; *served*: at least %.1f. The sampled", THRESHOLD))
print(string.format("planes are %d directions with %d rolls each, behind the thesis's twelve.", sampled.directions, sampled.rolls))
print()
print("| search | stations | TFVADI | served |")
print("|---|---|---|---|")
local results = {}
for _, search in ipairs(searches) do
  local count, served, sum, stations = 0, 0, 0, 0
  for _, object in ipairs(preshape.objects()) do
    for _, task in ipairs(preshape.tasks()) do
      local scenario = { object = object, task = task.name, memory = ":memory:" }
      for key, value in pairs(search[2]) do scenario[key] = value end
      local best = preshape.best(scenario)
      count = count + 1
      if best then
        sum, stations = sum + best.first, stations + best.evaluations
        served = served + (best.first >= THRESHOLD and 1 or 0)
      end
    end
  end
  results[#results + 1] = { search = search[1], stations = stations / count, tfvadi = sum / count, served = served / count }
  print(string.format("| %s | %.0f | %.2f | %.0f %% |", search[1], stations / count, sum / count, 100 * served / count))
end
return results
