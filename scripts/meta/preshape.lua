---@meta
-- The module `preshape` and scenarios, for the Lua language server. Written by `preshape lua-meta`; do not edit.

---@alias preshape.Kind "contact"|"similarity"|"classifier"|"collision"|"hand"|"quality"|"explorer"|"simulator"
---@alias preshape.ObjectName "bottle"|"box"|"cone"|"cube"|"cylinder"|"disc"|"dolphin"|"hammer"|"mug"|"sphere"|"torus"|"toy_car"|"toy_plane"
---@alias preshape.HandName "allegro"|"barrett"|"leap"|"shadow"|"utah_mit"
---@alias preshape.TaskName "T1_1"|"T1_1+-"|"T1_1-+"|"T1_1--"|"T1_2"|"T1_2+-"|"T1_2-+"|"T1_2--"|"T1_3"|"T1_3+-"|"T1_3-+"|"T1_3--"|"T1_4"|"T1_4+-"|"T1_4-+"|"T1_4--"|"T1_5"|"T1_5+-"|"T1_5-+"|"T1_5--"|"T1_6"|"T1_6+-"|"T1_6-+"|"T1_6--"|"T2_1"|"T2_1+-"|"T2_1-+"|"T2_1--"|"T2_2"|"T2_2+-"|"T2_2-+"|"T2_2--"|"T2_3"|"T2_3+-"|"T2_3-+"|"T2_3--"|"T2_4"|"T2_4+-"|"T2_4-+"|"T2_4--"|"T2_5"|"T2_5+-"|"T2_5-+"|"T2_5--"|"T2_6"|"T2_6+-"|"T2_6-+"|"T2_6--"|"T3_1"|"T3_1-"|"T3_2"|"T3_2-"|"T3_3"|"T3_3-"|"T3_4"|"T3_4-"|"T3_5"|"T3_5-"|"T3_6"|"T3_6-"|"T4_1"|"T4_1+-"|"T4_1-+"|"T4_1--"|"T4_2"|"T4_2+-"|"T4_2-+"|"T4_2--"|"T4_3"|"T4_3+-"|"T4_3-+"|"T4_3--"|"T4_4"|"T4_4+-"|"T4_4-+"|"T4_4--"|"T4_5"|"T4_5+-"|"T4_5-+"|"T4_5--"|"T4_6"|"T4_6+-"|"T4_6-+"|"T4_6--"

---Piece of line with Coulomb friction at every point, its cone included
---@class (exact) preshape.contact.friction_line
---@field [1]? "friction_line"
---@field name? "friction_line"
---@field mu? number|number[] Coulomb friction coefficient [1], 0.01 .. 5, default 0.5
---@field half_length? number|number[] half of the length of the line, over L [1], 0.001 .. 1, default 0.05
---@field line? "along"|"across"|("along"|"across")[] it lies along the approach axis or along t, default "along"
---@field pull? number|number[] share of the friction in the pattern [1], 0 .. 1, default 0.6
---@field lean? number|number[] direction of that friction, from the approach towards t [rad], -3.1416 .. 3.1416, default 0.5
---@field twist? number|number[] share of the moment about n that this leaves, in the pattern [1], -1 .. 1, default 1

---Piece of line that only pushes along its normal, its cone included
---@class (exact) preshape.contact.frictionless_line
---@field [1]? "frictionless_line"
---@field name? "frictionless_line"
---@field half_length? number|number[] half of the length of the line, over L [1], 0.001 .. 1, default 0.05
---@field line? "along"|"across"|("along"|"across")[] it lies along the approach axis or along t, default "along"
---@field press? number|number[] where on the line the pattern presses, share of half_length [1], -1 .. 1, default 0

---Rectangle that only pushes along its normal, its cone included
---@class (exact) preshape.contact.frictionless_plane
---@field [1]? "frictionless_plane"
---@field name? "frictionless_plane"
---@field half_length? number|number[] half of the side along the approach axis, over L [1], 0.001 .. 1, default 0.05
---@field half_width? number|number[] half of the side along t, over L [1], 0.001 .. 1, default 0.05
---@field press_along? number|number[] where the pattern presses, share of half_length [1], -1 .. 1, default 0
---@field press_across? number|number[] where the pattern presses, share of half_width [1], -1 .. 1, default 0

---Point contact that only pushes along its normal
---@class (exact) preshape.contact.frictionless_point
---@field [1]? "frictionless_point"
---@field name? "frictionless_point"

---Point contact with Coulomb friction, its cone included
---@class (exact) preshape.contact.hard_finger
---@field [1]? "hard_finger"
---@field name? "hard_finger"
---@field mu? number|number[] Coulomb friction coefficient [1], 0.01 .. 5, default 0.5
---@field pull? number|number[] share of the friction in the pattern [1], 0 .. 1, default 1
---@field lean? number|number[] direction of that friction, from the approach towards t [rad], -3.1416 .. 3.1416, default 0.5

---Point contact with Coulomb friction, its limits included
---@class (exact) preshape.contact.hard_finger_lua
---@field [1]? "hard_finger_lua"
---@field name? "hard_finger_lua"
---@field mu? number|number[] coefficient of friction [1], 0 .. 5, default 0.5
---@field share? number|number[] of the friction force that goes along the approach, the rest goes along t [1], 0 .. 1, default 0.6

---Rectangle with friction at every point, its cone included
---@class (exact) preshape.contact.planar_with_friction
---@field [1]? "planar_with_friction"
---@field name? "planar_with_friction"
---@field mu? number|number[] Coulomb friction coefficient [1], 0.01 .. 5, default 0.5
---@field half_length? number|number[] half of the side along the approach axis, over L [1], 0.001 .. 1, default 0.05
---@field half_width? number|number[] half of the side along t, over L [1], 0.001 .. 1, default 0.05
---@field pull? number|number[] share of the friction in the pattern [1], 0 .. 1, default 0.6
---@field lean? number|number[] direction of that friction, from the approach towards t [rad], -3.1416 .. 3.1416, default 0.5
---@field twist? number|number[] share of the moment about n that this leaves, in the pattern [1], -1 .. 1, default 1

