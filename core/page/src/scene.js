// The scene: the run's glTF, turned and zoomed with the mouse, fingers or keys. It is drawn only when something changed.

import {
  AmbientLight, AnimationMixer, Box3, DirectionalLight, LoopOnce, PerspectiveCamera, Raycaster, Scene, Spherical, Vector2,
  Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { element } from "./numbers.js";

const GROUPS = [["hand", "hand"], ["contacts", "contacts"], ["normals", "normals"], ["wrenches", "wrenches"], ["plane", "plane and axes"], ["approach", "approach volume"]];
const $ = (id) => document.getElementById(id);

/// Where one sees the approach plane from: beside it, a little from behind the hand, a little from above.
function direction(result) {
  const contact = result?.contacts[0];
  if (!contact) return new Vector3(0.7, 0.5, 1).normalize();
  const approach = new Vector3(...contact.approach_O), normal = new Vector3(...contact.normal_O);
  const side = new Vector3().crossVectors(approach, normal).normalize();
  if (side.z + 0.5 * side.x + 0.25 * side.y < 0) side.negate();
  return side.addScaledVector(approach, -0.55).addScaledVector(new Vector3(0, 1, 0), 0.45).normalize();
}

/// Corners of the box of every part, where it stands.
function corners(model) {
  const points = [];
  model.updateMatrixWorld(true);
  model.traverse((node) => {
    if (!node.geometry) return;
    node.geometry.computeBoundingBox();
    const { min, max } = node.geometry.boundingBox;
    for (const x of [min.x, max.x]) for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) {
      points.push(new Vector3(x, y, z).applyMatrix4(node.matrixWorld));
    }
  });
  return points;
}

class View {
  constructor(model, result) {
    this.canvas = $("canvas");
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new Scene();
    this.scene.add(model);
    this.model = model;
    this.camera = new PerspectiveCamera(35, 1, 0.001, 100);
    const light = new DirectionalLight(0xffffff, 2.2);
    light.position.set(-0.4, 0.8, 0.6);  // over the watcher's shoulder
    this.camera.add(light);
    this.scene.add(this.camera, new AmbientLight(0xffffff, 1.1));
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => this.draw());
    this.direction = direction(result);
    this.draw = this.draw.bind(this);
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement);
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    this.resize();
    this.reset();
  }

  /// Everything in the picture, whatever its shape, with a margin.
  reset() {
    const axes = [new Vector3(), new Vector3(), new Vector3()];  // right, up, towards the watcher
    this.camera.position.copy(this.direction);
    this.camera.lookAt(0, 0, 0);
    this.camera.updateMatrix();
    this.camera.matrix.extractBasis(...axes);
    const seen = new Box3();
    const points = corners(this.model).map((p) => new Vector3(...axes.map((axis) => p.dot(axis))));
    points.forEach((p) => seen.expandByPoint(p));
    const centre = seen.getCenter(new Vector3());
    const up = Math.tan((this.camera.fov * Math.PI) / 360) * 0.94, across = up * this.camera.aspect;
    const distance = Math.max(...points.map((p) => p.z - centre.z + Math.max(Math.abs(p.x - centre.x) / across, Math.abs(p.y - centre.y) / up)));
    this.controls.target.set(0, 0, 0);
    axes.forEach((axis, i) => this.controls.target.addScaledVector(axis, centre.getComponent(i)));
    this.camera.position.copy(this.controls.target).addScaledVector(this.direction, distance);
    this.camera.near = distance / 100;
    this.camera.far = distance * 10;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }

  key(event) {
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const closer = { "+": 0.9, "=": 0.9, "-": 1.1 };
    if (!(event.key in turns) && !(event.key in closer)) return;
    event.preventDefault();
    const place = new Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    if (event.key in closer) place.radius *= closer[event.key];
    else {
      place.theta += turns[event.key][0] * 0.1;
      place.phi += turns[event.key][1] * 0.1;
    }
    this.camera.position.setFromSpherical(place.makeSafe()).add(this.controls.target);
    this.controls.update();
    this.draw();
  }
}

