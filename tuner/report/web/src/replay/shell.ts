// The material of a bubble. It is nearly transparent in the middle and denser at its rim, so that things
// inside stay visible.
import { Color, ShaderMaterial } from "three";

const VERTEX = `
varying vec3 normalSeen;
varying vec3 toEye;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  normalSeen = normalize(normalMatrix * normal);
  toEye = normalize(-seen.xyz);
  gl_Position = projectionMatrix * seen;
}`;

const FRAGMENT = `
uniform vec3 colour;
varying vec3 normalSeen;
varying vec3 toEye;
void main() {
  float rim = 1.0 - abs(dot(normalize(normalSeen), normalize(toEye)));
  gl_FragColor = vec4(colour, 0.07 + 0.5 * rim * rim * rim);
  #include <colorspace_fragment>
}`;

export function shellMaterial(colour: string): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { colour: { value: new Color(colour) } },
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    transparent: true,
    depthWrite: false,
  });
}