---Soft finger weighted by Ka, Ko, Kn, Mn (thesis eq. 3.6.5)
---@class (exact) preshape.contact.salisbury_soft_finger
---@field [1]? "salisbury_soft_finger"
---@field name? "salisbury_soft_finger"
---@field ka? number|number[] force along the approach axis, share of the normal force [1], 0 .. 10, default 0.45
---@field ko? number|number[] force along t = n x a, share of the normal force [1], 0 .. 10, default 0.25
---@field kn? number|number[] normal force [1], 0 .. 10, default 1
---@field mn? number|number[] moment about the normal, over normal force times L [1], 0 .. 10, default 0.8
---@field project_approach? boolean|boolean[] use the approach axis' part in the contact plane, default false

---Soft finger with an elliptic limit surface, its cone included
---@class (exact) preshape.contact.soft_finger_elliptic
---@field [1]? "soft_finger_elliptic"
---@field name? "soft_finger_elliptic"
---@field mu? number|number[] Coulomb friction coefficient [1], 0.01 .. 5, default 0.5
---@field radius? number|number[] radius of the contact area, over L [1], 0.001 .. 1, default 0.05
---@field pressure? "constant"|"hertz"|"winkler"|("constant"|"hertz"|"winkler")[] how the pressure falls off from the centre, default "hertz"
---@field pull? number|number[] share of the friction in the pattern [1], 0 .. 1, default 0.6
---@field lean? number|number[] direction of that friction, from the approach towards t [rad], -3.1416 .. 3.1416, default 0.5
---@field twist? number|number[] share of the moment about n that this leaves, in the pattern [1], -1 .. 1, default 1

---@alias preshape.contact_name "friction_line"|"frictionless_line"|"frictionless_plane"|"frictionless_point"|"hard_finger"|"hard_finger_lua"|"planar_with_friction"|"salisbury_soft_finger"|"soft_finger_elliptic"
---@alias preshape.contact preshape.contact_name|preshape.contact.friction_line|preshape.contact.frictionless_line|preshape.contact.frictionless_plane|preshape.contact.frictionless_point|preshape.contact.hard_finger|preshape.contact.hard_finger_lua|preshape.contact.planar_with_friction|preshape.contact.salisbury_soft_finger|preshape.contact.soft_finger_elliptic

---Dot product of the memberships over that of the longer one with itself
---@class (exact) preshape.similarity.chen_vector
---@field [1]? "chen_vector"
---@field name? "chen_vector"

---Cosine of the angle between task and wrench
---@class (exact) preshape.similarity.cosine
---@field [1]? "cosine"
---@field name? "cosine"
---@field sharpness? number|number[] power of the mapped cosine; above 1 it tells small angles better apart [1], 0.01 .. 100, default 1

---Cosine of the angle between task and wrench, as numbers
---@class (exact) preshape.similarity.cosine_crisp
---@field [1]? "cosine_crisp"
---@field name? "cosine_crisp"
---@field sharpness? number|number[] power of the mapped cosine; above 1 it tells small angles better apart [1], 0.01 .. 100, default 1

---Twice the common memberships over all of both patterns
---@class (exact) preshape.similarity.dice
---@field [1]? "dice"
---@field name? "dice"

---Mean difference of the memberships, summed over the components
---@class (exact) preshape.similarity.hamming
---@field [1]? "hamming"
---@field name? "hamming"

---Intersection over union of the memberships (thesis eq. 3.9.1)
---@class (exact) preshape.similarity.jaccard
---@field [1]? "jaccard"
---@field name? "jaccard"

---One minus the largest difference of the memberships
---@class (exact) preshape.similarity.largest_difference
---@field [1]? "largest_difference"
---@field name? "largest_difference"

---Sum of Minkowski distances of the memberships, of any order
---@class (exact) preshape.similarity.minkowski
---@field [1]? "minkowski"
---@field name? "minkowski"
---@field order? number|number[] exponent p; 1 adds the differences, 2 is tfdist [1], 1 .. 100, default 3

---Angle between the screws of task and wrench, parts weighted
---@class (exact) preshape.similarity.screw_angle
---@field [1]? "screw_angle"
---@field name? "screw_angle"
---@field force? number|number[] weight of the first three components [1], 0 .. 1000, default 1
---@field moment? number|number[] weight of the last three components [1], 0 .. 1000, default 1

---How far the task's fuzzy vectors lie in the wrench's
---@class (exact) preshape.similarity.subsethood
---@field [1]? "subsethood"
---@field name? "subsethood"

---Weighted Euclidean distance of task and wrench, as numbers
---@class (exact) preshape.similarity.task_distance
---@field [1]? "task_distance"
---@field name? "task_distance"
---@field weights? number[]|number[][] of the six components, in their order Tx Ty Tz Rx Ry Rz [1], 0 .. 1000, default { 1, 1, 1, 1, 1, 1 }
---@field half? number|number[] distance that scores one half [1], 1e-06 .. 1000000, default 1

---Sum of Euclidean distances of memberships (thesis eq. 3.9.5)
---@class (exact) preshape.similarity.tfdist
---@field [1]? "tfdist"
---@field name? "tfdist"

---Sum of approaching degrees over the components (thesis eq. 3.9.11)
---@class (exact) preshape.similarity.tfvadi
---@field [1]? "tfvadi"
---@field name? "tfvadi"

---Sum of approaching degrees over the components (thesis eq. 3.9.11)
---@class (exact) preshape.similarity.tfvadi_lua
---@field [1]? "tfvadi_lua"
---@field name? "tfvadi_lua"

---One over one plus the mean Euclidean distance of the memberships
---@class (exact) preshape.similarity.turksen_zhong
---@field [1]? "turksen_zhong"
---@field name? "turksen_zhong"

