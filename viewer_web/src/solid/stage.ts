import {
  DoubleSide,
  Group,
  LessEqualDepth,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import type { Object3D } from 'three';
import type { Frame, Size } from '../picture/frame.js';
import type { Screen } from '../replay/screen.js';
import type { Drawing } from './drawing.js';
import { facesOf, order } from './geometry.js';
import { Ink } from './ink.js';
import type { Space } from './space.js';
import { toViewer, upward } from './turn.js';
import type { Turn } from './turn.js';
import { Wall } from './wall.js';

/** The distance of lines in front of the faces in which they lie. */
const offset = { polygonOffset: true, polygonOffsetFactor: 3, polygonOffsetUnits: 3 };

const see = { vertexColors: true, side: DoubleSide, forceSinglePass: true, transparent: true };

/** The objects that the graphics card draws: polygons, faces and lines. All have y downward. */
export class Stage {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly ink: Ink;
  private readonly wall = new Wall();
  private still = new Group();
  private step = new Group();
  private fitted = '';
  private readonly materials = {
    /** First all faces faintly, whatever is in front of them, */
    behind: new MeshBasicMaterial({ ...see, opacity: 0.3, depthWrite: false }),
    /** then the depths of the nearest faces, */
    depth: new MeshBasicMaterial({ ...see, ...offset, colorWrite: false }),
    /** then only these: so polygons that pierce each other are drawn correctly. */
    front: new MeshBasicMaterial({ ...see, ...offset, opacity: 0.72, depthFunc: LessEqualDepth }),
    glass: new MeshBasicMaterial({ ...see, opacity: 0.22, depthWrite: false }),
  };

  private constructor(
    readonly canvas: HTMLCanvasElement,
    context: WebGL2RenderingContext,
    host: Element,
  ) {
    this.renderer = new WebGLRenderer({ canvas, context });
    this.ink = new Ink(host);
    this.scene.scale.y = -1;
    this.scene.add(this.wall.mesh, this.still, this.step);
  }

  /** Null without WebGL. */
  static on(host: Element): Stage | null {
    const canvas = document.createElement('canvas');
    // The drawing buffer is preserved, because a printer takes the canvas as it is, and would find it empty.
    const context = canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
    return context && new Stage(canvas, context, host);
  }

  /** Sets the polygons, and everything else that does not change from step to step. */
  setStill(drawing: Drawing, space: Space): void {
    const { materials } = this;
    const geometry = facesOf(drawing.faces);
    const faces = (['behind', 'depth', 'front'] as const).map((each) => {
      const mesh = new Mesh(geometry, materials[each]);
      mesh.renderOrder = order[each];
      return mesh;
    });
    this.still = this.replaced(this.still, [...faces, ...this.ink.lines(drawing.lines)]);
    this.wall.fit(space);
  }

  setStep(drawing: Drawing, screen: Screen): void {
    const glass = new Mesh(facesOf(drawing.faces), this.materials.glass);
    glass.renderOrder = order.glass;
    this.step = this.replaced(this.step, [glass, ...this.ink.lines(drawing.lines)]);
    this.wall.show(screen.picture);
  }

  draw(frame: Frame, turn: Turn, space: Space, ratio: number): void {
    const { renderer, camera } = this;
    if (frame.size.width === 0 || frame.size.height === 0) return;
    this.fit(frame.size, ratio);
    const [left, top, across, down] = frame.shown;
    const far = Math.hypot(...space.size);
    const sides = { left, right: left + across, top: -top, bottom: -top - down };
    Object.assign(camera, { ...sides, near: 0, far: 2 * far });
    camera.position.set(...toViewer(turn)).multiplyScalar(far);
    camera.up.set(...upward(turn));
    camera.lookAt(0, 0, 0);
    camera.updateProjectionMatrix();
    this.ink.scale(frame.scale);
    renderer.render(this.scene, camera);
  }

  /** For the graphics card a canvas of another size is a new one. */
  private fit({ width, height }: Size, ratio: number): void {
    const now = `${width} ${height} ${ratio}`;
    if (now === this.fitted) return;
    this.fitted = now;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  dispose(): void {
    for (const group of [this.still, this.step]) disposeOf(group);
    for (const material of Object.values(this.materials)) material.dispose();
    this.wall.dispose();
    this.ink.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private replaced(old: Group, objects: readonly Object3D[]): Group {
    disposeOf(old);
    const group = new Group().add(...objects);
    this.scene.remove(old).add(group);
    return group;
  }
}

function disposeOf(group: Group): void {
  group.traverse((each) => {
    if (each instanceof Mesh) (each as Mesh).geometry.dispose();
  });
}
