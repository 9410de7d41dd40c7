-- Question: what does each similarity measure mean by "serves", and do the stations that it likes best serve the task by
-- TFVADI, the thesis's measure?
--
-- Takes every grasp of every shipped object at the workspace's stations, scores it with every measure before the 24 sample
-- tasks, and before the wrenches of the cube's grasps as a memory holds them, and prints Markdown. Run:
--
--     preshape run scripts/studies/similarities.lua > docs/similarities.md

local ESTIMATION, RECOGNITION = 3.0, 5.5 -- the thesis's thresholds, on TFVADI's scale
local STEP = 0.25

local objects, tasks, wrenches = preshape.objects(), {}, {}
for _, task in ipairs(preshape.tasks()) do tasks[#tasks + 1] = task.name end
for _, row in ipairs(preshape.workspace({ object = "cube", task = "T1_1", memory = ":memory:" }, STEP)) do
  if math.abs(row.approach) == STEP then wrenches[#wrenches + 1] = row.wrench end
end

--- A number in the measure's range: nothing is decided here, but thresholds are checked.
local function any_threshold(measure)
  return measure == "turksen_zhong" and 4.5 or 0.5
end

--- The scores of all grasps before some tasks, in one order for every measure; groups[i] is the object and task of score i.
local function scores_of(measure, before)
  local scores, groups = {}, {}
  for o, object in ipairs(objects) do
    for t, task in ipairs(before) do
      local rows = preshape.workspace({
        object = object,
        task = task,
        similarity = measure,
        tie_break = measure,
        thresholds = { estimation = any_threshold(measure), recognition = any_threshold(measure) },
        memory = ":memory:",
      }, STEP)
      for _, row in ipairs(rows) do
        scores[#scores + 1] = row.first
        groups[#groups + 1] = (o - 1) * #before + t
      end
    end
  end
  return scores, groups
end

local function share(scores, threshold)
  local count = 0
  for _, score in ipairs(scores) do
    if score >= threshold then count = count + 1 end
  end
  return count / #scores
end

--- The score that this share of all scores reaches.
local function quantile(scores, share_of_all)
  local sorted = table.move(scores, 1, #scores, 1, {})
  table.sort(sorted, function(a, b) return a > b end)
  return sorted[math.max(1, math.floor(share_of_all * #sorted + 0.5))]
end

--- Ranks, ties sharing their mean.
local function ranks(scores)
  local order = {}
  for i = 1, #scores do order[i] = i end
  table.sort(order, function(a, b)
    if scores[a] ~= scores[b] then return scores[a] < scores[b] end
    return a < b
  end)
  local rank, i = {}, 1
  while i <= #order do
    local k = i
    while k < #order and scores[order[k + 1]] == scores[order[i]] do k = k + 1 end
    for n = i, k do rank[order[n]] = (i + k) / 2 end
    i = k + 1
  end
  return rank
end

local function correlation(x, y)
  local n, sx, sy = #x, 0, 0
  for i = 1, n do sx, sy = sx + x[i], sy + y[i] end
  local mx, my, xy, xx, yy = sx / n, sy / n, 0, 0, 0
  for i = 1, n do
    local a, b = x[i] - mx, y[i] - my
    xy, xx, yy = xy + a * b, xx + a * a, yy + b * b
  end
  return xx > 0 and yy > 0 and xy / math.sqrt(xx * yy) or 0
end

--- Of the objects and tasks that some grasp serves by TFVADI, the share whose best grasp by these scores does.
local function agreement(scores, reference, groups)
  local best, servable = {}, {}
  for i, group in ipairs(groups) do
    if reference[i] >= ESTIMATION then servable[group] = true end
    if not best[group] or scores[i] > scores[best[group]] then best[group] = i end
  end
  local all, agreed = 0, 0
  for group in pairs(servable) do
    all = all + 1
    if reference[best[group]] >= ESTIMATION then agreed = agreed + 1 end
  end
  return agreed / all
end

local reference, groups = scores_of("tfvadi", tasks)
local recalled = scores_of("tfvadi", wrenches)
local reference_ranks = ranks(reference)
local served, known = share(reference, ESTIMATION), share(recalled, RECOGNITION)

print("# Similarity measures compared")
print()
print(string.format("Made by `preshape run scripts/studies/similarities.lua`: the grasps of %d objects at steps of %g of the half extent,",
  #objects, STEP))
print(string.format("%d pairs with the 24 sample tasks and %d with the wrenches that pretraining on the cube teaches.", #reference, #recalled))
print(string.format("By TFVADI %.1f %% of the pairs with tasks reach %.1f, and %.1f %% of those with wrenches reach %.1f. *Estimation* and",
  100 * served, ESTIMATION, 100 * known, RECOGNITION))
print("*recognition* are the scores that as many pairs reach by each measure: thresholds that mean the same on its scale.")
print("*Rank correlation* is Spearman's with TFVADI over all pairs with tasks. *Its best serves*: of the objects and tasks that")
print("some grasp serves by TFVADI, the share in which the grasp that the measure likes best does.")
print()
print("| measure | estimation | recognition | rank correlation | its best serves |")
print("|---|---|---|---|---|")
local results = {}
for _, component in ipairs(preshape.components("similarity")) do
  local name = component.name
  local scores, patterns = scores_of(name, tasks), scores_of(name, wrenches)
  -- A measure whose scores fall where TFVADI's rise is one of distance.
  local rho = correlation(ranks(scores), reference_ranks)
  local sign = rho < 0 and -1 or 1
  for i = 1, #scores do scores[i] = sign * scores[i] end
  for i = 1, #patterns do patterns[i] = sign * patterns[i] end
  local row = {
    measure = name,
    higher_is_nearer = sign > 0,
    estimation = sign * quantile(scores, served),
    recognition = sign * quantile(patterns, known),
    rank_correlation = sign * rho,
    agreement = agreement(scores, reference, groups),
  }
  results[#results + 1] = row
  print(string.format("| %s%s | %.3f | %.3f | %.2f | %.0f %% |", name, row.higher_is_nearer and "" or " (lower is nearer)",
    row.estimation, row.recognition, row.rank_correlation, 100 * row.agreement))
end
return results