---@alias preshape.similarity_name "chen_vector"|"cosine"|"cosine_crisp"|"dice"|"hamming"|"jaccard"|"largest_difference"|"minkowski"|"screw_angle"|"subsethood"|"task_distance"|"tfdist"|"tfvadi"|"tfvadi_lua"|"turksen_zhong"
---@alias preshape.similarity preshape.similarity_name|preshape.similarity.chen_vector|preshape.similarity.cosine|preshape.similarity.cosine_crisp|preshape.similarity.dice|preshape.similarity.hamming|preshape.similarity.jaccard|preshape.similarity.largest_difference|preshape.similarity.minkowski|preshape.similarity.screw_angle|preshape.similarity.subsethood|preshape.similarity.task_distance|preshape.similarity.tfdist|preshape.similarity.tfvadi|preshape.similarity.tfvadi_lua|preshape.similarity.turksen_zhong

---Multilayer perceptron trained by the library FANN
---@class (exact) preshape.classifier.fann
---@field [1]? "fann"
---@field name? "fann"
---@field hidden? integer|integer[] Hidden units, 1 .. 4096, default 45
---@field trainer? "rprop"|"quickprop"|"incremental"|"batch"|("rprop"|"quickprop"|"incremental"|"batch")[] FANN's training algorithm, default "incremental"
---@field error? "tanh"|"linear"|("tanh"|"linear")[] FANN's error function: linear takes an error as it is, tanh makes large ones larger, default "tanh"
---@field scaling? "asinh"|"none"|("asinh"|"none")[] How inputs are compressed, default "asinh"
---@field goal? number|number[] Mean squared error over rows and bits to arrive at, 1e-09 .. 0.25, default 0.001
---@field max_epochs? integer|integer[] Most passes over the rows in one run, 1 .. 100000000, default 10000
---@field restarts? integer|integer[] Most runs begun anew for a network that has stalled, 0 .. 100, default 5
---@field weight_range? number|number[] Initial weights lie in plus and minus this, 1e-06 .. 100, default 0.5
---@field learning_rate? number|number[] Rate (quickprop, incremental, batch), 1e-09 .. 100, default 0.7
---@field momentum? number|number[] Share of its last step that a weight repeats (incremental), 0 .. 0.999, default 0

---Weighted vote of the k nearest learned rows
---@class (exact) preshape.classifier.knn
---@field [1]? "knn"
---@field name? "knn"
---@field k? integer|integer[] Nearest rows that vote [rows], 1 .. 64, default 3
---@field power? number|number[] A vote counts distance to minus this; 0: all count alike [1], 0 .. 16, default 2

---Multilayer perceptron of one hidden layer (thesis sec. 3.10)
---@class (exact) preshape.classifier.mlp
---@field [1]? "mlp"
---@field name? "mlp"
---@field hidden? integer|integer[] Hidden units of a network, 1 .. 4096, default 45
---@field committee? integer|integer[] Networks whose bit probabilities are averaged, 1 .. 100, default 5
---@field outputs? "fields"|"bits"|("fields"|"bits")[] Output units: one for each learned pattern of a field of the code, or one for each bit, default "fields"
---@field fields? number[]|number[][] Bits of each field of the code; where they do not add up to it, the code is one field, 1 .. 24, default { 4, 3, 2 }
---@field sharpness? integer|integer[] Power of a field's outputs before they share out its probability, 1 .. 16, default 4
---@field scaling? "asinh"|"none"|("asinh"|"none")[] How inputs are compressed, default "asinh"
---@field trainer? "rprop"|"backprop"|"lbfgs"|"levenberg_marquardt"|("rprop"|"backprop"|"lbfgs"|"levenberg_marquardt")[] Online back-propagation, or one of those that move once for all rows, default "rprop"
---@field loss? "cross_entropy"|"squared"|("cross_entropy"|"squared")[] What the trainer makes small, default "cross_entropy"
---@field goal? number|number[] Mean squared error over rows and bits to arrive at, 1e-09 .. 0.25, default 0.001
---@field max_epochs? integer|integer[] Most passes over the rows in one run, 1 .. 100000000, default 10000
---@field restarts? integer|integer[] Most runs begun anew for a network that has stalled, 0 .. 100, default 5
---@field validation? number|number[] Share of the rows held out to stop early; 0: learn all, 0 .. 0.5, default 0
---@field patience? integer|integer[] Epochs without a lower error of the held-out rows after which a run ends, 1 .. 100000000, default 100
---@field weight_range? number|number[] Initial weights lie in plus and minus this, 1e-06 .. 100, default 0.5
---@field weight_decay? number|number[] Pull of each weight to zero, added to the gradient (rprop, lbfgs), 0 .. 100, default 0.01
---@field learning_rate_hidden? number|number[] Rate of the hidden layer's weights (backprop), 1e-09 .. 100, default 0.6
---@field learning_rate_output? number|number[] Rate of the output layer's weights (backprop), 1e-09 .. 100, default 0.5
---@field momentum? number|number[] Share of its last step that a weight repeats (backprop), 0 .. 0.999, default 0

---Vote of all learned rows by a kernel that reproduces each
---@class (exact) preshape.classifier.nadaraya_watson
---@field [1]? "nadaraya_watson"
---@field name? "nadaraya_watson"
---@field groups? number[]|number[][] Features of each group; where they do not add up to them, all are one group, 1 .. 64, default { 3, 3, 2, 3, 4 }
---@field widths? number[]|number[][] Of the kernel in each group, in the group's spread among the rows [spreads], 0.001 .. 1000, default { 1, 1, 1, 0.5, 0.5 }
---@field power? number|number[] A near row's vote grows as distance to minus this, 0 .. 16, default 4
---@field sharpness? number|number[] Power of the votes' shares in the probabilities; 0: the best for rows left out, 0 .. 16, default 0
---@field fields? number[]|number[][] Bits of each field of the code; where they do not add up to it, the code is one field, 1 .. 24, default { 4, 3, 2 }
---@field scaling? "asinh"|"none"|("asinh"|"none")[] How inputs are compressed, default "asinh"

---@alias preshape.classifier_name "fann"|"knn"|"mlp"|"nadaraya_watson"
---@alias preshape.classifier preshape.classifier_name|preshape.classifier.fann|preshape.classifier.knn|preshape.classifier.mlp|preshape.classifier.nadaraya_watson