/// One box a group that the scene has; the object can be seen through.
function addToggles(view) {
  const add = (label, checked, change) => {
    const box = element("input", { type: "checkbox", checked });
    box.onchange = () => { change(box.checked); view.draw(); };
    $("shown").append(element("label", {}, box, ` ${label}`));
  };
  for (const [name, label] of GROUPS) {
    const group = view.model.getObjectByName(name);
    if (group) add(label, true, (on) => { group.visible = on; });
  }
  const object = view.model.getObjectByName("object");
  add("see through the object", false, (on) => {
    object.material.transparent = on;
    object.material.opacity = on ? 0.45 : 1;
    object.material.depthWrite = !on;
    object.material.needsUpdate = true;
  });
}

const nameOf = (node) => node.userData.name || node.name;

/// What the colours mean; links that collide are named.
function addLegend(model) {
  const seen = new Map(), colliding = [];
  model.traverse((node) => {
    if (!node.material) return;
    if (node.material.name === "collision") colliding.push(nameOf(node));
    if (!seen.has(node.material.name)) seen.set(node.material.name, `#${node.material.color.getHexString()}`);
  });
  for (const [name, colour] of seen) {
    const swatch = element("span", { className: "swatch" });
    swatch.style.background = colour;
    $("legend").append(element("li", {}, swatch, name === "collision" ? ` collides: ${colliding.join(", ")}` : ` ${name}`));
  }
}

/// Which try of the run is seen, where it had more than one.
function addShown(words) {
  if (!words) return;
  $("shown-try").textContent = `Shown is the ${words.replace("= -", "= \u2212")}.`;
  $("shown-try").hidden = false;
}

/// The slider and the button; the picture begins with the grasp.
function addMotion(view, clip) {
  const mixer = new AnimationMixer(view.model);
  const action = mixer.clipAction(clip);
  action.setLoop(LoopOnce, 1);
  action.clampWhenFinished = true;
  action.play();
  action.paused = true;
  const slider = $("time"), button = $("play");
  slider.max = String(clip.duration);
  let playing = false, before = 0;
  const show = (time) => {
    action.time = time;
    mixer.update(0);
    slider.value = String(time);
    slider.ariaValueText = `${time.toFixed(2)} of ${clip.duration.toFixed(2)} seconds`;
    view.draw();
  };
  const set = (on) => {
    playing = on;
    button.textContent = on ? "Pause" : "Play";
    button.ariaPressed = String(on);
  };
  const step = (now) => {
    if (!playing) return;
    const time = Math.min(clip.duration, action.time + (now - before) / 1000);
    before = now;
    show(time);
    if (time >= clip.duration) set(false);
    else requestAnimationFrame(step);
  };
  button.onclick = () => {
    set(!playing);
    if (!playing) return;
    if (action.time >= clip.duration) show(0);
    before = performance.now();
    requestAnimationFrame(step);
  };
  slider.oninput = () => { set(false); show(Number(slider.value)); };
  $("motion").hidden = false;
  show(clip.duration);
}

/// The name of what is pointed at.
function addPointing(view) {
  const caster = new Raycaster();
  let waiting = false;
  view.canvas.addEventListener("pointermove", (event) => {
    if (waiting || event.buttons) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      const frame = view.canvas.getBoundingClientRect();
      const place = new Vector2(((event.clientX - frame.left) / frame.width) * 2 - 1, 1 - ((event.clientY - frame.top) / frame.height) * 2);
      caster.setFromCamera(place, view.camera);
      const hit = caster.intersectObject(view.model, true).find(({ object }) => object.visible && object.parent.visible);
      $("pointed").textContent = hit ? nameOf(hit.object) : "";
    });
  });
}

export async function showScene(buffer, report) {
  const gltf = await new GLTFLoader().parseAsync(buffer, "");
  const extras = gltf.asset.extras ?? {};
  const view = new View(gltf.scene, extras.try === 2 ? report.second_try.result : report.result);
  addShown(extras.shown);
  addToggles(view);
  addLegend(view.model);
  addPointing(view);
  $("reset").onclick = () => view.reset();
  if (gltf.animations.length) addMotion(view, gltf.animations[0]);
  view.draw();
}
