// Canvas, camera and light of the 3D scene. Draws only after a change.
import {
  DirectionalLight,
  HemisphereLight,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Spherical,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { cssColor } from "../theme";

export function hasWebGl(): boolean {
  try {
    return document.createElement("canvas").getContext("webgl2") !== null;
  } catch {
    return false;
  }
}

export class Viewer {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(38, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private readonly sun = new DirectionalLight(0xffffff, 2.2);
  private readonly sky = new HemisphereLight(0xffffff, 0x8a8f98, 1.7);
  private home = { position: new Vector3(2, 2, 2), target: new Vector3() };
  private frame = 0;
  private disposed = false;

  constructor(reach: number) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.shadowMap.enabled = true;
    this.camera.up.set(0, 0, 1);
    this.sun.position.set(reach, -1.5 * reach, 3 * reach);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.bias = -0.0005;
    const lens = this.sun.shadow.camera;
    lens.left = lens.bottom = -1.8 * reach;
    lens.right = lens.top = 1.8 * reach;
    lens.far = 10 * reach;
    this.sky.position.set(0, 0, 1);
    this.scene.add(this.sun, this.sky);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.minDistance = 0.2 * reach;
    this.controls.maxDistance = 8 * reach;
    this.controls.addEventListener("change", () => this.draw());
    // The wheel and a finger moving up or down scroll the page. The wheel zooms only if the canvas has the
    // focus.
    this.controls.enableZoom = false;
    this.canvas.style.touchAction = "pan-y";
    this.canvas.addEventListener("focus", () => (this.controls.enableZoom = true));
    this.canvas.addEventListener("blur", () => (this.controls.enableZoom = false));
    this.canvas.addEventListener("keydown", (event) => this.turnByKey(event));
  }

  add(...objects: Object3D[]): void {
    this.scene.add(...objects);
  }

  look(from: Vector3, at: Vector3): void {
    this.home = { position: from.clone(), target: at.clone() };
    this.reset();
  }

  reset(): void {
    this.camera.position.copy(this.home.position);
    this.controls.target.copy(this.home.target);
    this.controls.update();
    this.draw();
  }

  resize(width: number, height: number): void {
    if (width <= 0 || height <= 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.drawNow();
  }

  /** Draws with the next frame. */
  draw(): void {
    if (this.frame !== 0 || this.disposed) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.drawNow();
    });
  }

  drawNow(): void {
    if (!this.disposed) this.renderer.render(this.scene, this.camera);
  }

  /** Returns the present picture on the background colour of the stage. */
  picture(): HTMLCanvasElement {
    this.drawNow();
    const copy = document.createElement("canvas");
    copy.width = this.canvas.width;
    copy.height = this.canvas.height;
    const context = copy.getContext("2d");
    if (context !== null) {
      context.fillStyle = cssColor("stage");
      context.fillRect(0, 0, copy.width, copy.height);
      context.drawImage(this.canvas, 0, 0);
    }
    return copy;
  }

  dispose(): void {
    this.disposed = true;
    cancelAnimationFrame(this.frame);
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private turnByKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = new Spherical().setFromVector3(this.offset());
    const step = Math.PI / 36;
    if (event.shiftKey && event.key === "ArrowLeft") turn.theta -= step;
    else if (event.shiftKey && event.key === "ArrowRight") turn.theta += step;
    else if (event.shiftKey && event.key === "ArrowUp") turn.phi -= step;
    else if (event.shiftKey && event.key === "ArrowDown") turn.phi += step;
    else if (event.key === "+" || event.key === "=") turn.radius /= 1.15;
    else if (event.key === "-") turn.radius *= 1.15;
    else if (event.key === "0") return this.reset();
    else return;
    event.preventDefault();
    turn.phi = Math.min(Math.max(turn.phi, 0.05), Math.PI - 0.05);
    turn.radius = Math.min(Math.max(turn.radius, this.controls.minDistance), this.controls.maxDistance);
    const moved = new Vector3().setFromSpherical(turn);
    this.camera.position.copy(this.controls.target).add(new Vector3(moved.x, -moved.z, moved.y));
    this.controls.update();
    this.draw();
  }

  /** Returns the vector from the target to the camera, with y up as Spherical expects. */
  private offset(): Vector3 {
    const seen = this.camera.position.clone().sub(this.controls.target);
    return new Vector3(seen.x, seen.z, -seen.y);
  }
}