---Looks at every triangle: slow, exact, the reference of the others
---@class (exact) preshape.collision.brute
---@field [1]? "brute"
---@field name? "brute"

---Rays and distances on Embree's trees, decided in double precision
---@class (exact) preshape.collision.embree
---@field [1]? "embree"
---@field name? "embree"

---Rays on FCL's bounding-volume trees, distances by FCL
---@class (exact) preshape.collision.fcl
---@field [1]? "fcl"
---@field name? "fcl"
---@field tolerance? number|number[] at which FCL's iterations for distances of solids stop [m], 1e-12 .. 0.001, default 1e-09

---@alias preshape.collision_name "brute"|"embree"|"fcl"
---@alias preshape.collision preshape.collision_name|preshape.collision.brute|preshape.collision.embree|preshape.collision.fcl

---Serial fingers by standard Denavit-Hartenberg parameters
---@class preshape.hand.dh
---@field model "dh"
---@field name? string for reports
---@field summary? string one line
---@field [string] any the description's own keys

---Fingers of a URDF, named by a small Lua table
---@class preshape.hand.urdf
---@field model "urdf"
---@field name? string for reports
---@field summary? string one line
---@field [string] any the description's own keys

---@alias preshape.hand_name "dh"|"urdf"
---@alias preshape.hand preshape.hand.dh|preshape.hand.urdf

---Epsilon and volume of the grasp wrench space (Ferrari and Canny 1992)
---@class (exact) preshape.quality.ferrari_canny
---@field [1]? "ferrari_canny"
---@field name? "ferrari_canny"
---@field norm? "l1"|"linf"|("l1"|"linf")[] bound 1 on the sum of the normal forces, or on each, default "l1"
---@field resolution? integer|integer[] edges of a friction cone [1], 3 .. 32, default 8
---@field volume? boolean|boolean[] give the volume too, default false

---Whether the contacts can resist every wrench, by a linear programme
---@class (exact) preshape.quality.force_closure
---@field [1]? "force_closure"
---@field name? "force_closure"
---@field resolution? integer|integer[] edges of a friction cone [1], 3 .. 64, default 8
---@field tolerance? number|number[] a margin up to it counts as none [1], 1e-12 .. 0.1, default 1e-07

---Smallest over largest singular value of the wrench union
---@class (exact) preshape.quality.grasp_isotropy
---@field [1]? "grasp_isotropy"
---@field name? "grasp_isotropy"
---@field rank_tolerance? number|number[] isotropy below this counts as none [1], 0 .. 0.1, default 1e-06

---Smallest singular value, condition and volume of the grasp matrix
---@class (exact) preshape.quality.grasp_matrix
---@field [1]? "grasp_matrix"
---@field name? "grasp_matrix"

---The largest load that friction and joint torques can hold, and equilibrium under a given one
---@class (exact) preshape.quality.largest_load
---@field [1]? "largest_load"
---@field name? "largest_load"
---@field load? number[]|number[][] external wrench on the object about O, in O: force, moment [N or N m], -1000000 .. 1000000, default { 0, 0, -1, 0, 0, 0 }
---@field finger_force? number|number[] most normal force of a contact where no joint's limit is known [N], 0.001 .. 100000, default 10
---@field resolution? integer|integer[] edges of a friction cone [1], 3 .. 64, default 8

---Pad, palm or side opposition, with the shares of each
---@class (exact) preshape.quality.opposition
---@field [1]? "opposition"
---@field name? "opposition"

---Rank of the wrench union and of the resultant (thesis sec. 3.7)
---@class (exact) preshape.quality.sta_manu
---@field [1]? "sta_manu"
---@field name? "sta_manu"
---@field limit? number|number[] smallest component that counts for manipulability [1], 0 .. 10, default 0.1
---@field rank_tolerance? number|number[] share of the largest singular value that counts as zero [1], 0 .. 0.1, default 1e-08

---The largest task ellipsoid in the grasp wrench space (Li and Sastry 1988)
---@class (exact) preshape.quality.task_ellipsoid
---@field [1]? "task_ellipsoid"
---@field name? "task_ellipsoid"
---@field half_axes? number[]|number[][] of the task's wrenches along the axes of O: forces, moments over L [1], 0 .. 1000, default { 1, 1, 1, 1, 1, 1 }
---@field centre? number[]|number[][] of the task's wrenches about O: force, moment over L [1], -1000 .. 1000, default { 0, 0, 0, 0, 0, 0 }
---@field norm? "l1"|"linf"|("l1"|"linf")[] bound 1 on the sum of the normal forces, or on each, default "l1"
---@field resolution? integer|integer[] edges of a friction cone [1], 3 .. 64, default 8

---@alias preshape.quality_name "ferrari_canny"|"force_closure"|"grasp_isotropy"|"grasp_matrix"|"largest_load"|"opposition"|"sta_manu"|"task_ellipsoid"
---@alias preshape.quality preshape.quality_name|preshape.quality.ferrari_canny|preshape.quality.force_closure|preshape.quality.grasp_isotropy|preshape.quality.grasp_matrix|preshape.quality.largest_load|preshape.quality.opposition|preshape.quality.sta_manu|preshape.quality.task_ellipsoid

---Beam search over planes, stations and finger counts (thesis sec. 3.10)
---@class (exact) preshape.explorer.beam
---@field [1]? "beam"
---@field name? "beam"
---@field width? integer|integer[] stations that survive a generation [stations], 1 .. 1000, default 8
---@field first_step? number|number[] step of the second generation, over the half extent [1], 0.001 .. 1, default 0.2
---@field finest? number|number[] smallest step, over the half extent [1], 0.0005 .. 1, default 0.05
---@field budget? integer|integer[] most stations that one exploration evaluates; 0: learning.budget [stations], 0 .. 1000000000, default 0

---Evaluates every station of a regular grid
---@class (exact) preshape.explorer.exhaustive
---@field [1]? "exhaustive"
---@field name? "exhaustive"
---@field step? number|number[] step of the grid, over the half extent [1], 0.001 .. 0.5, default 0.05
---@field budget? integer|integer[] most stations that one exploration evaluates; 0: learning.budget [stations], 0 .. 1000000000, default 0

---Steepest ascent from the best of the symbols' stations (thesis sec. 3.10)
---@class (exact) preshape.explorer.hill_climb
---@field [1]? "hill_climb"
---@field name? "hill_climb"
---@field restarts? integer|integer[] starts that are climbed from, the best first, 1 .. 10000, default 8
---@field first_step? number|number[] first step of a climb, over the half extent [1], 0.001 .. 1, default 0.2
---@field finest? number|number[] smallest step, over the half extent [1], 0.0005 .. 1, default 0.05
---@field budget? integer|integer[] most stations that one exploration evaluates; 0: learning.budget [stations], 0 .. 1000000000, default 0

---@alias preshape.explorer_name "beam"|"exhaustive"|"hill_climb"
---@alias preshape.explorer preshape.explorer_name|preshape.explorer.beam|preshape.explorer.exhaustive|preshape.explorer.hill_climb

---Carries a grasp out joint by joint, by kinematics and collisions (thesis sec. 4.4)
---@class (exact) preshape.simulator.kinematic
---@field [1]? "kinematic"
---@field name? "kinematic"
---@field tolerance? number|number[] distance at which a fingertip has reached its place [m], 1e-06 .. 0.01, default 0.0001
---@field stand_offs? integer|integer[] distances behind the contacts that are tried, up to a finger's length, 1 .. 200, default 10
---@field slants? number[]|number[][] of the last links, from the contact's normal towards the approach axis, that are tried [deg], 0 .. 90, default { 20, 45, 70 }
---@field leans? number[]|number[][] leans about the transverse axis that are tried, one after another [deg], -90 .. 90, default { 0, 15, -15, 30, -30 }
---@field turn? number|number[] most that the hand turns about each of its axes where its fingers alone do not reach [deg], 0 .. 90, default 30
---@field way? number|number[] way along its own axis that the open hand must be free to come [m], 0 .. 1, default 0.1
---@field way_step? number|number[] distance of the places in which it is looked at there [m], 0.0001 .. 0.1, default 0.005
---@field candidates? integer|integer[] stances of a lean whose whole motion is looked at, the least strained first, 1 .. 1000, default 30

---@alias preshape.simulator_name "kinematic"
---@alias preshape.simulator preshape.simulator_name|preshape.simulator.kinematic

---an object: a shipped one by name, or a mesh
---@class (exact) preshape.Object
---@field name? string a shipped object, or a name for the mesh, default ""
---@field mesh? string mesh file, relative to the script, default ""
---@field weld? number vertices nearer than this share of the box diagonal are one [1], 0 .. 0.01, default 1e-06
---@field summary? string one line on the object, default ""
---@field unit? "file"|"m"|"cm"|"mm"|"inch"|"U" what one unit of the mesh's numbers is; file: as its format states, else metres, default "file"
---@field fit? number scale so that the largest extent is this long, whatever the unit; 0: do not [U], 0 .. 1000000, default 0
---@field frame? "file"|"principal"|"smallest_box" axes of the object: the file's, of inertia, or of the smallest enclosing box, default "file"
---@field centre? "box"|"volume" origin of the object: centre of its axis-aligned box, or of its volume, default "box"

---a task by components, by name or as a named manipulation
---@class (exact) preshape.Task
---@field T? number[] translation wanted along X, Y, Z; 1 is a full primitive [1], -1000000 .. 1000000, default { 0.1, 0.1, 0.1 }
---@field R? number[] rotation wanted about X, Y, Z [1], -1000000 .. 1000000, default { 0.05, 0.05, 0.05 }
---@field name? string a task of the task space, such as "T1_2" or "T1_2+-", default ""
---@field manipulation? string one of Michelman's manipulations, with approach and opposition, default ""
---@field approach? string approach axis of the manipulation, default "X"
---@field opposition? string opposition axis of the manipulation, default "Z"
---@field stability? number stability wanted [1], 0 .. 6, default 6
---@field manipulability? number manipulability wanted [1], 0 .. 6, default 5

---how virtual grasps are analysed
---@class (exact) preshape.Analysis
---@field length? number|number[] characteristic length L by which lengths in wrenches are divided [U], 0.1 .. 100, default 6
---@field opposition_angle_deg? number|number[] most deviation of opposed contact normals from exact opposition [deg], 0 .. 90, default 45
---@field virtual_fingers? "rule"|"any"|("rule"|"any")[] who decides the finger count: rules R1 to R3, or the search, default "rule"
---@field station_step? number|number[] step of the station grid, over the half extent along the approach axis [1], 0.001 .. 0.5, default 0.05
---@field transverse_offsets? number[]|number[][] places of the thumb that searches try, from the middle of the section over its half width [1], -1 .. 1, default { 0 }
---@field ray_margin? number|number[] least distance of the opened fingertips from the object [U], 0 .. 10, default 0.5
---@field universe? "half_extent"|"normalised"|("half_extent"|"normalised")[] what approach symbols are read over: the object's half extent, or L, default "half_extent"

---thresholds of the critic
---@class (exact) preshape.Thresholds
---@field estimation? number|number[] similarity at which a grasp serves the task [of the measure], -1000000000 .. 1000000000, default 3
---@field recognition? number|number[] similarity at which a recalled pattern shows that the object is known [of the measure], -1000000000 .. 1000000000, default 5.5
---@field search? number|number[] mode 1 searches |x - x0| <= (1 - search) * extent along the approach axis [1], 0 .. 1, default 0.5

---how the agent learns
---@class (exact) preshape.Learning
---@field policy? "ask"|"learn"|("ask"|"learn")[] of a known object whose new task some grasp would serve: stop and ask, or learn it, default "ask"
---@field teach? "wrench"|"task"|"both"|("wrench"|"task"|"both")[] rows that a lesson adds: the grasp's own wrench, the task as asked, or both, default "both"
---@field budget? integer|integer[] most stations that one exploration evaluates [stations], 1 .. 1000000000, default 20000

---how the hand carries the grasp out
---@class (exact) preshape.Execution
---@field attempts? integer|integer[] next-best stations that are tried when the hand cannot carry out the first [stations], 0 .. 1000, default 4
---@field reachable? boolean|boolean[] only grasps that the simulated hand carries out count, recalled or found, default false
---@field support? "none"|"+X"|"-X"|"+Y"|"-Y"|"+Z"|"-Z"|("none"|"+X"|"-X"|"+Y"|"-Y"|"+Z"|"-Z")[] side of the object on which it stands, default "none"

---one fuzzy set; exactly one shape
---@class (exact) preshape.FuzzySet
---@field name string
---@field trapezoid? number[] 4 numbers: a <= b <= c <= d
---@field triangle? number[] 3 numbers: a <= b <= c
---@field gaussian? number[] 2 numbers: centre, sigma > 0
---@field bell? number[] 3 numbers: half width > 0, slope > 0, centre
---@field sigmoid? number[] 2 numbers: steepness, crossing

---a report, see docs/report-schema.md
---@alias preshape.Report table<string, any>

---what `on_report` returns to go on
---@class (exact) preshape.Correction
---@field task? preshape.TaskName|number[]|preshape.Task
---@field object? string|preshape.Object
---@field thresholds? preshape.Thresholds

---an approach plane
---@class (exact) preshape.Plane
---@field approach preshape.Axis|number[] the way the hand comes
---@field push preshape.Axis|number[] the way the forefingers push

---approach planes that are sampled
---@class (exact) preshape.SampledPlanes
---@field directions? integer spread evenly over the sphere
---@field rolls? integer planes of each direction
---@field thesis? boolean the thesis's twelve come first

---@alias preshape.Axis "X"|"Y"|"Z"|"+X"|"+Y"|"+Z"|"-X"|"-Y"|"-Z"

---what teaching an object gave
---@class (exact) preshape.Lesson
---@field rows_added integer
---@field evaluations integer
---@field arrived boolean
---@field epochs integer
---@field restarts integer
---@field wrong_rows integer
---@field mean_squared_error number

---how much of a memory its classifier predicts
---@class (exact) preshape.Taught
---@field rows integer in the memory
---@field predicted integer of them: plane, symbol and finger count all right

---the best grasp that the explorers find
---@class (exact) preshape.Best
---@field plane integer
---@field symbol integer
---@field virtual_fingers integer
---@field approach number over the half extent
---@field transverse number over the section's half width
---@field first number score of the deciding measure
---@field second number score of the other one
---@field evaluations integer

---a grasp of the workspace
---@class (exact) preshape.WorkspaceRow
---@field plane integer
---@field symbol integer
---@field virtual_fingers integer
---@field approach number over the half extent
---@field wrench number[] resultant about O, lengths over L
---@field quality table<string, number> all numbers of the quality measures
---@field first number score of the deciding measure
---@field second number score of the other one

---every combination of a scenario that gives lists where it gives one
---@class (exact) preshape.Comparison
---@field schema string
---@field scenario string
---@field keys string[] what was chosen from: "contact", "thresholds.estimation"
---@field rows preshape.ComparedRun[]

---@class (exact) preshape.ComparedRun
---@field choices table<string, any>
---@field report? preshape.Report
---@field seconds? number
---@field refusal? string

---a task of the task space
---@class (exact) preshape.TaskRecord
---@field name string
---@field T number[]
---@field R number[]

---a component that can be used
---@class (exact) preshape.ComponentRecord
---@field kind preshape.Kind
---@field name string
---@field summary string
---@field plugin string
---@field version string
---@field capabilities string[]
---@field parameters preshape.ParameterRecord[]

---@class (exact) preshape.ParameterRecord
---@field name string
---@field type string
---@field default any
---@field minimum? number
---@field maximum? number
---@field choices? string[]
---@field unit string
---@field text string

---@class (exact) preshape.Scenario
---@field title? string what the scenario asks, for reports
---@field object preshape.ObjectName|string|preshape.Object|(preshape.ObjectName|string|preshape.Object)[] the object: a shipped one, a mesh file, or { name|mesh, unit, fit, frame, centre, weld }
---@field hand? preshape.HandName|string|preshape.hand|(preshape.HandName|string|preshape.hand)[] the hand: a shipped one, a description file, or { model = a hand component, its parameters }; default "utah_mit"
---@field task? preshape.TaskName|number[]|preshape.Task|(preshape.TaskName|number[]|preshape.Task)[] the task: "T1_2", { Tx, Ty, Tz, Rx, Ry, Rz }, { T = , R = }, or { manipulation = , approach = , opposition = }
---@field contact? preshape.contact|preshape.contact[] contact model; default "salisbury_soft_finger"
---@field similarity? preshape.similarity|preshape.similarity[] similarity measure that decides; default "tfvadi"
---@field tie_break? preshape.similarity|preshape.similarity[] similarity measure that breaks ties; default "tfdist"
---@field classifier? preshape.classifier|preshape.classifier[] classifier; default "mlp"
---@field collision? preshape.collision|preshape.collision[] collision backend; default "fcl"
---@field quality? preshape.quality|preshape.quality[] quality measures; default { "sta_manu" }
---@field explorer? preshape.explorer|preshape.explorer[] problem generator; default "beam"
---@field proof? preshape.explorer|preshape.explorer[] explorer asked when the first finds nothing that serves; default "exhaustive"
---@field simulator? preshape.simulator|"none"|(preshape.simulator|"none")[] carries the grasp out with the hand; "none": it is not carried out; default "kinematic"
---@field analysis? preshape.Analysis how virtual grasps are analysed
---@field thresholds? preshape.Thresholds thresholds of the critic
---@field learning? preshape.Learning how the agent learns
---@field execution? preshape.Execution how the hand carries the grasp out
---@field fuzzy? preshape.FuzzySet[]|preshape.FuzzySet[][] fuzzy sets of tasks and wrenches; default the thesis's seven
---@field symbols? preshape.FuzzySet[]|preshape.FuzzySet[][] fuzzy sets of the approach value; default the thesis's seven
---@field planes? preshape.Plane[]|preshape.SampledPlanes|(preshape.Plane[]|preshape.SampledPlanes)[] approach planes; default the thesis's twelve
---@field memory? string the agent's memory; a bare name is kept in the user's folder; default "default"
---@field pretrain? preshape.ObjectName|"none"|(preshape.ObjectName|"none")[] object that an empty memory is taught first; "none": do not; default "cube"
---@field stations? number[]|number[][] stations that pretraining teaches, over the half extent; default { -0.25, 0.25 }
---@field seed? integer|integer[] seed of all randomness; default 1
---@field on_report? fun(report: preshape.Report): preshape.Correction? meta control: gets each report, returns nil or { task = , object = , thresholds = } to go on

-- A component's file, NAME.plugin.lua: docs/lua-components.md

---@class (exact) preshape.ParameterDeclaration
---@field name string
---@field type "boolean"|"integer"|"number"|"text"|"choice"|"numbers"|"table"
---@field default? any without one it must be given
---@field minimum? number
---@field maximum? number
---@field unit? string "m", "rad", "1" for a ratio
---@field choices? string[] of a choice
---@field text string one line

---three numbers each, in the object's frame
---@class (exact) preshape.Contact
---@field p number[] contact point [m]
---@field n number[] inward unit normal of the object
---@field a number[] approach axis
---@field t number[] n x a

---@class (exact) preshape.Grasp
---@field contacts preshape.Contact[] thumb first
---@field wrenches number[][] pattern wrenches about their own points
---@field wrench_union number[][] unit wrenches about O, lengths over L
---@field resultant number[] about O
---@field length number L [m]
---@field approach? number[] unit, in O: the way the hand comes
---@field opposition? number[] unit, in O: the way the forefingers push

---@class (exact) preshape.TrainingOutcome
---@field status? "arrived"|"stalled"
---@field epochs? integer
---@field restarts? integer
---@field mean_squared_error? number
---@field wrong_rows? integer

---what is left out is the identity's
---@class (exact) preshape.Pose
---@field R? number[] nine numbers, row by row
---@field p? number[] three numbers [m]

---@alias preshape.FingerRole "thumb"|"index"|"middle"|"ring"|"little"

---@class (exact) preshape.FingerDescription
---@field name string
---@field role preshape.FingerRole
---@field base? preshape.Pose of the finger's base in the hand
---@field joints preshape.JointDescription[] base to tip
---@field tip? preshape.Pose of the tip in the last link

---@class (exact) preshape.JointDescription
---@field name string
---@field prismatic? boolean
---@field lower number [rad] or [m]
---@field upper number
---@field torque_limit? number
---@field follows? { joint: string, ratio: number, offset?: number } joint that moves it, of any finger
---@field X_PJ? preshape.Pose of the joint in the link before
---@field X_JL? preshape.Pose of the link in the joint

---@class (exact) preshape.LinkSolid
---@field finger? string none: the palm
---@field link? integer
---@field shape "sphere"|"capsule"|"box"
---@field radius? number [m]
---@field half_length? number [m] capsule, along z
---@field half_extents? number[] [m] box
---@field X_LS? preshape.Pose

---@class (exact) preshape.Station
---@field plane integer from 1
---@field approach number over the half extent
---@field virtual_fingers? integer
---@field transverse? number over the section's half width

---@class (exact) preshape.ExplorationProblem
---@field planes integer
---@field symbol_stations number[]
---@field lowest number
---@field highest number
---@field finger_counts integer[]
---@field transverse_offsets number[]
---@field evaluate fun(stations: preshape.Station[]): { first: number, second: number, feasible: boolean }[]?

---@class (exact) preshape.SimulationTask
---@field contacts preshape.Contact[]
---@field fingers preshape.FingerRole[] which finger goes to which contact
---@field approach number[] unit, in O
---@field opposition number[] unit, in O
---@field clearance number [m]
---@field hand { fingers: table[], joints: table[], solids: table[] }
---@field forward fun(finger: integer, q: number[]): preshape.Pose[]
---@field object_distance fun(solids: table[]): number[]

---@class (exact) preshape.Simulation
---@field status "reached"|"unreachable"|"collision"|"too_few_fingers"
---@field reason? string unless reached: one sentence
---@field X_OH? preshape.Pose hand base
---@field path? number[][] postures, each a number for every joint
---@field contact_error_m? number

---what `new` of kind contact returns
---@class (exact) preshape.ContactInstance
---@field basis_size integer number of unit wrenches
---@field basis fun(C: preshape.Contact): number[][] unit wrenches about the contact's own point, in O
---@field pattern fun(C: preshape.Contact): ... what the contact adds to the pattern: six numbers, or a list of six
---@field primitives? fun(C: preshape.Contact, resolution: integer): number[][] edges of the cone that the contact can bear
---@field admits? fun(C: preshape.Contact, wrench: number[], tolerance: number): boolean

---what the file of kind contact returns
---@class (exact) preshape.ContactComponent
---@field kind "contact"
---@field name string letters, digits, _; the file's name without its ending
---@field version string such as "1.0.0"
---@field licence string
---@field author string
---@field summary string one line
---@field capabilities? string[] promises that the conformance suite checks
---@field parameters? preshape.ParameterDeclaration[]
---@field new fun(p: table<string, any>): preshape.ContactInstance

---what `new` of kind similarity returns
---@class (exact) preshape.SimilarityInstance
---@field scale { farthest: number, nearest: number }|fun(sets: integer): { farthest: number, nearest: number }
---@field component? fun(task: table, pattern: table): number what one component adds; memberships 1 .. sets, and crisp
---@field compare? fun(task: table, pattern: table): number the score, in place of component
---@field components? fun(task: table, pattern: table): ... with compare: six numbers that explain the score

---what the file of kind similarity returns
---@class (exact) preshape.SimilarityComponent
---@field kind "similarity"
---@field name string letters, digits, _; the file's name without its ending
---@field version string such as "1.0.0"
---@field licence string
---@field author string
---@field summary string one line
---@field capabilities? string[] promises that the conformance suite checks
---@field parameters? preshape.ParameterDeclaration[]
---@field new fun(p: table<string, any>): preshape.SimilarityInstance

---what `new` of kind classifier returns
---@class (exact) preshape.ClassifierInstance
---@field fit fun(inputs: number[][], targets: number[][], seed: integer): any, preshape.TrainingOutcome? the model: plain data
---@field extend? fun(model: any, inputs: number[][], targets: number[][], first_new: integer, seed: integer): any, preshape.TrainingOutcome?
---@field predict fun(model: any, input: number[]): ... probability of each bit, as results or as a list

---what the file of kind classifier returns
---@class (exact) preshape.ClassifierComponent
---@field kind "classifier"
---@field name string letters, digits, _; the file's name without its ending
---@field version string such as "1.0.0"
---@field licence string
---@field author string
---@field summary string one line
---@field capabilities? string[] promises that the conformance suite checks
---@field parameters? preshape.ParameterDeclaration[]
---@field new fun(p: table<string, any>): preshape.ClassifierInstance

---what `new` of kind hand returns
---@class (exact) preshape.HandInstance
---@field dimensions { unit_length: number, finger_spacing: number, maximum_opening: number, base_width: number } [m]
---@field fingers preshape.FingerDescription[]
---@field solids? preshape.LinkSolid[]
---@field forward? fun(finger: integer, q: number[]): preshape.Pose[] poses of base, each link and tip, in place of the chains

---what the file of kind hand returns
---@class (exact) preshape.HandComponent
---@field kind "hand"
---@field name string letters, digits, _; the file's name without its ending
---@field version string such as "1.0.0"
---@field licence string
---@field author string
---@field summary string one line
---@field capabilities? string[] promises that the conformance suite checks
---@field parameters? preshape.ParameterDeclaration[]
---@field new fun(p: table<string, any>): preshape.HandInstance

---what `new` of kind quality returns
---@class (exact) preshape.QualityInstance
---@field numbers { name: string, unit?: string, lowest: number, highest: number, higher_is_better?: boolean }[]
---@field evaluate fun(grasp: preshape.Grasp): ... those numbers, in order, as results or as a list

---what the file of kind quality returns
---@class (exact) preshape.QualityComponent
---@field kind "quality"
---@field name string letters, digits, _; the file's name without its ending
---@field version string such as "1.0.0"
---@field licence string
---@field author string
---@field summary string one line
---@field capabilities? string[] promises that the conformance suite checks
---@field parameters? preshape.ParameterDeclaration[]
---@field new fun(p: table<string, any>): preshape.QualityInstance

---what `new` of kind explorer returns
---@class (exact) preshape.ExplorerInstance
---@field explore fun(problem: preshape.ExplorationProblem, budget: integer, seed: integer): preshape.Station?

---what the file of kind explorer returns
---@class (exact) preshape.ExplorerComponent
---@field kind "explorer"
---@field name string letters, digits, _; the file's name without its ending
---@field version string such as "1.0.0"
---@field licence string
---@field author string
---@field summary string one line
---@field capabilities? string[] promises that the conformance suite checks
---@field parameters? preshape.ParameterDeclaration[]
---@field new fun(p: table<string, any>): preshape.ExplorerInstance

---what `new` of kind simulator returns
---@class (exact) preshape.SimulatorInstance
---@field simulate fun(task: preshape.SimulationTask, seed: integer): preshape.Simulation

---what the file of kind simulator returns
---@class (exact) preshape.SimulatorComponent
---@field kind "simulator"
---@field name string letters, digits, _; the file's name without its ending
---@field version string such as "1.0.0"
---@field licence string
---@field author string
---@field summary string one line
---@field capabilities? string[] promises that the conformance suite checks
---@field parameters? preshape.ParameterDeclaration[]
---@field new fun(p: table<string, any>): preshape.SimulatorInstance

---what a script calls
---@class preshape.Module
preshape = {}

---version of preshape
---@type string
preshape.version = nil

---marks a table as a scenario; returns it as it is
---@param description preshape.Scenario
---@return preshape.Scenario
function preshape.scenario(description) end

---runs the controller once and returns its report
---@param scenario preshape.Scenario
---@return preshape.Report
function preshape.run(scenario) end

---modes 0 and 1 alone, with nothing learned; returns the report
---@param scenario preshape.Scenario
---@return preshape.Report
function preshape.estimate(scenario) end

---teaches the scenario's object at the pretraining stations
---@param scenario preshape.Scenario
---@return preshape.Lesson
function preshape.pretrain(scenario) end

---the best grasp that the explorers find for the task: plane, approach, score; nil when there is none
---@param scenario preshape.Scenario
---@return preshape.Best?
function preshape.best(scenario) end

---how many rows the scenario's memory holds, and how many of them its classifier predicts
---@param scenario preshape.Scenario
---@return preshape.Taught
function preshape.taught(scenario) end

---the grasp at every station of a grid with its wrench, measures and similarity to the task; stations without a grasp are left out
---@param scenario preshape.Scenario
---@param step? number
---@return preshape.WorkspaceRow[]
function preshape.workspace(scenario, step) end

---runs every combination of a scenario that gives lists where it gives one; keys, and rows with choices and report
---@param scenario preshape.Scenario
---@return preshape.Comparison
function preshape.compare(scenario) end

---the task space; with signs its 84 variants
---@param signs? boolean
---@return preshape.TaskRecord[]
function preshape.tasks(signs) end

---the components that can be used: kind, name, summary, plugin, version, capabilities, parameters
---@param kind? preshape.Kind
---@return preshape.ComponentRecord[]
function preshape.components(kind) end

---names of the objects that are found by name
---@return string[]
function preshape.objects() end

---names of the hands that are found by name
---@return string[]
function preshape.hands() end
